// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/http_connection.h"

#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>

#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using Request = http::request<http::string_body>;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;
constexpr std::uint64_t kMaxBodyBytes = 1024;
constexpr std::chrono::seconds kPatience{30};
constexpr std::chrono::seconds kLingerTimeout{1};
constexpr std::chrono::seconds kHandshake{10};
/// A peer that answers no ping for so long is gone.
constexpr std::chrono::seconds kMaxPeerSilence{60};
constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "font-src 'self'; connect-src 'self'; manifest-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

/// One message a frame; the rest is as on TCP.
class WebSocketConnection final : public Connection {
 public:
  using Stream = websocket::stream<beast::tcp_stream>;

  WebSocketConnection(Stream stream, Server& server, Session session, std::size_t queue_bytes)
      : Connection(stream.get_executor(), server, std::move(session), queue_bytes),
        stream_(std::move(stream)) {
    // Beast would tell it only when the client has closed its socket too.
    stream_.control_callback([this](websocket::frame_type kind, beast::string_view) {
      if (kind == websocket::frame_type::close) on_client_close();
    });
  }

 private:
  asio::awaitable<void> read() override;
  asio::awaitable<error_code> send_next(WriteQueue& queue) override;
  asio::awaitable<void> finish_stream() override;
  void close() noexcept override;
  /// One whole message into `buffer_`; of one that is too long nothing is kept. False: the client
  /// has gone, or has to.
  asio::awaitable<bool> read_message();
  asio::awaitable<void> refuse_binary();

  Stream stream_;
  beast::flat_buffer buffer_;
  bool skipping_ = false;
};

asio::awaitable<bool> WebSocketConnection::read_message() {
  buffer_.clear();
  skipping_ = false;
  do {
    error_code ec;
    co_await stream_.async_read_some(buffer_, Connection::kReadBytes,
                                     asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return false;
    if (skipping_) {
      buffer_.clear();
    } else if (buffer_.size() > protocol::kMaxLineBytes) {
      skipping_ = true;
      buffer_.clear();
      begin_turn();
      if (!co_await too_long()) co_return false;
    }
  } while (!stream_.is_message_done());
  co_return true;
}

asio::awaitable<void> WebSocketConnection::read() {
  while (co_await read_message()) {
    if (stream_.got_binary()) {
      co_await refuse_binary();
      co_return;
    }
    if (skipping_) continue;
    begin_turn();
    const asio::const_buffer bytes = buffer_.cdata();
    if (!co_await take({static_cast<const char*>(bytes.data()), bytes.size()})) co_return;
  }
}

asio::awaitable<void> WebSocketConnection::refuse_binary() {
  error_code ignored;
  const websocket::close_reason why(websocket::close_code::unknown_data, "send text frames");
  co_await stream_.async_close(why, asio::redirect_error(asio::use_awaitable, ignored));
}

asio::awaitable<error_code> WebSocketConnection::send_next(WriteQueue& queue) {
  const std::string& line = queue.take_one();
  error_code ec;
  co_await stream_.async_write(asio::buffer(line.data(), line.size() - 1),
                               asio::redirect_error(asio::use_awaitable, ec));
  co_return ec;
}

asio::awaitable<void> WebSocketConnection::finish_stream() {
  if (stream_.is_open()) {
    error_code ignored;
    co_await stream_.async_close(websocket::close_code::going_away,
                                 asio::redirect_error(asio::use_awaitable, ignored));
  }
}

void WebSocketConnection::close() noexcept {
  error_code ignored;
  auto& socket = beast::get_lowest_layer(stream_).socket();
  socket.shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
  socket.close(ignored);
}

HttpRequest value_of(const Request& request) {
  const auto optional = [&](http::field field) -> std::optional<std::string> {
    const auto found = request.find(field);
    if (found == request.end()) return std::nullopt;
    return std::string(found->value());
  };
  HttpRequest value{std::string(request.method_string()), std::string(request.target()), {}};
  if (request.count(http::field::host) == 1) value.host = std::string(request[http::field::host]);
  value.origin = optional(http::field::origin);
  if (request.count(http::field::origin) > 1) value.origin = "";  // nobody's
  value.if_none_match = optional(http::field::if_none_match);
  return value;
}

HttpAnswer answer_to(error_code broken) {
  if (broken == http::error::header_limit || broken == http::error::buffer_overflow)
    return http_error(431, "at most 8 KiB of headers");
  if (broken == http::error::body_limit) return http_error(413, "no body is needed here");
  return http_error(400, "this is no HTTP request");
}

void fill(http::fields& fields, const HttpAnswer& answer) {
  fields.set(http::field::server, "hedgehogd");
  fields.set(http::field::content_type, answer.type);
  fields.set(http::field::cache_control, answer.etag.empty() ? "no-store" : "no-cache");
  if (!answer.etag.empty()) fields.set(http::field::etag, answer.etag);
  if (answer.allow) fields.set(http::field::allow, *answer.allow);
  fields.set("Content-Security-Policy", kContentPolicy);
  fields.set("Cross-Origin-Opener-Policy", "same-origin");
  fields.set("Cross-Origin-Resource-Policy", "same-origin");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set("X-Content-Type-Options", "nosniff");
}

/// `method` HEAD: the same without the body.
asio::awaitable<bool> send(beast::tcp_stream& stream, const HttpAnswer& answer, bool head,
                           bool keep_alive) {
  error_code ec;
  if (head || answer.status == 304) {
    http::response<http::empty_body> response;
    response.result(static_cast<unsigned>(answer.status));
    fill(response, answer);
    if (answer.status != 304) response.content_length(answer.body->size());
    response.keep_alive(keep_alive);
    co_await http::async_write(stream, response, asio::redirect_error(asio::use_awaitable, ec));
  } else {
    http::response<http::span_body<const char>> response;
    response.result(static_cast<unsigned>(answer.status));
    fill(response, answer);
    response.body() = {answer.body->data(), answer.body->size()};
    response.prepare_payload();
    response.keep_alive(keep_alive);
    co_await http::async_write(stream, response, asio::redirect_error(asio::use_awaitable, ec));
  }
  co_return keep_alive && !ec;
}

/// Lets the client read its answer: bytes of its that nobody reads would reset the connection.
asio::awaitable<void> leave(beast::tcp_stream& stream) {
  error_code ec;
  stream.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ec);
  stream.expires_after(kLingerTimeout);
  std::string sink(Connection::kReadBytes, '\0');
  while (!ec) {
    co_await stream.async_read_some(asio::buffer(sink),
                                    asio::redirect_error(asio::use_awaitable, ec));
  }
}

