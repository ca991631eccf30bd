// SPDX-License-Identifier: MIT
#include "tests/e2e/daemon_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "tests/e2e/programs.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;

pid_t spawn(const Home& home, std::vector<std::string> words, const std::string& out,
            const std::string& log, const std::vector<std::string>& variables = {}) {
  home.write(out, "");
  home.write(log, "");
  words.insert(words.begin(), hedgehogd());
  std::vector<std::string> environment = home.environment();
  environment.insert(environment.end(), variables.begin(), variables.end());
  std::vector<char*> argv;
  std::vector<char*> envp;
  argv.reserve(words.size() + 1);
  envp.reserve(environment.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  for (std::string& variable : environment) envp.push_back(variable.data());
  envp.push_back(nullptr);
  const std::string out_path = home.path(out);
  const std::string log_path = home.path(log);
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::dup2(::open(out_path.c_str(), O_WRONLY | O_APPEND), STDOUT_FILENO);
    ::dup2(::open(log_path.c_str(), O_WRONLY | O_APPEND), STDERR_FILENO);
    ::execve(argv[0], argv.data(), envp.data());
    ::_exit(127);
  }
  return pid;
}

int wait_for(pid_t pid) {
  int status = 0;
  const bool ended = wait_until([&] { return ::waitpid(pid, &status, WNOHANG) == pid; });
  if (!ended) {
    ::kill(pid, SIGKILL);
    ::waitpid(pid, &status, 0);
    return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

Home::Home() {
  fs::create_directories(path("config/hedgehog"));
  fs::create_directories(path("run"));
}

std::vector<std::string> Home::environment() const {
  std::vector<std::string> variables{"XDG_RUNTIME_DIR=" + path("run"),
                                     "XDG_STATE_HOME=" + path("state"),
                                     "XDG_CONFIG_HOME=" + path("config"),
                                     "HOME=" + folder_.path(),
                                     "HEDGEHOG_SIMBOARD_TRACE=" + path("trace"),
                                     "HEDGEHOG_PATIENCE_MS=60000",
                                     "LC_ALL=C.UTF-8"};
  for (const char* name : {"PATH", "ASAN_OPTIONS", "TSAN_OPTIONS", "UBSAN_OPTIONS"})
    if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
  return variables;
}

Ended run_daemon(const Home& home, const std::vector<std::string>& arguments) {
  const int code = wait_for(spawn(home, arguments, "once.out", "once.log"));
  return {code, home.read("once.out"), home.read("once.log")};
}

DaemonProcess::DaemonProcess(const Home& home, const std::vector<std::string>& more,
                             const std::vector<std::string>& variables, Backend backend)
    : home_(home) {
  std::vector<std::string> words{"--listen", "127.0.0.1:0"};
  if (backend != Backend::kConfigured) words.emplace_back("--simulate");
  if (backend == Backend::kInStep && std::find(more.begin(), more.end(), "--speed") == more.end())
    words.insert(words.end(), {"--speed", "1"});
  words.insert(words.end(), more.begin(), more.end());
  pid_ = spawn(home, words, "out", "log", variables);
  const std::string tcp = "listening on 127.0.0.1:";
  const std::string local = "listening on /";
  std::string out;
  const bool listens = wait_until([&] {
    out = home.read("out");
    const auto at = out.find(local);
    if (at != std::string::npos && out.find('\n', at) != std::string::npos) return true;
    if (::waitpid(pid_, nullptr, WNOHANG) == pid_) pid_ = -1;
    return pid_ < 0;
  });
  if (!listens || out.find(tcp) == std::string::npos) {
    end();
    throw std::runtime_error("hedgehogd does not start:\n" + log());
  }
  port_ = std::stoi(out.substr(out.find(tcp) + tcp.size()));
  const std::string http = "listening on http://127.0.0.1:";
  if (out.find(http) != std::string::npos)
    http_port_ = std::stoi(out.substr(out.find(http) + http.size()));
  const auto begin = out.find(local) + local.size() - 1;
  socket_ = out.substr(begin, out.find('\n', begin) - begin);
}

DaemonProcess::~DaemonProcess() { end(); }

void DaemonProcess::end() const {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
}

int DaemonProcess::stop(int number) {
  signal(number);
  const int code = wait_for(pid_);
  pid_ = -1;
  return code;
}

bool DaemonProcess::logs(const std::string& text) const {
  return wait_until([&] { return log().find(text) != std::string::npos; });
}

}  // namespace hedgehog::e2e
