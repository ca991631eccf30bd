// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/http_connection.h"

#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>

#include "base/spelling.h"
#include "daemon/server/net/http/http_stream.h"
#include "daemon/server/net/http/websocket_connection.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;
constexpr std::uint64_t kMaxBodyBytes = 1024;
constexpr std::chrono::seconds kTimeout{30};
constexpr std::chrono::seconds kDiskTimeout{5};
constexpr std::chrono::milliseconds kDiskPause{5};
constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "font-src 'self'; connect-src 'self'; manifest-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

/// The token of `Authorization: Bearer TOKEN`.
std::optional<std::string> bearer_token(const UpgradeRequest& request) {
  constexpr std::string_view kScheme = "bearer ";
  const auto found = request.find(http::field::authorization);
  if (found == request.end()) return std::nullopt;
  const std::string value(found->value());
  if (base::lower_case(value.substr(0, kScheme.size())) != kScheme) return std::nullopt;
  const std::size_t begin = value.find_first_not_of(' ', kScheme.size());
  return begin == std::string::npos ? std::string() : value.substr(begin);
}

HttpRequest value_of(const UpgradeRequest& request) {
  const auto optional = [&](http::field field) -> std::optional<std::string> {
    const auto found = request.find(field);
    if (found == request.end()) return std::nullopt;
    return std::string(found->value());
  };
  HttpRequest value{std::string(request.method_string()), std::string(request.target()), {}};
  if (request.count(http::field::host) == 1) value.host = std::string(request[http::field::host]);
  value.origin = optional(http::field::origin);
  if (request.count(http::field::origin) > 1) value.origin = "";  // matches no page
  value.if_none_match = optional(http::field::if_none_match).value_or("");
  value.accept_encoding = optional(http::field::accept_encoding).value_or("");
  value.fetch_site = std::string(request["Sec-Fetch-Site"]);
  value.fetch_mode = std::string(request["Sec-Fetch-Mode"]);
  value.token = bearer_token(request);
  return value;
}

HttpResponse answer_to(error_code broken) {
  if (broken == http::error::header_limit || broken == http::error::buffer_overflow)
    return http_error(431, "at most 8 KiB of headers");
  if (broken == http::error::body_limit) return http_error(413, "no body is needed here");
  return http_error(400, "this is no HTTP request");
}

void fill(http::fields& fields, const HttpResponse& answer) {
  fields.set(http::field::server, "hedgehogd");
  fields.set(http::field::content_type, answer.type);
  fields.set(http::field::cache_control, answer.cache_control);
  if (!answer.etag.empty()) fields.set(http::field::etag, answer.etag);
  if (!answer.encoding.empty()) fields.set(http::field::content_encoding, answer.encoding);
  if (!answer.vary.empty()) fields.set(http::field::vary, answer.vary);
  if (!answer.filename.empty()) {
    fields.set(http::field::content_disposition,
               "attachment; filename=\"" + answer.filename + "\"");
  }
  if (!answer.challenge.empty()) fields.set(http::field::www_authenticate, answer.challenge);
  if (answer.allow) fields.set(http::field::allow, *answer.allow);
  fields.set("Content-Security-Policy", kContentPolicy);
  fields.set("Cross-Origin-Opener-Policy", "same-origin");
  fields.set("Cross-Origin-Resource-Policy", "same-origin");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set("X-Content-Type-Options", "nosniff");
}