asio::awaitable<void> become_web_socket(beast::tcp_stream stream, Request request, Session session,
                                        HttpEndpoint& endpoint) {
  stream.expires_never();
  WebSocketConnection::Stream upgraded(std::move(stream));
  upgraded.set_option(websocket::stream_base::timeout{kHandshake, kMaxPeerSilence, true});
  // Beast would close the connection over one that is too long; here it is told, as on TCP.
  upgraded.read_message_max(0);
  upgraded.text(true);
  error_code ec;
  co_await upgraded.async_accept(request, asio::redirect_error(asio::use_awaitable, ec));
  if (ec) co_return;
  const auto connection = std::make_shared<WebSocketConnection>(
      std::move(upgraded), endpoint.server, std::move(session), endpoint.queue_bytes);
  endpoint.enter(connection);
  connection->start();
}

}  // namespace

asio::awaitable<void> serve_http(asio::ip::tcp::socket socket, HttpEndpoint& endpoint) {
  beast::tcp_stream stream(std::move(socket));
  beast::flat_buffer buffer(kMaxHeaderBytes + kMaxBodyBytes);
  for (bool open = true; open;) {
    http::request_parser<http::string_body> parser;
    parser.header_limit(kMaxHeaderBytes);
    parser.body_limit(kMaxBodyBytes);
    stream.expires_after(kPatience);
    error_code ec;
    co_await http::async_read(stream, buffer, parser,
                              asio::redirect_error(asio::use_awaitable, ec));
    if (ec == http::error::end_of_stream || ec == beast::error::timeout ||
        (ec && ec.category() == asio::error::get_system_category()))
      break;
    if (ec) {
      co_await send(stream, answer_to(ec), false, false);
      break;
    }
    Request request = parser.release();
    const HttpRequest value = value_of(request);
    HttpAnswer answer;
    if (websocket::is_upgrade(request) && value.path() == "/ws") {
      auto refusal = endpoint.site.refusal(value);
      auto session = refusal ? std::nullopt : endpoint.admit(stream.socket());
      if (session && buffer.size() == 0) {
        co_await become_web_socket(std::move(stream), std::move(request), *std::move(session),
                                   endpoint);
        co_return;
      }
      answer = refusal   ? *std::move(refusal)
               : session ? http_error(400, "wait for the answer before the first frame")
                         : http_error(503, "too many clients are connected");
    } else {
      answer = endpoint.site.answer(value);
    }
    open =
        co_await send(stream, answer, request.method() == http::verb::head, request.keep_alive());
  }
  co_await leave(stream);
}

}  // namespace hedgehog::server
