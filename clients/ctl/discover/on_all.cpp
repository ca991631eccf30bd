// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/on_all.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "clients/common/exit_code.h"
#include "clients/common/interrupts.h"

namespace hedgehog::client {
namespace {

using nlohmann::ordered_json;
using Pipe = std::array<int, 2>;

/// One output of one child: complete lines are printed, the rest is buffered.
struct Stream {
  int descriptor = -1;
  std::size_t daemon = 0;
  bool is_stdout = true;
  std::string rest{};
};

class Children {
 public:
  Children(const std::vector<LocalDaemon>& daemons, bool as_json)
      : daemons_(daemons), as_json_(as_json) {}

  void start(std::size_t index, const std::function<int(const LocalDaemon&)>& verb) {
    Pipe out{-1, -1};
    Pipe err{-1, -1};
    if (::pipe(out.data()) != 0 || ::pipe(err.data()) != 0) return fail(out);
    const pid_t pid = ::fork();
    if (pid < 0) {
      fail(err);
      return fail(out);
    }
    if (pid == 0) {
      ::dup2(out[1], STDOUT_FILENO);
      ::dup2(err[1], STDERR_FILENO);
      // Also those of the other children: a child that continues must not keep their pipes open.
      for (const Stream& stream : streams_) ::close(stream.descriptor);
      for (const int end : {out[0], out[1], err[0], err[1]}) ::close(end);
      std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
      std::exit(guarded(verb, daemons_[index]));
    }
    ::close(out[1]);
    ::close(err[1]);
    pids_.push_back(pid);
    streams_.push_back({out[0], index, true});
    streams_.push_back({err[0], index, false});
  }

  /// Until every child has closed its outputs.
  void forward() {
    bool forwarded = false;
    while (!streams_.empty()) {
      std::vector<pollfd> waiting;
      for (const Stream& stream : streams_) waiting.push_back({stream.descriptor, POLLIN, 0});
      // A signal just before poll does not interrupt it, hence the timeout; children of the
      // terminal receive signals themselves.
      constexpr int kSignalCheckMs = 200;
      ::poll(waiting.data(), waiting.size(), kSignalCheckMs);
      if (interrupted() && !forwarded) {
        forwarded = true;
        for (const pid_t pid : pids_) ::kill(pid, SIGTERM);
      }
      for (std::size_t i = streams_.size(); i-- > 0;)
        if (waiting[i].revents != 0 && !read(streams_[i])) {
          ::close(streams_[i].descriptor);
          streams_.erase(streams_.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
  }

  int wait() {
    for (const pid_t pid : pids_) {
      int status = 0;
      while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
      }
      code_ = std::max(code_, WIFEXITED(status) ? WEXITSTATUS(status) : int{kInternal});
    }
    return code_;
  }

 private:
  static int guarded(const std::function<int(const LocalDaemon&)>& verb,
                     const LocalDaemon& daemon) {
    try {
      return verb(daemon);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "hedgehogctl: %s\n", error.what());
      return kInternal;
    }
  }

  void fail(const Pipe& pipe) {
    for (const int end : pipe)
      if (end >= 0) ::close(end);
    code_ = kInternal;
  }

  /// False at the end of the stream.
  bool read(Stream& stream) {
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(stream.descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) return true;
    if (count > 0) stream.rest.append(bytes.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = stream.rest.find('\n')) != stream.rest.npos;
         stream.rest.erase(0, end + 1))
      print(stream, stream.rest.substr(0, end));
    if (count > 0) return true;
    if (!stream.rest.empty()) print(stream, stream.rest);
    return false;
  }

  void print(const Stream& stream, const std::string& line) const {
    const LocalDaemon& daemon = daemons_[stream.daemon];
    if (as_json_ && stream.is_stdout) {
      const auto response = ordered_json::parse(line, nullptr, false);
      const ordered_json object{
          {"instance", daemon.instance},
          {"address", daemon.socket},
          {"response", response.is_discarded() ? ordered_json(line) : response}};
      std::printf("%s\n",
                  object.dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
    } else {
      std::fprintf(stream.is_stdout ? stdout : stderr, "%s: %s\n", daemon.instance.c_str(),
                   line.c_str());
    }
    std::fflush(stdout);
  }

  const std::vector<LocalDaemon>& daemons_;
  bool as_json_;
  std::vector<pid_t> pids_;
  std::vector<Stream> streams_;
  int code_ = kDone;
};

}  // namespace

int run_on_all(const std::vector<LocalDaemon>& daemons, bool as_json,
               const std::function<int(const LocalDaemon&)>& verb) {
  Children children(daemons, as_json);
  std::fflush(nullptr);
  for (std::size_t i = 0; i < daemons.size(); ++i) children.start(i, verb);
  children.forward();
  return children.wait();
}

}  // namespace hedgehog::client
