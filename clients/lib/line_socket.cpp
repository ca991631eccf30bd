// SPDX-License-Identifier: MIT
#include "clients/lib/line_socket.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio.hpp>
#include <boost/asio/ssl/error.hpp>
#include <cerrno>
#include <ctime>
#include <utility>
#include <vector>

#include "clients/lib/tls_stream.h"

namespace hedgehog::client {

namespace asio = boost::asio;
using boost::system::error_code;
using Stream = asio::generic::stream_protocol;

struct LineSocket::Impl {
  asio::io_context io{1};
  Stream::socket socket{io};
  std::optional<TlsStream> tls;  // over `socket`, once that is connected
  std::array<char, 16 * 1024> chunk{};
  std::string buffer;
  std::size_t begin = 0;    // of the incomplete line
  std::size_t scanned = 0;  // no LF before here
  Address address;
  // Of `start_connect`: all endpoints, the index of the current one, and the result of its attempt.
  std::vector<Stream::endpoint> endpoints;
  std::size_t tried = 0;
  std::optional<error_code> attempt;

  struct Finished {
    error_code error = asio::error::timed_out;
    std::size_t bytes = 0;
  };

  /// Runs one operation until it has ended; at `deadline` it is cancelled.
  template <class Start>
  Finished await(Clock::time_point deadline, Start start) {
    Finished finished;
    bool done = false;
    start([&](const error_code& error, std::size_t bytes) {
      done = true;
      finished = {error, bytes};
    });
    io.restart();
    io.run_until(deadline);
    if (!done) {
      // What is ready although the deadline has passed.
      io.restart();
      io.poll();
    }
    if (!done) {
      error_code ignored;
      socket.cancel(ignored);
      io.restart();
      io.run();
      if (finished.error == asio::error::operation_aborted) finished.error = asio::error::timed_out;
    }
    return finished;
  }

  /// Into `chunk`. Without TLS not by Asio, for which a read is a recv that finds nothing, an
  /// epoll_wait, and a recv.
  Finished receive(Clock::time_point deadline) {
    if (tls)
      return await(deadline,
                   [this](auto done) { tls->stream().async_read_some(asio::buffer(chunk), done); });
    for (;;) {
      const auto now = Clock::now();
      const bool is_over = deadline <= now || !wait_until_readable(deadline - now);
      const ssize_t bytes =
          ::recv(socket.native_handle(), chunk.data(), chunk.size(), MSG_DONTWAIT);
      if (bytes > 0) return {{}, static_cast<std::size_t>(bytes)};
      if (bytes == 0) return {asio::error::eof, 0};
      if (errno != EAGAIN && errno != EINTR)
        return {error_code(errno, boost::system::system_category()), 0};
      if (is_over) return {};
    }
  }

  /// False after `time`. May return true too early.
  bool wait_until_readable(Clock::duration time) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
    const timespec timeout{static_cast<std::time_t>(seconds.count()),
                           static_cast<long>((time - seconds).count())};
    pollfd readable{socket.native_handle(), POLLIN, 0};
    return ::ppoll(&readable, 1, &timeout, nullptr) != 0;
  }

  void close() {
    error_code ignored;
    socket.close(ignored);
  }

  /// Starts TLS on a connected socket. `done` receives the result.
  template <class Done>
  void start_handshake(Done done) {
    tls.emplace(socket, address);
    tls->async_handshake(std::move(done));
  }

  /// After TCP: sets the options and does the TLS handshake. Empty: ready; else the error.
  std::string prepare(Clock::time_point deadline) {
    // Small lines must not wait for the acknowledgement of earlier ones.
    error_code error;
    if (address.path.empty()) socket.set_option(asio::ip::tcp::no_delay(true), error);
    if (!address.tls) return {};
    error = await(deadline, [&](auto done) {
              start_handshake([done](const error_code& failed) { done(failed, 0); });
            }).error;
    return error ? "TLS: " + reason_of(error) : tls->verify_problem();
  }

  error_code connect(const Stream::endpoint& endpoint, Clock::time_point deadline) {
    tls.reset();
    close();
    return await(deadline,
                 [&](auto done) {
                   socket.async_connect(endpoint,
                                        [done](const error_code& error) { done(error, 0); });
                 })
        .error;
  }

  void start_attempt() {
    tls.reset();
    close();
    attempt.reset();
    socket.async_connect(endpoints[tried], [this](const error_code& error) { attempt = error; });
  }

  std::optional<std::string> take_line() {
    const std::size_t end = buffer.find('\n', scanned);
    if (end == std::string::npos) {
      scanned = buffer.size();
      return std::nullopt;
    }
    std::string line = buffer.substr(begin, end - begin);
    if (line.ends_with('\r')) line.pop_back();
    begin = scanned = end + 1;
    return line;
  }

  void discard_read_lines() {
    buffer.erase(0, begin);
    scanned -= begin;
    begin = 0;
  }
};