/// `head`: without the body.
asio::awaitable<bool> send(HttpStream& stream, const HttpResponse& answer, bool head,
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

/// For a client that takes at least 32 KiB in a second.
std::chrono::seconds response_timeout(const HttpResponse& answer) {
  constexpr std::size_t kBytesPerSecond = 32 * 1024;
  const std::size_t bytes = answer.body ? answer.body->size() : 0;
  return kTimeout + std::chrono::seconds(bytes / kBytesPerSecond);
}

/// Waits for the disk; an unreadable file or a timeout becomes an error.
asio::awaitable<void> complete(HttpStream& stream, HttpResponse& answer) {
  const auto pending = std::exchange(answer.pending, nullptr);
  asio::steady_timer pause(stream.get_executor());
  const auto until = std::chrono::steady_clock::now() + kDiskTimeout;
  auto body = pending();
  for (; body == nullptr; body = pending()) {
    if (std::chrono::steady_clock::now() > until) {
      answer = http_error(503, "the disk is slow; retry later");
      co_return;
    }
    error_code ignored;
    pause.expires_after(kDiskPause);
    co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
  }
  if (body->empty())
    answer = http_error(404, "the recording no longer exists");
  else
    answer.body = std::move(body);
}

std::string address_of(HttpStream& stream) {
  error_code gone;
  const auto peer = stream.socket().remote_endpoint(gone);
  return config::to_string({peer.address().to_string(), peer.port()});
}

/// Serves requests sequentially. Without TLS `ticket` is empty and `place` is not.
asio::awaitable<void> serve(HttpStream given, HttpEndpoint& endpoint, HalfOpen::Ticket given_ticket,
                            HttpPlace given_place) {
  HttpStream stream(std::move(given));
  HttpPlace place(std::move(given_place));
  HalfOpen::Ticket ticket(std::move(given_ticket));  // released before its socket
  beast::flat_buffer buffer(kMaxHeaderBytes + kMaxBodyBytes);
  for (bool open = true; open;) {
    http::request_parser<http::string_body> parser;
    parser.header_limit(kMaxHeaderBytes);
    parser.body_limit(kMaxBodyBytes);
    stream.expires_after(kTimeout);
    error_code ec;
    co_await http::async_read(stream, buffer, parser,
                              asio::redirect_error(asio::use_awaitable, ec));
    const bool is_http =
        ec.category() == http::make_error_code(http::error::end_of_stream).category();
    if (ec == http::error::end_of_stream || (ec && !is_http)) break;
    if (ec) {
      co_await send(stream, answer_to(ec), false, false);
      break;
    }
    UpgradeRequest request = parser.release();
    HttpRequest value = value_of(request);
    value.tls = stream.is_tls();
    if (value.tls) value.address = address_of(stream);
    HttpResponse answer;
    bool close = false;
    if (websocket::is_upgrade(request) && value.path() == "/ws") {
      auto refusal = endpoint.site.refusal(value);
      auto session = refusal ? std::nullopt : endpoint.admit(stream.socket(), value.tls);
      if (session && buffer.size() == 0) refusal = endpoint.site.log_in(*session, value);
      if (session && !refusal && buffer.size() == 0) {
        co_await become_web_socket(std::move(stream), std::move(request), *std::move(session),
                                   endpoint, std::move(ticket));
        co_return;
      }
      answer = refusal   ? *std::move(refusal)
               : session ? http_error(400, "wait for the answer before the first frame")
                         : http_error(503, "too many clients are connected");
    } else {
      answer = endpoint.site.answer(value);
      if (answer.authorized && !place) place = endpoint.place();
      if (place) {
        ticket.release();
      } else if (answer.authorized) {
        answer = http_error(503, "too many clients are connected");
        close = true;
      }
      if (answer.pending) co_await complete(stream, answer);
    }
    stream.expires_after(response_timeout(answer));
    open = co_await send(stream, answer, request.method() == http::verb::head,
                         request.keep_alive() && !close);
  }
  stream.expires_after(HttpStream::kEndTimeout);
  co_await stream.end();
}

}  // namespace

HttpPlace HttpEndpoint::place() {
  if (*clients < kMaxClients) return HttpPlace(clients);
  ++server.counters().rejected["cap"];
  return {};
}

asio::awaitable<void> serve_http(asio::ip::tcp::socket socket, HttpEndpoint& endpoint,
                                 HttpPlace place) {
  return serve(HttpStream(std::move(socket)), endpoint, HalfOpen::Ticket(), std::move(place));
}

asio::awaitable<void> serve_https(asio::ip::tcp::socket socket, HttpEndpoint& endpoint,
                                  TlsContext context, HalfOpen::Ticket given_ticket) {
  HttpStream stream(std::move(socket), context);
  HalfOpen::Ticket ticket(std::move(given_ticket));
  if (co_await stream.handshake()) {
    ++endpoint.server.counters().rejected["tls"];
    co_return;
  }
  co_await serve(std::move(stream), endpoint, std::move(ticket), HttpPlace());
}

}  // namespace hedgehog::server
