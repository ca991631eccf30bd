// SPDX-License-Identifier: MIT
#include "tests/bench/load/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hedgehog::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kOutputTimeoutMs = 60'000;

}  // namespace

Child::Child(std::vector<std::string> words, const std::vector<std::string>& variables)
    : name_(words.at(0)) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe for " + name_);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(127);
    ::dup2(in[0], STDIN_FILENO);
    ::dup2(out[1], STDOUT_FILENO);
    for (const std::string& one : variables) ::putenv(const_cast<char*>(one.c_str()));
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(in[0]);
  ::close(out[1]);
  in_ = in[1];
  out_ = out[0];
  if (pid_ < 0) throw std::runtime_error("cannot start " + name_);
}

Child::~Child() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  if (in_ >= 0) ::close(in_);
  if (out_ >= 0) ::close(out_);
}

std::optional<std::string> Child::line() {
  for (std::size_t end = 0; (end = read_.find('\n')) == read_.npos;) {
    std::array<char, 4096> bytes;
    pollfd readable{out_, POLLIN, 0};
    if (::poll(&readable, 1, kOutputTimeoutMs) != 1) return std::nullopt;
    const ssize_t count = ::read(out_, bytes.data(), bytes.size());
    if (count <= 0) return std::nullopt;
    read_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  const std::size_t end = read_.find('\n');
  std::string found = read_.substr(0, end);
  read_.erase(0, end + 1);
  return found;
}

std::string Child::line_after(std::string_view prefix) {
  while (const auto found = line())
    if (found->starts_with(prefix)) return found->substr(prefix.size());
  throw std::runtime_error(name_ + " printed no line with \"" + std::string(prefix) + "\"");
}

std::string Child::finish() {
  ::close(in_);
  in_ = -1;
  std::string text;
  while (const auto found = line()) text += *found + '\n';
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(name_ + " failed, status " + std::to_string(status));
  return text;
}

double Child::cpu_s() const {
  clockid_t clock{};
  timespec spent{};
  if (::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &spent) != 0)
    throw std::runtime_error(name_ + " has ended");
  return static_cast<double>(spent.tv_sec) + static_cast<double>(spent.tv_nsec) * 1e-9;
}

double Child::cpu_s(std::string_view thread) const {
  double total_s = 0.0;
  for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(pid_) + "/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    double spent_ns = 0.0;
    if (name == thread && std::ifstream(task.path() / "schedstat") >> spent_ns)
      total_s += spent_ns * 1e-9;
  }
  return total_s;
}

double Child::resident_kb() const {
  std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6));
  throw std::runtime_error(name_ + " has ended");
}

std::string installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(std::string(path != nullptr ? path : "") + ":/usr/sbin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (std::string file = folder + "/" + program; ::access(file.c_str(), X_OK) == 0) return file;
  return {};
}

}  // namespace hedgehog::bench