namespace {

/// The endpoints of `address`; empty with an error if its name is unknown or too long.
std::vector<Stream::endpoint> endpoints_of(const Address& address, asio::io_context& io,
                                           error_code& error) {
  std::vector<Stream::endpoint> all;
  if (!address.path.empty()) {
    try {
      all.emplace_back(asio::local::stream_protocol::endpoint(address.path));
    } catch (const boost::system::system_error& too_long) {
      error = too_long.code();
    }
    return all;
  }
  asio::ip::tcp::resolver resolver(io);
  const auto found = resolver.resolve(address.host, std::to_string(address.port), error);
  for (const auto& entry : found) all.emplace_back(entry.endpoint());
  return all;
}

ClientError ended(const error_code& error) {
  if (error == asio::error::eof || error == asio::error::connection_reset ||
      error == asio::error::broken_pipe || error == asio::ssl::error::stream_truncated)
    return {Failure::kClosed, "the daemon closed the connection", {}};
  return {Failure::kClosed, "the connection to the daemon is lost: " + reason_of(error), {}};
}

}  // namespace

LineSocket::LineSocket(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LineSocket::~LineSocket() = default;
LineSocket::LineSocket(LineSocket&&) noexcept = default;
LineSocket& LineSocket::operator=(LineSocket&&) noexcept = default;

Outcome<LineSocket> LineSocket::connect(const Address& address, Clock::time_point deadline) {
  auto impl = std::make_unique<Impl>();
  impl->address = address;
  error_code error;
  std::string why;
  for (const auto& endpoint : endpoints_of(address, impl->io, error)) {
    error = impl->connect(endpoint, deadline);
    why = error ? reason_of(error) : impl->prepare(deadline);
    if (why.empty()) return LineSocket(std::move(impl));
  }
  return ClientError{Failure::kNoDaemon, why.empty() ? reason_of(error) : why, {}};
}

Outcome<LineSocket> LineSocket::start_connect(const Address& address) {
  auto impl = std::make_unique<Impl>();
  impl->address = address;
  error_code error;
  impl->endpoints = endpoints_of(address, impl->io, error);
  if (impl->endpoints.empty()) return ClientError{Failure::kNoDaemon, reason_of(error), {}};
  impl->start_attempt();
  return LineSocket(std::move(impl));
}

Outcome<bool> LineSocket::connected(Clock::time_point deadline) {
  impl_->io.restart();
  impl_->io.poll();
  if (!impl_->attempt) {
    impl_->io.restart();
    impl_->io.run_until(deadline);
  }
  if (!impl_->attempt) return false;
  const error_code error = *impl_->attempt;
  if (!error && impl_->address.tls && !impl_->tls) {
    impl_->attempt.reset();
    impl_->start_handshake(
        [impl = impl_.get()](const error_code& failed) { impl->attempt = failed; });
    return false;
  }
  std::string why = error ? reason_of(error) : std::string();
  if (!error && impl_->tls) why = impl_->tls->verify_problem();
  if (why.empty()) {
    error_code ignored;
    if (impl_->address.path.empty())
      impl_->socket.set_option(asio::ip::tcp::no_delay(true), ignored);
    return true;
  }
  if (++impl_->tried == impl_->endpoints.size()) return ClientError{Failure::kNoDaemon, why, {}};
  impl_->start_attempt();
  return false;
}

Outcome<void> LineSocket::write(std::string_view line, Clock::time_point deadline) {
  if (!impl_->socket.is_open()) return ended(asio::error::eof);
  std::string bytes(line);
  bytes += '\n';
  const auto finished = impl_->await(deadline, [&](auto done) {
    if (impl_->tls)
      asio::async_write(impl_->tls->stream(), asio::buffer(bytes), done);
    else
      asio::async_write(impl_->socket, asio::buffer(bytes), done);
  });
  if (!finished.error) return {};
  impl_->close();
  if (finished.error == asio::error::timed_out)
    return ClientError{Failure::kClosed, "the daemon does not read from the connection", {}};
  return ended(finished.error);
}

int LineSocket::descriptor() const noexcept {
  return impl_->socket.is_open() ? impl_->socket.native_handle() : -1;
}

Outcome<std::optional<std::string>> LineSocket::read(Clock::time_point deadline) {
  for (;;) {
    if (auto line = impl_->take_line()) return line;
    impl_->discard_read_lines();
    if (impl_->buffer.size() > kMaxIncomingLine) {
      impl_->close();
      return ClientError{Failure::kProtocol, "the daemon sent a line longer than the limit", {}};
    }
    if (!impl_->socket.is_open()) return ended(asio::error::eof);
    const auto finished = impl_->receive(deadline);
    impl_->buffer.append(impl_->chunk.data(), finished.bytes);
    if (finished.bytes > 0) continue;
    if (finished.error == asio::error::timed_out) return std::optional<std::string>();
    impl_->close();
    return ended(finished.error);
  }
}

}  // namespace hedgehog::client
