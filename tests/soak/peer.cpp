// SPDX-License-Identifier: MIT
#include "tests/soak/peer.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "tests/soak/failure.h"
#include "tests/soak/json_text.h"

namespace hedgehog::soak {
namespace {

constexpr std::size_t kTranscript = 30;
bool is_utf8(std::string_view text) {
  // The JSON writer replaces invalid UTF-8.
  const auto replaced = [](std::string_view in) {
    constexpr std::string_view kReplacement = "\xef\xbf\xbd";
    std::size_t count = 0;
    for (auto at = in.find(kReplacement); at != std::string_view::npos;
         at = in.find(kReplacement, at + 1))
      ++count;
    return count;
  };
  std::string written;
  protocol::append_string(written, text);
  return replaced(written) == replaced(text);
}

}  // namespace

Peer::Peer(Transport transport, const Endpoints& endpoints, int receive_buffer)
    : transport_(transport), unframer_(transport) {
  connect(endpoints, receive_buffer);
  if (transport == Transport::kWebSocket) handshake_ = web_handshake(endpoints.http_port);
}

void Peer::connect(const Endpoints& endpoints, int receive_buffer) {
  const bool local = transport_ == Transport::kUnix;
  fd_ = ::socket(local ? AF_UNIX : AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (receive_buffer > 0)
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  sockaddr_storage storage{};
  socklen_t size = 0;
  if (local) {
    auto& address = reinterpret_cast<sockaddr_un&>(storage);
    address.sun_family = AF_UNIX;
    endpoints.socket.copy(address.sun_path, sizeof address.sun_path - 1);
    size = sizeof address;
  } else {
    auto& address = reinterpret_cast<sockaddr_in&>(storage);
    const bool web = transport_ == Transport::kWebSocket || transport_ == Transport::kHttp;
    address.sin_family = AF_INET;
    address.sin_port =
        htons(static_cast<std::uint16_t>(web ? endpoints.http_port : endpoints.port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    size = sizeof address;
  }
  if (::connect(fd_, reinterpret_cast<sockaddr*>(&storage), size) != 0)
    throw Failure(std::string("connect: ") + std::strerror(errno));
  ::fcntl(fd_, F_SETFL, ::fcntl(fd_, F_GETFL) | O_NONBLOCK);
  if (local) return;
  const int on = 1;
  ::setsockopt(fd_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  sockaddr_in own{};
  socklen_t own_size = sizeof own;
  ::getsockname(fd_, reinterpret_cast<sockaddr*>(&own), &own_size);
  address_ = "127.0.0.1:" + std::to_string(ntohs(own.sin_port));
}

void Peer::record(const std::string& sent) {
  transcript_.push_back(shortened(sent));
  if (transcript_.size() > kTranscript) transcript_.pop_front();
}

void Peer::send(const std::string& message, int fragments) {
  if (!is_open() || half_closed_ || transport_ == Transport::kHttp) return;
  complete_line();
  record(message);
  if (transport_ != Transport::kWebSocket) {
    out_ += message + "\n";
  } else if (!is_utf8(message)) {
    out_ += web_frame(kTextFrame, message);
    allow_close("text that is not UTF-8");
    return;
  } else {
    const std::size_t part = message.size() / static_cast<std::size_t>(fragments) + 1;
    std::size_t at = 0;
    do {
      const std::string_view piece = std::string_view(message).substr(at, part);
      out_ += web_frame(at == 0 ? kTextFrame : 0, piece, at + part >= message.size());
      at += part;
    } while (at < message.size());
  }
  const protocol::Incoming incoming = protocol::decode_line(message);
  responses_.expect(incoming);
  subscriptions_.sent(incoming);
}

void Peer::send_in_parts(const std::string& line, std::size_t first) {
  if (!is_open() || half_closed_ || transport_ == Transport::kHttp) return;
  complete_line();
  part_ = line.substr(0, first);
  rest_ = line.substr(part_.size());
  out_ += part_;
}

void Peer::complete_line() {
  if (rest_.empty()) return;
  const std::string line = part_ + rest_;
  out_ += rest_ + "\n";
  rest_.clear();
  record(line);
  const protocol::Incoming incoming = protocol::decode_line(line);
  responses_.expect(incoming);
  subscriptions_.sent(incoming);
}

void Peer::send_too_long(std::size_t bytes) {
  if (!is_open() || half_closed_ || transport_ == Transport::kHttp) return;
  complete_line();
  const std::string message = "{" + std::string(bytes, 'x');
  record(message);
  out_ += transport_ == Transport::kWebSocket ? web_frame(kTextFrame, message) : message + "\n";
  responses_.expect_parse_error();
}

void Peer::send_bytes(std::string_view bytes) {
  if (is_open() && !half_closed_) out_ += bytes;
}

void Peer::half_close() {
  if (half_closed_ || !is_open()) return;
  // The rest of a partly sent line is discarded with it.
  rest_.clear();
  record("(half close)");
  half_closed_ = true;
  shut_down_when_sent();
}

void Peer::shut_down_when_sent() {
  if (half_closed_ && !shut_down_ && out_.empty() && is_open()) {
    shut_down_ = true;
    ::shutdown(fd_, SHUT_WR);
  }
}

void Peer::close() {
  if (fd_ < 0) return;
  ::close(fd_);
  fd_ = -1;
}

void Peer::reset() {
  if (fd_ < 0) return;
  const linger at_once{1, 0};
  ::setsockopt(fd_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  close();
}

void Peer::exchange(bool readable, bool writable, PeerObserver& observer) {
  if (writable) write_some();
  shut_down_when_sent();
  if (readable && is_open()) read_some(observer);
}

void Peer::write_some() {
  std::string& out = is_upgrading() ? handshake_ : out_;
  if (out.empty()) return;
  const ssize_t sent = ::send(fd_, out.data(), out.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0)
    out.erase(0, static_cast<std::size_t>(sent));
  else if (errno != EAGAIN && errno != EINTR)
    out.clear();  // the end of the connection is detected by the next read
}

void Peer::read_some(PeerObserver& observer) {
  char bytes[64 * 1024];
  const ssize_t count = ::recv(fd_, bytes, sizeof bytes, MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count <= 0) {
    closed_by_daemon_ = true;
    close();
    return;
  }
  unframer_.feed({bytes, static_cast<std::size_t>(count)});
  while (auto message = unframer_.next()) receive(*message, observer);
}

void Peer::receive(const Received& message, PeerObserver& observer) {
  if (message.opcode == kPingFrame) {
    send_bytes(web_frame(kPongFrame, message.payload));
    return;
  }
  if (message.opcode == kCloseFrame) {
    send_bytes(web_frame(kCloseFrame, message.payload));
    half_closed_ = true;
    allow_close("a close frame");
    return;
  }
  if (message.opcode != kTextFrame) return;
  const auto json = protocol::parse_json(message.payload, 64);
  if (json.has_error()) throw Failure("no JSON: " + shortened(message.payload));
  if (json->find("method") != nullptr) {
    subscriptions_.notified(*json);
    observer.on_notification(*this, *json);
    return;
  }
  if (!received_ && message.payload.find("too many clients") != std::string::npos) {
    allow_close("too many clients");
    return;
  }
  received_ = true;
  responses_.receive(*json, [&](const CompletedRequest& completed) {
    subscriptions_.on_response(completed);
    if (completed.method && protocol::name(*completed.method) == "hello" && completed.result)
      number_ = *completed.result->find("connection")->as<std::int64_t>();
    observer.on_response(*this, completed);
  });
}

std::string Peer::text() const {
  std::string text = "connection " + (number_ ? std::to_string(*number_) : "?") + " (" +
                     std::string(name(transport_)) + "), pending: " + responses_.text() +
                     (reads_ ? "" : " it does not read,") +
                     (close_reason_.empty() ? "" : " provoked: ") + close_reason_ + "\nsent last:";
  for (const std::string& line : transcript_) {
    std::string written;
    protocol::append_string(written, line);
    text += "\n  " + written;
  }
  return text;
}

}  // namespace hedgehog::soak
