// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/process_usage.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace hedgehog::server {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double cpu_s() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::optional<double> open_fds() {
  std::error_code ec;
  std::filesystem::directory_iterator at("/proc/self/fd", ec);
  if (ec) return std::nullopt;
  double count = -1.0;  // the descriptor that reads the folder
  for (const std::filesystem::directory_iterator end; !ec && at != end; at.increment(ec)) ++count;
  return count;
}

std::optional<double> max_fds() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::nullopt;
  return static_cast<double>(limit.rlim_cur);
}

/// Boot time of the machine, seconds since 1970.
double boot_time_s() {
  const auto seconds = [](clockid_t clock) {
    timespec time{};
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  return seconds(CLOCK_REALTIME) - seconds(CLOCK_BOOTTIME);
}

/// proc(5), /proc/pid/stat: threads, start time, memory.
void read_stat(ProcessUsage& usage) {
  constexpr std::size_t kThreads = 20;
  constexpr std::size_t kStartTime = 22;
  constexpr std::size_t kVirtualBytes = 23;
  constexpr std::size_t kResidentPages = 24;
  std::ifstream file("/proc/self/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  // The program name, in brackets, may contain any character.
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return;
  std::istringstream parts(text.substr(name_end + 1));
  std::string part;
  for (std::size_t field = 3; field <= kResidentPages && parts >> part; ++field) {
    const auto value = [&] { return std::strtod(part.c_str(), nullptr); };
    if (field == kThreads) usage.threads = value();
    if (field == kVirtualBytes) usage.virtual_memory_bytes = value();
    if (field == kResidentPages)
      usage.resident_memory_bytes = value() * static_cast<double>(::sysconf(_SC_PAGESIZE));
    if (field != kStartTime) continue;
    usage.start_time_s = boot_time_s() + value() / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }
}

}  // namespace

ProcessUsage process_usage() {
  ProcessUsage usage{.cpu_s = cpu_s(), .open_fds = open_fds(), .max_fds = max_fds()};
  read_stat(usage);
  return usage;
}

}  // namespace hedgehog::server
