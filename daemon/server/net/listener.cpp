// SPDX-License-Identifier: MIT
#include "daemon/server/net/listener.h"

#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "daemon/config/listen_address.h"
#include "daemon/server/net/unix_path.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using Local = asio::local::stream_protocol;

/// What the kernel may hold for a slow reader, so that telemetry does not age there.
constexpr int kSendBufferBytes = 256 * 1024;
/// At once, besides WebSockets; a browser opens up to six.
constexpr int kMaxHttpClients = 64;
/// More than `connections.max`, so that no crowd on TCP keeps anybody from the emergency stop:
/// places for pages, and further ones for the Unix socket.
constexpr std::size_t kMorePages = 8;
constexpr std::size_t kMoreOnUnix = 8;

/// While it goes on, a failing accept is reported once; another one after so long is another
/// episode.
constexpr std::chrono::seconds kAcceptEpisode{60};
constexpr std::chrono::milliseconds kAcceptPause{100};

std::size_t places(const Session& session, std::size_t max) {
  const bool unix = session.transport == "unix";
  const bool page = session.transport == "websocket";
  return max + (unix || page ? kMorePages : 0u) + (unix ? kMoreOnUnix : 0u);
}

std::string text(const Tcp::endpoint& endpoint) {
  return config::to_string({endpoint.address().to_string(), endpoint.port()});
}

/// Reset before it was accepted: there is nobody to serve. Who has only closed may have asked
/// first.
bool is_reset(const Tcp::socket& socket) {
  error_code gone;
  socket.remote_endpoint(gone);
  return gone.failed();
}
bool is_reset(const Local::socket&) { return false; }

Session session_of(Tcp::socket& socket) {
  error_code ignored;
  socket.set_option(Tcp::no_delay(true), ignored);
  Session session;
  session.transport = "tcp";
  session.role = protocol::Role::kPlay;
  const Tcp::endpoint peer = socket.remote_endpoint(ignored);
  session.address = text(peer);
  return session;
}

Session session_of(Local::socket&) {
  Session session;
  session.transport = "unix";
  session.role = protocol::Role::kOperate;
  return session;
}

}  // namespace

Listener::Listener(asio::io_context& io, const config::Config& config)
    : io_(io),
      settings_(config.connections),
      simulated_(config.backend == config::Backend::kSimulator),
      http_settings_(config.http) {}

Listener::~Listener() { remove_if_ours(unix_path_, unix_inode_); }

void Listener::open(const config::Config& config) {
  for (const config::ListenAddress& address : config.listen.tcp) {
    if (auto acceptor = open_tcp(address, "--listen")) {
      addresses_.push_back(text(acceptor->local_endpoint()));
      tcp_.push_back(*std::move(acceptor));
    }
  }
  if (config.http.listen) http_ = open_tcp(*config.http.listen, "http.listen in the configuration");
  if (http_) addresses_.push_back("http://" + text(http_->local_endpoint()));
  if (!config.listen.unix_socket.empty()) open_unix(config.listen.unix_socket);
}

std::optional<Tcp::acceptor> Listener::open_tcp(const config::ListenAddress& wanted,
                                                const char* remedy) {
  const std::string name = config::to_string(wanted);
  error_code ec;
  const auto address = asio::ip::make_address(wanted.host, ec);
  if (ec || !address.is_loopback()) {
    throw std::runtime_error(
        name +
        ": refused: other machines could reach it, and there are no tokens and no TLS yet; "
        "use 127.0.0.1 or [::1], and ssh -L from elsewhere");
  }
  Tcp::acceptor acceptor(io_);
  const Tcp::endpoint endpoint(address, wanted.port);
  acceptor.open(endpoint.protocol(), ec);
  if (address.is_v6() && (ec == asio::error::address_family_not_supported)) {
    spdlog::warn("{}: this machine has no IPv6; left out", name);
    return std::nullopt;
  }
  if (!ec) acceptor.set_option(Tcp::acceptor::reuse_address(true), ec);
  if (!ec && address.is_v6()) acceptor.set_option(asio::ip::v6_only(true), ec);
  if (!ec) acceptor.bind(endpoint, ec);
  if (address.is_v6() && ec == boost::system::errc::address_not_available) {
    spdlog::warn("{}: this machine has no IPv6 loopback; left out", name);
    return std::nullopt;
  }
  if (!ec) acceptor.listen(asio::socket_base::max_listen_connections, ec);
  if (ec == asio::error::address_in_use) {
    throw std::runtime_error(name +
                             ": something listens there already, another hedgehogd perhaps; "
                             "end it, or take another port with " +
                             remedy);
  }
  if (ec) throw std::runtime_error(name + ": " + ec.message());
  return acceptor;
}

