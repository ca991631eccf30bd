// SPDX-License-Identifier: MIT
#include "tests/vm/bench.h"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tests/e2e/programs.h"
#include "tests/folders.h"
#include "tests/vm/hardware_priority.h"

namespace hedgehog::vm {
namespace {

namespace fs = std::filesystem;
using e2e::hedgehog_usbip;
using e2e::hedgehogd;

constexpr double kMinuteMs = 60'000;
constexpr double kFastPollMs = 1'000;
constexpr int kSlowPollMs = 50;

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  all.reserve(words.size() + 1);
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

/// False: the user does not exist, or this process is not root.
bool become(const std::string& user) {
  const passwd* account = ::getpwnam(user.c_str());
  return account != nullptr && ::initgroups(user.c_str(), account->pw_gid) == 0 &&
         ::setgid(account->pw_gid) == 0 && ::setuid(account->pw_uid) == 0;
}

std::vector<std::string>& figures() {
  static std::vector<std::string> lines;
  return lines;
}

class Table : public testing::Environment {
 public:
  void TearDown() override {
    std::puts("\nfigures (time as the guest counts it)");
    for (const std::string& line : figures()) std::puts(line.c_str());
  }
};
[[maybe_unused]] const testing::Environment* const kTable =
    testing::AddGlobalTestEnvironment(new Table);

int connect_to(const std::string& path) {
  const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  if (::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) return fd;
  ::close(fd);
  return -1;
}

}  // namespace

double now_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void pause_ms(int milliseconds) { ::usleep(static_cast<useconds_t>(1000 * milliseconds)); }

bool eventually(const std::function<bool()>& done, int poll_ms, int minutes) {
  const double from = now_ms();
  while (!done()) {
    const double waited = now_ms() - from;
    if (waited > minutes * kMinuteMs) return false;
    pause_ms(waited < kFastPollMs ? poll_ms : std::max(poll_ms, kSlowPollMs));
  }
  return true;
}

std::string shell(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string text;
  char chunk[4096];
  for (std::size_t n = 0; (n = std::fread(chunk, 1, sizeof chunk, pipe)) > 0;)
    text.append(chunk, n);
  ::pclose(pipe);
  return text;
}

void open_programs_to_all_users() {
  constexpr const char* kOpen = "/run/hedgehog-test";
  const char* programs = std::getenv("HEDGEHOG_PROGRAMS");
  const std::string folder = programs != nullptr ? programs : build_folder();
  if (folder == kOpen) return;
  shell("mkdir -p " + std::string(kOpen) + " && mount --bind " + folder + " " + kOpen);
  ::setenv("HEDGEHOG_PROGRAMS", kOpen, 1);
}

void figure(const std::string& what, double value, const std::string& unit) {
  std::array<char, 120> line;
  std::snprintf(line.data(), line.size(), "  %-58s %9.1f %s", what.c_str(), value, unit.c_str());
  figures().emplace_back(line.data());
}

Child::Child(const std::vector<std::string>& words, const std::vector<std::string>& environment,
             const std::string& log, const std::string& user) {
  std::vector<std::string> arguments = words;
  std::vector<std::string> variables = environment;
  const auto argv = pointers(arguments);
  const auto envp = pointers(variables);
  pid_ = ::fork();
  if (pid_ != 0) return;
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  if (!user.empty() && !become(user)) ::_exit(126);
  ::execve(argv[0], argv.data(), envp.data());
  ::_exit(127);
}

Child::~Child() {
  if (pid_ > 0) stop(SIGKILL);
}

bool Child::ended() {
  if (pid_ > 0 && ::waitpid(pid_, nullptr, WNOHANG) == pid_) pid_ = -1;
  return pid_ < 0;
}

int Child::stop(int signal) {
  ::kill(pid_, signal);
  int status = 0;
  const pid_t pid = std::exchange(pid_, -1);
  if (!eventually([&] { return ::waitpid(pid, &status, WNOHANG) == pid; })) {
    ::kill(pid, SIGKILL);
    ::waitpid(pid, &status, 0);
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

Emulator::Emulator(const Home& home, std::vector<std::string> devices) : home_(home) {
  std::vector<std::string> words{hedgehog_usbip(), "--vhci", "--control", home.path("control")};
  words.insert(words.end(), devices.begin(), devices.end());
  child_ = std::make_unique<Child>(words, home.environment(), home.path("emulator"));
  const bool listens = eventually([&] {
    const int fd = connect_to(home_.path("control"));
    if (fd >= 0) ::close(fd);
    return fd >= 0 || child_->ended();
  });
  if (!listens || child_->ended())
    throw std::runtime_error("hedgehog-usbip does not start: " + home_.read("emulator"));
  run_hardware_first(child_->pid());
}

std::string Emulator::execute(const std::string& command) const {
  const int fd = connect_to(home_.path("control"));
  const std::string line = command + "\n";
  std::string response;
  if (fd >= 0 && ::send(fd, line.data(), line.size(), MSG_NOSIGNAL) > 0) {
    char chunk[1024];
    while (response.find('\n') == std::string::npos) {
      const auto n = ::recv(fd, chunk, sizeof chunk, 0);
      if (n <= 0) break;
      response.append(chunk, static_cast<std::size_t>(n));
    }
    if (response.ends_with('\n')) response.pop_back();
  }
  ::close(fd);
  if (command.starts_with("plug ")) run_hardware_first(child_->pid());
  return response;
}

void Emulator::quit() {
  ok("quit");
  EXPECT_TRUE(eventually([&] { return child_->ended(); })) << home_.read("emulator");
}

double Emulator::current_a() const {
  double sum = 0.0;
  const Json board = status("board");
  for (const double one : board["current_a"]) sum += one * one;
  return std::sqrt(sum);
}

Json Emulator::last(const std::string& event) const {
  std::istringstream lines(home_.read("trace"));
  Json found;
  for (std::string line; std::getline(lines, line);) {
    const Json one = Json::parse(line);
    if (one["event"] == event) found = one;
  }
  return found;
}

Daemon::Daemon(const Home& home, const std::string& user, const std::vector<std::string>& variables)
    : home_(home) {
  home.write("log", "");
  if (!user.empty()) shell("chown -R " + user + ": " + home.path(""));
  std::vector<std::string> environment = home.environment();
  environment.insert(environment.end(), variables.begin(), variables.end());
  child_ = std::make_unique<Child>(std::vector<std::string>{hedgehogd(), "--listen", "127.0.0.1:0"},
                                   environment, home.path("log"), user);
  const std::string socket = home.path("run/hedgehog/hedgehogd.sock");
  const bool listens = eventually([&] {
    const int fd = connect_to(socket);
    if (fd >= 0) ::close(fd);
    return fd >= 0 || child_->ended();
  });
  if (!listens || child_->ended()) throw std::runtime_error("hedgehogd does not start:\n" + log());
  client_ = std::make_unique<RawClient>(socket);
}

bool Daemon::logs(const std::string& text) const {
  return eventually([&] { return log().find(text) != std::string::npos; });
}

void Daemon::arm() {
  Json response;
  const bool armed = eventually([&] {
    response = call("device.arm");
    return state() == "armed";
  });
  ASSERT_TRUE(armed) << response << status();
}

double Daemon::pulse(const Emulator& emulator, double current_a, int duration_ms) {
  emulator.status("board");  // resets the peak
  call("events.subscribe");
  const Json admitted =
      call("effect.pulse",
           {{"direction", "up"}, {"current_a", current_a}, {"duration_ms", duration_ms}});
  EXPECT_TRUE(admitted.value("accepted", false)) << admitted;
  if (!admitted.value("accepted", false)) return 0.0;
  EXPECT_EQ(client_->notification("event", "effect_ended")["reason"], "completed");
  return emulator.status("board")["peak_a"];
}

int Daemon::descriptors() const {
  const fs::directory_iterator all("/proc/" + std::to_string(child_->pid()) + "/fd");
  return static_cast<int>(std::distance(begin(all), end(all)));
}

int Daemon::memory_kib() const {
  std::ifstream in("/proc/" + std::to_string(child_->pid()) + "/smaps_rollup");
  constexpr std::string_view kOwn = "Anonymous:";
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kOwn)) return std::stoi(line.substr(kOwn.size()));
  return 0;
}

double Daemon::cpu_ms() const {
  clockid_t clock = 0;
  timespec used{};
  EXPECT_EQ(::clock_getcpuclockid(child_->pid(), &clock), 0);
  EXPECT_EQ(::clock_gettime(clock, &used), 0);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

Bench::Bench(std::vector<std::string> devices) {
  for (std::string& device : devices)
    if (device.starts_with("board,") || device.starts_with("firmware-board,"))
      device += ",trace=" + home_.path("trace");
  emulator_.emplace(home_, std::move(devices));
}

void Bench::configure(const Json& more) const {
  Json all{{"backend", "usb"}};
  all.update(more);
  home_.configure(all.dump());
}

}  // namespace hedgehog::vm
