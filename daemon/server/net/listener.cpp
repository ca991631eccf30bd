// SPDX-License-Identifier: MIT
#include "daemon/server/net/listener.h"

#include <spdlog/spdlog.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "daemon/config/listen_address.h"
#include "daemon/server/net/accepted_socket.h"
#include "daemon/server/net/line/plain_connection.h"
#include "daemon/server/net/line/ring_connection.h"
#include "daemon/server/net/line/tls_connection.h"
#include "daemon/server/net/tcp_acceptor.h"
#include "daemon/server/net/unix_path.h"
#include "daemon/server/session/origin.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

/// Kernel send buffer for a slow reader, limited so that telemetry does not age in it.
constexpr int kSendBufferBytes = 256 * 1024;
/// Beyond `connections.max`, so that many TCP clients cannot block an emergency stop: places for
/// pages, and further ones for the Unix socket.
constexpr std::size_t kMorePages = 8;
constexpr std::size_t kMoreOnUnix = 8;
/// A failing accept is reported once while it continues; after this time without one a further
/// failure is reported again.
constexpr std::chrono::seconds kAcceptEpisode{60};
constexpr std::chrono::milliseconds kAcceptPause{100};

std::size_t places(const Session& session, std::size_t max) {
  const bool unix = session.transport == "unix";
  const bool page = session.transport == "websocket";
  return max + (unix || page ? kMorePages : 0u) + (unix ? kMoreOnUnix : 0u);
}

}  // namespace

Listener::Listener(asio::io_context& io, const config::Config& config)
    : io_(io),
      settings_(config.connections),
      tls_(make_tls_context(config.access)),
      half_open_(std::make_shared<HalfOpen>(io.get_executor())),
      http_settings_(config.http) {}

Listener::~Listener() { remove_own_socket(unix_path_, unix_inode_); }

void Listener::open(const config::Config& config) {
  InheritedSockets inherited;
  for (const config::ListenAddress& address : config.listen.tcp) {
    if (auto listener = open_tcp(address, inherited, "--listen")) {
      addresses_.push_back((address.tls ? "tls://" : "") +
                           endpoint_text(listener->acceptor.local_endpoint()));
      tcp_.push_back(*std::move(listener));
    }
  }
  if (config.http.listen)
    http_ = open_tcp(*config.http.listen, inherited, "http.listen in the configuration");
  if (http_) {
    addresses_.push_back((http_->tls ? "https://" : "http://") +
                         endpoint_text(http_->acceptor.local_endpoint()));
  }
  if (!config.listen.unix_socket.empty())
    open_unix(config.listen.unix_socket, config.access.unix_roles);
  inherited.warn_of_unused();
}

std::optional<Listener::TcpListener> Listener::open_tcp(const config::ListenAddress& wanted,
                                                        InheritedSockets& inherited,
                                                        const char* remedy) {
  if (wanted.tls && tls_ == nullptr)
    throw std::runtime_error(config::to_string(wanted) + ": refused: there is no certificate");
  auto acceptor = open_acceptor(io_, wanted, inherited, remedy);
  if (!acceptor) return std::nullopt;
  return TcpListener{*std::move(acceptor), wanted.tls};
}

void Listener::open_unix(const std::string& path, const access::UnixRoles& roles) {
  unix_ = open_unix_acceptor(io_, path, roles);
  unix_path_ = path;
  unix_inode_ = inode_of(path);
  addresses_.push_back(path);
}

void Listener::start(Server& server) {
  server_ = &server;
  open_ring();
  const auto line = [this](auto socket) {
    Session session = session_with(socket);
    start_session(asio::generic::stream_protocol::socket(std::move(socket)), std::move(session));
  };
  const auto tls_line = [this](Tcp::socket socket) {
    asio::co_spawn(io_, start_tls_session(std::move(socket)), asio::detached);
  };
  for (TcpListener& listener : tcp_)
    if (listener.tls)
      asio::co_spawn(io_, accept(listener.acceptor, tls_line), asio::detached);
    else
      asio::co_spawn(io_, accept(listener.acceptor, line), asio::detached);
  if (unix_) asio::co_spawn(io_, accept(*unix_, line), asio::detached);
  if (!http_) return;
  http_endpoint_.emplace(HttpEndpoint{
      Website(server, http_settings_.pages, http_settings_.allow_origins), server, settings_,
      [this](Tcp::socket& socket, bool tls) -> std::optional<Session> {
        Session session = session_with(socket, "websocket");
        session.locked = tls;
        if (tls ? closing_ : !has_capacity(session))
          return std::nullopt;  // `half_open_` bounds TLS
        return session;
      },
      [this](const std::shared_ptr<Connection>& connection) { enter(connection); }});
  asio::co_spawn(io_,
                 accept(http_->acceptor,
                        [this](Tcp::socket socket) {
                          if (http_->tls)
                            start_https(std::move(socket));
                          else
                            start_http(std::move(socket));
                        }),
                 asio::detached);
}

template <class AnyAcceptor, class OnAccept>
asio::awaitable<void> Listener::accept(AnyAcceptor& acceptor, OnAccept on_accept) {
  while (acceptor.is_open()) {
    error_code ec;
    auto socket = co_await acceptor.async_accept(asio::redirect_error(asio::use_awaitable, ec));
    if (!ec && !is_reset(socket)) {
      error_code ignored;
      socket.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
      on_accept(std::move(socket));
    } else if (ec && acceptor.is_open()) {
      report_accept_failure(ec);
      asio::steady_timer pause(io_, kAcceptPause);
      co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ec));
    }
  }
}

