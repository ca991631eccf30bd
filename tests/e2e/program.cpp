// SPDX-License-Identifier: MIT
#include "tests/e2e/program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <map>
#include <stdexcept>
#include <thread>

namespace hedgehog::e2e {
namespace {

using Clock = std::chrono::steady_clock;

/// argv and envp, made before the fork: a child of a process with threads may not allocate.
class Words {
 public:
  Words(const Home& home, const std::string& path, std::vector<std::string> arguments,
        const std::vector<std::string>& variables)
      : arguments_(std::move(arguments)) {
    arguments_.insert(arguments_.begin(), path);
    std::map<std::string, std::string> named;
    for (const auto& list : {home.environment(), variables})
      for (const std::string& variable : list)
        named[variable.substr(0, variable.find('='))] = variable;
    for (auto& [name, variable] : named) variables_.push_back(variable);
    for (std::string& word : arguments_) argv_.push_back(word.data());
    for (std::string& variable : variables_) envp_.push_back(variable.data());
    argv_.push_back(nullptr);
    envp_.push_back(nullptr);
  }
  [[noreturn]] void execute() {
    ::execve(argv_[0], argv_.data(), envp_.data());
    ::_exit(127);
  }

 private:
  std::vector<std::string> arguments_;
  std::vector<std::string> variables_;
  std::vector<char*> argv_;
  std::vector<char*> envp_;
};

void end(pid_t pid) {
  if (pid > 0) {
    ::kill(pid, SIGKILL);
    ::waitpid(pid, nullptr, 0);
  }
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

}  // namespace

bool eventually(const std::function<bool()>& done) { return wait_until(done); }

Program::Program(const Home& home, const std::string& path, std::vector<std::string> arguments,
                 const std::vector<std::string>& variables)
    : home_(home) {
  static int count = 0;
  const std::string name = "program-" + std::to_string(++count);
  out_ = name + ".out";
  err_ = name + ".err";
  home.write(out_, "");
  home.write(err_, "");
  const std::string out_path = home.path(out_);
  const std::string err_path = home.path(err_);
  Words words(home, path, std::move(arguments), variables);
  pid_ = ::fork();
  if (pid_ == 0) {
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open(out_path.c_str(), O_WRONLY | O_APPEND), STDOUT_FILENO);
    ::dup2(::open(err_path.c_str(), O_WRONLY | O_APPEND), STDERR_FILENO);
    words.execute();
  }
}

Program::~Program() { end(pid_); }

bool Program::prints(const std::string& text) const {
  return eventually([&] { return out().find(text) != std::string::npos; });
}

Ended Program::wait() {
  int status = 0;
  const bool ended =
      wait_until([&] { return ::waitpid(pid_, &status, WNOHANG) == pid_; }, kLongTimeout);
  if (!ended) end(pid_);
  pid_ = -1;
  return {ended ? exit_code_of(status) : -1, home_.read(out_), home_.read(err_)};
}

TerminalProgram::TerminalProgram(const Home& home, const std::string& path,
                                 std::vector<std::string> arguments,
                                 const std::vector<std::string>& variables) {
  std::vector<std::string> all{"TERM=xterm", "LC_ALL=C.UTF-8"};
  all.insert(all.end(), variables.begin(), variables.end());
  Words words(home, path, std::move(arguments), all);
  winsize size{};
  size.ws_col = 80;
  size.ws_row = 24;
  pid_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
  if (pid_ == 0) words.execute();
  if (pid_ < 0) throw std::runtime_error("no pseudo terminal");
}

TerminalProgram::~TerminalProgram() {
  end(pid_);
  if (terminal_ >= 0) ::close(terminal_);
}

void TerminalProgram::type(const std::string& keys) const {
  if (::write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
    throw std::runtime_error("the terminal takes no keys");
}

void TerminalProgram::resize(int columns, int rows) const {
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = static_cast<unsigned short>(rows);
  if (::ioctl(terminal_, TIOCSWINSZ, &size) != 0) throw std::runtime_error("no such size");
}

bool TerminalProgram::read_more() {
  pollfd waiting{terminal_, POLLIN, 0};
  while (::poll(&waiting, 1, 0) == 1) {
    char bytes[4096];
    const ssize_t count = ::read(terminal_, bytes, sizeof bytes);
    if (count <= 0) return false;
    shown_.append(bytes, static_cast<std::size_t>(count));
  }
  return true;
}

bool TerminalProgram::shows(const std::string& text, std::chrono::seconds timeout) {
  bool found = false;
  wait_until(
      [&] {
        const bool is_open = read_more();
        found = shown_.find(text) != std::string::npos;
        return found || !is_open;
      },
      timeout);
  return found;
}

bool TerminalProgram::is_restored() const {
  termios now{};
  return ::tcgetattr(terminal_, &now) == 0 && (now.c_lflag & ICANON) != 0 &&
         (now.c_lflag & ECHO) != 0;
}

int TerminalProgram::wait() {
  int status = 0;
  const bool ended = wait_until(
      [&] {
        read_more();
        return ::waitpid(pid_, &status, WNOHANG) == pid_;
      },
      kLongTimeout);
  if (!ended) end(pid_);
  pid_ = -1;
  read_more();
  return ended ? exit_code_of(status) : -1;
}

}  // namespace hedgehog::e2e
