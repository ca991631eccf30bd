// SPDX-License-Identifier: MIT
#include "clients/racer/server/hub.h"

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket.hpp>
#include <set>
#include <utility>

#include "clients/racer/server/host_check.h"
#include "clients/racer/server/open_page.h"
#include "clients/racer/server/page_acceptor.h"
#include "clients/racer/server/pages.h"

namespace hedgehog::racer {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using Request = http::request<http::empty_body>;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;
constexpr std::chrono::seconds kTimeout{15};
constexpr std::chrono::seconds kHandshake{5};
/// A page that does not respond to pings for this long is closed.
constexpr std::chrono::seconds kSilence{10};
constexpr std::chrono::milliseconds kCloseFrame{500};
/// Minimum time for the pages, even if the game is late.
constexpr std::chrono::milliseconds kMinWait{1};
/// The kernel's buffer per page is kept small: its content becomes outdated.
constexpr int kSendBufferBytes = 32 * 1024;
constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct Response {
  http::status status;
  std::string_view type;
  std::string_view body;
  base::WebFileResponse file{.cache_control = "no-store"};
};

Response sentence(http::status status, std::string_view text) {
  return {status, "text/plain; charset=utf-8", text};
}

asio::awaitable<bool> send_response(beast::tcp_stream& stream, const Response& answer, bool head,
                                    bool keep_alive) {
  http::response<http::span_body<const char>> response;
  response.result(answer.status);
  response.set(http::field::server, "hedgehog-racer");
  response.set(http::field::content_type, answer.type);
  const base::WebFileResponse& file = answer.file;
  response.set(http::field::cache_control, file.cache_control);
  if (!file.etag.empty()) response.set(http::field::etag, file.etag);
  if (!file.encoding.empty()) response.set(http::field::content_encoding, file.encoding);
  if (!file.vary.empty()) response.set(http::field::vary, file.vary);
  response.set("Content-Security-Policy", kContentPolicy);
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Referrer-Policy", "no-referrer");
  response.set("X-Content-Type-Options", "nosniff");
  if (answer.status == http::status::method_not_allowed)
    response.set(http::field::allow, "GET, HEAD");
  response.body() = {answer.body.data(), answer.body.size()};
  response.prepare_payload();
  response.keep_alive(keep_alive);
  error_code ec;
  if (head) {
    http::response_serializer<http::span_body<const char>> headers(response);
    co_await http::async_write_header(stream, headers,
                                      asio::redirect_error(asio::use_awaitable, ec));
  } else {
    co_await http::async_write(stream, response, asio::redirect_error(asio::use_awaitable, ec));
  }
  co_return keep_alive && !ec;
}

}  // namespace

struct Hub::Impl {
  Impl(const HubSettings& settings, Callbacks given)
      : callbacks(std::move(given)),
        files(read_pages(settings.pages)),
        acceptor(open_acceptor(context, settings)),
        port(acceptor.local_endpoint().port()) {
    asio::co_spawn(context, accept(), asio::detached);
  }

  asio::awaitable<void> accept();
  asio::awaitable<void> serve(Tcp::socket socket);
  asio::awaitable<void> serve_page(beast::tcp_stream stream, Request request);
  asio::awaitable<void> write(std::shared_ptr<OpenPage> page);
  Response answer(const Request& request) const;

  Callbacks callbacks;
  base::WebFiles files;
  std::string first_message;
  // Before the context, whose destructor destroys the coroutines that own the pages.
  std::set<OpenPage*> pages;
  int connections = 0;
  PageId last_id = 0;
  asio::io_context context{1};
  Tcp::acceptor acceptor;
  std::uint16_t port;
};

asio::awaitable<void> Hub::Impl::accept() {
  asio::steady_timer pause(context);
  for (;;) {
    error_code ec;
    Tcp::socket socket =
        co_await acceptor.async_accept(asio::redirect_error(asio::use_awaitable, ec));
    if (!ec && connections < kMaxConnections) {
      error_code ignored;
      socket.set_option(Tcp::no_delay(true), ignored);
      socket.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
      asio::co_spawn(context, serve(std::move(socket)), asio::detached);
    } else if (ec) {
      pause.expires_after(std::chrono::milliseconds{100});  // possibly out of descriptors
      co_await pause.async_wait(asio::use_awaitable);
    }
  }
}

Response Hub::Impl::answer(const Request& request) const {
  const std::string_view target = request.target();
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return sentence(http::status::method_not_allowed, "only GET and HEAD here\n");
  const base::WebFile* file = files.find(std::string(target.substr(0, target.find('?'))));
  if (file != nullptr) {
    const base::WebFileResponse sent = base::web_file_response(
        *file, request[http::field::accept_encoding], request[http::field::if_none_match]);
    if (!sent.body) return {http::status::not_modified, file->type, {}, sent};
    return {http::status::ok, file->type, *sent.body, sent};
  }
  return sentence(http::status::not_found, "there is no such page\n");
}