void Listener::open_unix(const std::string& path) {
  make_room_for_socket(path);
  const mode_t before = ::umask(0117);  // 0660 from its first moment
  unix_.emplace(io_);
  error_code ec;
  unix_->open(Local(), ec);
  if (!ec) unix_->bind(Local::endpoint(path), ec);
  ::umask(before);
  if (!ec) {
    unix_path_ = path;
    unix_inode_ = inode_of(path);
    unix_->listen(asio::socket_base::max_listen_connections, ec);
  }
  if (ec) throw std::runtime_error(path + ": " + ec.message());
  addresses_.push_back(path);
}

void Listener::start(Server& server) {
  server_ = &server;
  const auto line = [this](auto socket) {
    Session session = session_with(socket);
    let_in(LineConnection::Socket(std::move(socket)), std::move(session));
  };
  for (Tcp::acceptor& acceptor : tcp_) asio::co_spawn(io_, accept(acceptor, line), asio::detached);
  if (unix_) asio::co_spawn(io_, accept(*unix_, line), asio::detached);
  if (!http_) return;
  http_endpoint_.emplace(HttpEndpoint{
      Website(server, http_settings_.pages, http_settings_.allow_origins), server, settings_,
      [this](Tcp::socket& socket) -> std::optional<Session> {
        Session session = session_with(socket);
        session.transport = "websocket";
        return has_capacity(session) ? std::optional(std::move(session)) : std::nullopt;
      },
      [this](const std::shared_ptr<Connection>& connection) { enter(connection); }});
  asio::co_spawn(io_,
                 accept(*http_, [this](Tcp::socket socket) { let_in_http(std::move(socket)); }),
                 asio::detached);
}

template <class AnyAcceptor, class LetIn>
asio::awaitable<void> Listener::accept(AnyAcceptor& acceptor, LetIn let_in) {
  while (acceptor.is_open()) {
    error_code ec;
    auto socket = co_await acceptor.async_accept(asio::redirect_error(asio::use_awaitable, ec));
    if (!ec && !is_reset(socket)) {
      error_code ignored;
      socket.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
      let_in(std::move(socket));
    } else if (ec && acceptor.is_open()) {
      report_accept_failure(ec);
      asio::steady_timer pause(io_, kAcceptPause);
      co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ec));
    }
  }
}

void Listener::report_accept_failure(const error_code& error) {
  const auto now = std::chrono::steady_clock::now();
  const bool goes_on = accept_failed_at_ && now - *accept_failed_at_ < kAcceptEpisode;
  accept_failed_at_ = now;
  if (goes_on) return;
  spdlog::warn(
      "cannot accept clients: {}; those that are connected are served, new ones are accepted again "
      "when descriptors are free",
      error.message());
}

template <class AnySocket>
Session Listener::session_with(AnySocket& socket) const {
  Session session = session_of(socket);
  // Nobody can be hurt on the simulator: whoever comes may do everything.
  session.role = simulated_ ? protocol::Role::kOperate : session.role;
  session.batch_bytes = settings_.queue_bytes / 2;
  return session;
}

bool Listener::has_capacity(const Session& session) {
  if (closing_) return false;
  const auto here = server_->connections();
  if (here < places(session, settings_.max)) return true;
  ++server_->counters().rejected["cap"];
  spdlog::warn("a client from {} is turned away: {} are connected already",
               session.address.value_or(session.transport), here);
  return false;
}

void Listener::let_in(LineConnection::Socket socket, Session session) {
  if (!has_capacity(session)) {
    const std::string line =
        protocol::encode_error({}, protocol::busy("too many clients are connected", 1000)) + "\n";
    error_code ignored;
    socket.non_blocking(true, ignored);
    socket.send(asio::buffer(line), 0, ignored);
    return;
  }
  const auto connection =
      std::make_shared<LineConnection>(std::move(socket), *server_, std::move(session), settings_);
  enter(connection);
  connection->start();
}

void Listener::let_in_http(Tcp::socket socket) {
  if (http_clients_ >= kMaxHttpClients) {
    ++server_->counters().rejected["cap"];
    return;
  }
  ++http_clients_;
  asio::co_spawn(io_, serve_http(std::move(socket), *http_endpoint_),
                 [this](const std::exception_ptr&) { --http_clients_; });
}

void Listener::enter(const std::shared_ptr<Connection>& connection) {
  connections_.remove_if([](const auto& c) { return c.expired(); });
  connections_.push_back(connection);
}

void Listener::close() {
  closing_ = true;
  error_code ignored;
  for (Tcp::acceptor& acceptor : tcp_) acceptor.close(ignored);
  if (http_) http_->close(ignored);
  if (unix_) unix_->close(ignored);
  remove_if_ours(unix_path_, unix_inode_);
  for (const auto& weak : connections_)
    if (const auto connection = weak.lock()) connection->finish();
}

bool Listener::empty() const noexcept {
  for (const auto& weak : connections_)
    if (!weak.expired()) return false;
  return true;
}

}  // namespace hedgehog::server
