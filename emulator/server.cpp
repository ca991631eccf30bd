// SPDX-License-Identifier: MIT
#include "emulator/server.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/timerfd.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace hedgehog::emulator {
namespace {

using device::FileDescriptor;

constexpr std::size_t kLongestLine = 1024;
/// As in TickClock: maximum number of missed ticks to catch up; more are skipped.
constexpr std::uint64_t kCatchUp = 3;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

FileDescriptor make_tick_timer() {
  FileDescriptor timer(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK));
  const itimerspec each{{0, 1'000'000}, {0, 1'000'000}};
  if (timer.get() < 0 || ::timerfd_settime(timer.get(), 0, &each, nullptr) != 0) fail("timerfd");
  return timer;
}

void write_all(int fd, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(fd, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    // The response is dropped if the client does not read it.
    if (n <= 0) return;
    done += static_cast<std::size_t>(n);
  }
}

void write_all(int fd, const Bytes& bytes) {
  write_all(fd, std::string(bytes.begin(), bytes.end()));
}

}  // namespace

FileDescriptor listen_tcp(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos) throw std::runtime_error(address + ": not ADDRESS:PORT");
  std::string host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  addrinfo* found = nullptr;
  if (const int error = ::getaddrinfo(host.c_str(), address.c_str() + colon + 1, &hints, &found))
    throw std::runtime_error(address + ": " + ::gai_strerror(error));
  FileDescriptor socket(::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int yes = 1;
  ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool bound = ::bind(socket.get(), found->ai_addr, found->ai_addrlen) == 0 &&
                     ::listen(socket.get(), 8) == 0;
  const int error = errno;
  ::freeaddrinfo(found);
  errno = error;
  if (!bound) fail(address);
  return socket;
}

int port_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6*>(&address)->sin6_port
                                             : reinterpret_cast<sockaddr_in*>(&address)->sin_port);
}

FileDescriptor listen_unix(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw std::runtime_error(path + ": too long");
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  struct stat old {};
  if (::lstat(path.c_str(), &old) == 0 && S_ISSOCK(old.st_mode)) ::unlink(path.c_str());
  FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const mode_t before = ::umask(0177);
  const bool bound =
      ::bind(socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  ::umask(before);
  if (!bound || ::listen(socket.get(), 8) != 0) fail(path);
  return socket;
}

Server::Server(Hub& hub, FileDescriptor imports, FileDescriptor commands, bool console)
    : hub_(hub), imports_(std::move(imports)), commands_(std::move(commands)) {
  if (console)
    peers_.push_back({FileDescriptor(::dup(STDIN_FILENO)), true, STDOUT_FILENO, {}, false});
}

void Server::accept(const FileDescriptor& listener, bool commands) {
  FileDescriptor socket(::accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC));
  if (socket.get() < 0) return;
  const int yes = 1;
  if (!commands) ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  const int answers = socket.get();
  peers_.push_back({std::move(socket), commands, answers, {}, false});
}

void Server::read(Peer& peer) {
  std::array<char, kLongestLine> chunk;
  // Reads at most the length of an import: the bytes after it belong to the session.
  const std::size_t capacity =
      peer.commands
          ? chunk.size()
          : std::max(kOperationHead + kBusId, peer.received.size() + 1) - peer.received.size();
  const ssize_t got = ::read(peer.socket.get(), chunk.data(), capacity);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (got <= 0) {
    peer.over = true;
    return;
  }
  peer.received.append(chunk.data(), static_cast<std::size_t>(got));
  if (peer.commands)
    run_commands(peer);
  else
    export_to(peer);
}

void Server::run_commands(Peer& peer) {
  std::size_t end = 0;
  while ((end = peer.received.find('\n')) != std::string::npos) {
    const std::string line = peer.received.substr(0, end);
    peer.received.erase(0, end + 1);
    write_all(peer.answers, hub_.execute(line) + "\n");
  }
  if (peer.received.size() > kLongestLine) peer.over = true;
}

void Server::export_to(Peer& peer) {
  if (peer.received.size() < kOperationHead) return;
  const Bytes head(peer.received.begin(), peer.received.end());
  const auto operation = decode_operation(head);
  if (operation == Operation::kList) write_all(peer.answers, encode_list(hub_.exported()));
  if (operation != Operation::kImport) {
    peer.over = true;
    return;
  }
  if (head.size() < kOperationHead + kBusId) return;
  const std::string name = std::string(peer.received.c_str() + kOperationHead);
  const auto device = hub_.importable(name);
  write_all(peer.answers, encode_import(device ? &*device : nullptr));
  if (device) hub_.import(name, std::move(peer.socket));
  peer.over = true;
}

void Server::run(const volatile std::sig_atomic_t& stop) {
  const FileDescriptor tick_timer = make_tick_timer();
  std::vector<pollfd> waited;
  while (stop == 0 && !hub_.over()) {
    waited.clear();
    const auto wait_for = [&waited](int fd, bool capacity = false) {
      waited.push_back({fd, static_cast<short>(capacity ? POLLIN | POLLOUT : POLLIN), 0});
    };
    wait_for(tick_timer.get());
    wait_for(imports_.get());
    wait_for(commands_.get());
    for (const Peer& peer : peers_) wait_for(peer.socket.get());
    hub_.each_session([&](HostSession& session) { wait_for(session.fd(), session.blocked()); });
    if (::poll(waited.data(), waited.size(), -1) < 0) continue;

    std::size_t next = 0;
    const auto is_ready = [&] { return waited[next++].revents != 0; };
    const bool ticked = is_ready();
    const bool importer = is_ready();
    const bool commander = is_ready();
    std::vector<Peer*> readable;
    for (Peer& peer : peers_)
      if (is_ready()) readable.push_back(&peer);
    // Before the tick: data sent by a host in this millisecond is processed in it.
    hub_.each_session([&](HostSession& session) {
      if (is_ready()) session.ready();
    });
    std::uint64_t ticks = 0;
    if (ticked && ::read(tick_timer.get(), &ticks, sizeof ticks) == sizeof ticks)
      for (ticks = std::min(ticks, kCatchUp); ticks > 0; --ticks) hub_.step();
    for (Peer* peer : readable) read(*peer);
    if (importer) accept(imports_, false);
    if (commander) accept(commands_, true);
    peers_.remove_if([](const Peer& peer) { return peer.over; });
    hub_.tidy();
  }
}

}  // namespace hedgehog::emulator