asio::awaitable<void> Hub::Impl::serve(Tcp::socket socket) {
  const std::shared_ptr<int> here(&++connections, [](int* number) { --*number; });
  beast::tcp_stream stream(std::move(socket));
  beast::flat_buffer buffer(kMaxHeaderBytes);
  for (bool open = true; open;) {
    http::request_parser<http::empty_body> parser;
    parser.header_limit(kMaxHeaderBytes);
    parser.body_limit(0);
    stream.expires_after(kTimeout);
    error_code ec;
    co_await http::async_read(stream, buffer, parser,
                              asio::redirect_error(asio::use_awaitable, ec));
    if (ec) {
      const bool bad = ec.category() == http::make_error_code(http::error::bad_method).category();
      if (bad && ec != http::error::end_of_stream) {
        co_await send_response(
            stream, sentence(http::status::bad_request, "this is no HTTP request for us\n"), false,
            false);
      }
      break;
    }
    Request request = parser.release();
    const std::string_view host =
        request.count(http::field::host) == 1 ? std::string_view(request[http::field::host]) : "";
    const auto origin = request.find(http::field::origin);
    std::optional<std::string_view> from;
    if (origin != request.end()) from = origin->value();
    const bool ws_upgrade = websocket::is_upgrade(request) && request.target() == "/ws";
    Response reply{};
    if (!is_own_host(host)) {
      reply = sentence(http::status::misdirected_request,
                       "that is no name of this machine: use http://127.0.0.1 and this port\n");
    } else if (!may_connect(host, from)) {
      reply = sentence(http::status::forbidden, "pages of other sites may not connect\n");
    } else if (ws_upgrade && pages.size() < static_cast<std::size_t>(kMaxPages)) {
      co_await serve_page(std::move(stream), std::move(request));
      co_return;
    } else if (ws_upgrade) {
      reply = sentence(http::status::service_unavailable, "too many pages are open\n");
    } else {
      reply = answer(request);
    }
    open = co_await send_response(stream, reply, request.method() == http::verb::head,
                                  request.keep_alive());
  }
  error_code ignored;
  stream.socket().shutdown(Tcp::socket::shutdown_send, ignored);
}

asio::awaitable<void> Hub::Impl::serve_page(beast::tcp_stream plain, Request request) {
  plain.expires_never();
  const auto page = std::make_shared<OpenPage>(++last_id, OpenPage::Stream(std::move(plain)));
  page->stream.set_option(websocket::stream_base::timeout{kHandshake, kSilence, true});
  page->stream.read_message_max(kMaxReceivedBytes);
  page->stream.text(true);
  page->stream.auto_fragment(false);
  error_code ec;
  co_await page->stream.async_accept(request, asio::redirect_error(asio::use_awaitable, ec));
  if (ec) co_return;
  pages.insert(page.get());
  if (!first_message.empty()) page->queue(first_message);
  asio::co_spawn(context, write(page), asio::detached);
  beast::flat_buffer received;
  while (page->open) {
    received.clear();
    co_await page->stream.async_read(received, asio::redirect_error(asio::use_awaitable, ec));
    if (ec) break;
    const asio::const_buffer bytes = received.cdata();
    const std::string back =
        callbacks.received(page->id, {static_cast<const char*>(bytes.data()), bytes.size()});
    if (!back.empty()) page->queue(back);
  }
  pages.erase(page.get());
  page->close();
  callbacks.left(page->id);
}

asio::awaitable<void> Hub::Impl::write(std::shared_ptr<OpenPage> page) {
  while (page->open) {
    error_code ec;
    const std::string text = page->next();
    if (text.empty()) {
      co_await page->wake.async_wait(asio::redirect_error(asio::use_awaitable, ec));
      continue;
    }
    page->writing = true;
    co_await page->stream.async_write(asio::buffer(text),
                                      asio::redirect_error(asio::use_awaitable, ec));
    page->writing = false;
    if (ec) page->close();
  }
}

Hub::Hub(const HubSettings& settings, Callbacks callbacks)
    : impl_(std::make_unique<Impl>(settings, std::move(callbacks))) {}

Hub::~Hub() = default;

void Hub::serve_until(std::chrono::steady_clock::time_point deadline) {
  impl_->context.run_until(std::max(deadline, std::chrono::steady_clock::now() + kMinWait));
}

void Hub::set_first_message(std::string text) { impl_->first_message = std::move(text); }

void Hub::send(std::string_view text) {
  for (OpenPage* page : impl_->pages) page->queue(text);
}

void Hub::send_latest(std::size_t kind, std::string_view text) {
  for (OpenPage* page : impl_->pages) page->replace(kind, text);
}

void Hub::announce_shutdown(std::string_view text) {
  send(text);
  const auto deadline = std::chrono::steady_clock::now() + kCloseFrame;
  const auto waits = [this] {
    for (const OpenPage* page : impl_->pages)
      if (!page->idle()) return true;
    return false;
  };
  while (waits() && impl_->context.run_one_until(deadline) != 0) {
  }
}

int Hub::pages() const noexcept { return static_cast<int>(impl_->pages.size()); }

std::uint16_t Hub::port() const noexcept { return impl_->port; }

}  // namespace hedgehog::racer
