// SPDX-License-Identifier: MIT
#include "tests/e2e/web_client.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <stdexcept>

#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {
namespace {

WebResponse read_response(RawClient& socket, bool to_the_end) {
  WebResponse response;
  while (const auto line = socket.line()) {
    response.head += *line + "\n";
    if (*line == "\r") break;
  }
  if (response.head.starts_with("HTTP/1.1 ")) response.status = std::stoi(response.head.substr(9));
  while (to_the_end) {
    const auto more = socket.bytes();
    if (!more) break;
    response.body += *more;
  }
  return response;
}

}  // namespace

std::string WebResponse::header(std::string_view name) const {
  std::string lower = head;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto at = lower.find("\n" + std::string(name) + ": ");
  if (at == std::string::npos) return {};
  const auto begin = at + name.size() + 3;
  return head.substr(begin, head.find('\r', begin) - begin);
}

WebResponse web_get(int port, const std::string& target, const std::string& more,
                    const std::string& method) {
  const std::string host = more.find("Host: ") == std::string::npos
                               ? "Host: localhost:" + std::to_string(port) + "\r\n"
                               : "";
  return web_send(
      port, method + " " + target + " HTTP/1.1\r\n" + host + more + "Connection: close\r\n\r\n");
}

WebResponse web_send(int port, std::string_view bytes) {
  RawClient socket(port);
  socket.send(bytes);
  return read_response(socket, true);
}

WebSocketClient::WebSocketClient(int port, const std::string& more) : socket_(port) {
  const std::string host = more.find("Host: ") == std::string::npos
                               ? "Host: 127.0.0.1:" + std::to_string(port) + "\r\n"
                               : "";
  socket_.send("GET /ws HTTP/1.1\r\n" + host + more +
               "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
  response_ = read_response(socket_, false);
}

std::string WebSocketClient::framed(int opcode, std::string_view payload, bool last) {
  std::string bytes(1, static_cast<char>((last ? 0x80 : 0) | opcode));
  const std::size_t size = payload.size();
  if (size < 126) {
    bytes += static_cast<char>(0x80 | size);
  } else {
    const int digits = size < 65536 ? 2 : 8;
    bytes += static_cast<char>(0x80 | (digits == 2 ? 126 : 127));
    for (int i = digits - 1; i >= 0; --i) bytes += static_cast<char>((size >> (8 * i)) & 0xff);
  }
  const std::string mask = "\x11\x22\x33\x44";
  bytes += mask;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
  return bytes;
}

bool WebSocketClient::frame(int opcode, std::string_view payload, bool last) {
  return socket_.send(framed(opcode, payload, last));
}

std::optional<WebSocketClient::Frame> WebSocketClient::next() {
  const auto deadline = std::chrono::steady_clock::now() + kLongTimeout;
  auto frame_received = any();
  while (frame_received && frame_received->opcode == kPing) {
    frame(kPong, frame_received->payload);
    frame_received = std::chrono::steady_clock::now() < deadline ? any() : std::nullopt;
  }
  return frame_received;
}

std::optional<WebSocketClient::Frame> WebSocketClient::any() {
  const auto head = socket_.bytes(2);
  if (!head) return std::nullopt;
  std::size_t size = static_cast<unsigned char>((*head)[1]) & 0x7f;
  if (size >= 126) {
    const auto digits = socket_.bytes(size == 126 ? 2 : 8);
    if (!digits) return std::nullopt;
    size = 0;
    for (const char c : *digits) size = size << 8 | static_cast<unsigned char>(c);
  }
  auto payload = size == 0 ? std::optional<std::string>("") : socket_.bytes(size);
  if (!payload) return std::nullopt;
  return Frame{(*head)[0] & 0x0f, *std::move(payload)};
}

Json WebSocketClient::json() {
  const auto frame = next();
  if (!frame || frame->opcode != kText)
    throw std::runtime_error("no text frame: " + (frame ? frame->payload : "closed"));
  return Json::parse(frame->payload);
}

Json WebSocketClient::call(const std::string& method, const Json& params) {
  const Json request{
      {"jsonrpc", "2.0"}, {"id", ++next_id_}, {"method", method}, {"params", params}};
  text(request.dump());
  const auto deadline = std::chrono::steady_clock::now() + kLongTimeout;
  while (std::chrono::steady_clock::now() < deadline) {
    const Json message = json();
    if (message.contains("method")) continue;
    return message.contains("result") ? message["result"] : message["error"];
  }
  throw std::runtime_error("no answer to " + request.dump());
}

}  // namespace hedgehog::e2e