void Listener::report_accept_failure(const error_code& error) {
  const auto now = std::chrono::steady_clock::now();
  const bool same_episode = accept_failed_at_ && now - *accept_failed_at_ < kAcceptEpisode;
  accept_failed_at_ = now;
  if (same_episode) return;
  spdlog::warn(
      "cannot accept clients: {}; those that are connected are served, new ones are accepted again "
      "when descriptors are free",
      error.message());
}

template <class AnySocket>
Session Listener::session_with(AnySocket& socket, const char* transport) const {
  Session session = session_of(socket);
  if (transport != nullptr) session.transport = transport;
  server_->tokens().admit(session);
  session.batch_bytes = settings_.queue_bytes / 2;
  return session;
}

bool Listener::has_capacity(const Session& session) {
  if (closing_) return false;
  const auto here = server_->connections();
  if (here < places(session, settings_.max)) return true;
  ++server_->counters().rejected["cap"];
  spdlog::warn("client from {} rejected: {} are connected already", origin_text(session), here);
  return false;
}

void Listener::open_ring() {
  if (settings_.io_uring_after >= settings_.max || ring_) return;
  std::string reason;
  ring_ = Ring::open(io_, reason);
  if (!ring_) spdlog::info("io_uring is not used: {}", reason);
}

void Listener::start_session(asio::generic::stream_protocol::socket socket, Session session) {
  HalfOpen::Ticket ticket;
  if (session.locked && !closing_) {
    const std::string from = session.peer ? user_text(*session.peer) : session.transport;
    ticket = half_open_->enter(socket.native_handle(), from);
  } else if (!has_capacity(session)) {
    const std::string line =
        protocol::encode_error({}, protocol::busy("too many clients are connected", 1000)) + "\n";
    error_code ignored;
    socket.non_blocking(true, ignored);
    socket.send(asio::buffer(line), 0, ignored);
    return;
  }
  std::shared_ptr<Connection> connection;
  if (ring_ && server_->connections() >= settings_.io_uring_after) {
    connection = std::make_shared<RingConnection>(std::move(socket), *ring_, *server_,
                                                  std::move(session), settings_);
  } else {
    connection = std::make_shared<PlainConnection>(std::move(socket), *server_, std::move(session),
                                                   settings_);
  }
  connection->set_half_open(std::move(ticket));
  enter(connection);
  connection->start();
}

void Listener::start_http(Tcp::socket socket) {
  HttpPlace place = http_endpoint_->place();
  if (!place) return;
  asio::co_spawn(io_, serve_http(std::move(socket), *http_endpoint_, std::move(place)),
                 asio::detached);
}

HalfOpen::Ticket Listener::half_open(Tcp::socket& socket) {
  error_code ignored;
  return half_open_->enter(socket.native_handle(), endpoint_text(socket.remote_endpoint(ignored)));
}

asio::awaitable<void> Listener::start_tls_session(Tcp::socket socket) {
  Session session = session_with(socket);
  session.locked = true;
  TlsConnection::Stream stream(std::move(socket), *tls_);
  HalfOpen::Ticket ticket = half_open(stream.next_layer());  // released before its socket
  error_code ec;
  co_await stream.async_handshake(asio::ssl::stream_base::server,
                                  asio::redirect_error(asio::use_awaitable, ec));
  if (ec) ++server_->counters().rejected["tls"];
  if (ec || closing_) co_return;
  const auto connection =
      std::make_shared<TlsConnection>(std::move(stream), *server_, std::move(session), settings_);
  connection->set_half_open(std::move(ticket));
  enter(connection);
  connection->start();
}

void Listener::start_https(Tcp::socket socket) {
  HalfOpen::Ticket ticket = half_open(socket);
  asio::co_spawn(io_, serve_https(std::move(socket), *http_endpoint_, tls_, std::move(ticket)),
                 asio::detached);
}

void Listener::set_config(const config::Config& config) {
  settings_ = config.connections;
  open_ring();
  if (!set_unix_mode(unix_path_, unix_inode_, config.access.unix_roles))
    spdlog::error("{}: its mode cannot be changed", unix_path_);
  try {
    // If no certificate is needed any more, listeners keep the previous one.
    if (TlsContext fresh = make_tls_context(config.access)) tls_ = std::move(fresh);
  } catch (const std::exception& e) {
    spdlog::error("the new certificate cannot be used; the old one remains in effect: {}",
                  e.what());
  }
}

void Listener::enter(const std::shared_ptr<Connection>& connection) {
  connections_.remove_if([](const auto& c) { return c.expired(); });
  connections_.push_back(connection);
}

void Listener::close() {
  closing_ = true;
  error_code ignored;
  for (TcpListener& listener : tcp_) listener.acceptor.close(ignored);
  if (http_) http_->acceptor.close(ignored);
  if (unix_) unix_->close(ignored);
  remove_own_socket(unix_path_, unix_inode_);
  for (const auto& weak : connections_)
    if (const auto connection = weak.lock()) connection->finish();
}

bool Listener::empty() const noexcept {
  for (const auto& weak : connections_)
    if (!weak.expired()) return false;
  return true;
}

}  // namespace hedgehog::server
