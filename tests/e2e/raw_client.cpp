// SPDX-License-Identifier: MIT
#include "tests/e2e/raw_client.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "protocol/methods.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {
namespace {

constexpr int kTimeoutMs = std::chrono::milliseconds(kTimeout).count();

}  // namespace

RawClient::RawClient(int port, int buffer) : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (buffer > 0) ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error(std::string("connect: ") + std::strerror(errno));
  const int on = 1;
  ::setsockopt(fd_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

RawClient::RawClient(const std::string& socket_path)
    : fd_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  socket_path.copy(address.sun_path, sizeof address.sun_path - 1);
  if (::connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error(socket_path + ": " + std::strerror(errno));
}

bool RawClient::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

unsigned RawClient::segments() const {
  // tcpi_data_segs_in of Linux 4.6, which the C library's tcp_info ends before.
  constexpr std::size_t kDataSegmentsIn = 152;
  std::array<unsigned char, 256> info{};
  socklen_t size = info.size();
  std::uint32_t segments = 0;
  if (::getsockopt(fd_, IPPROTO_TCP, TCP_INFO, info.data(), &size) != 0 ||
      size < kDataSegmentsIn + sizeof segments)
    throw std::runtime_error("the system does not count TCP segments");
  std::memcpy(&segments, &info[kDataSegmentsIn], sizeof segments);
  return segments;
}

bool RawClient::receive() {
  pollfd waiting{fd_, POLLIN, 0};
  char bytes[16 * 1024];
  const ssize_t count =
      ::poll(&waiting, 1, kTimeoutMs) == 1 ? ::recv(fd_, bytes, sizeof bytes, 0) : -1;
  if (count > 0) buffer_.append(bytes, static_cast<std::size_t>(count));
  return count > 0;
}

std::optional<std::string> RawClient::bytes(std::size_t count) {
  while (buffer_.size() < std::max<std::size_t>(count, 1))
    if (!receive()) return std::nullopt;
  std::string received = buffer_.substr(0, count == 0 ? buffer_.size() : count);
  buffer_.erase(0, received.size());
  return received;
}

std::optional<std::string> RawClient::line() {
  for (;;) {
    const auto end = buffer_.find('\n');
    if (end != std::string::npos) {
      std::string text = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return text;
    }
    if (!receive()) return std::nullopt;
  }
}

Json RawClient::response() {
  const auto deadline = std::chrono::steady_clock::now() + kLongTimeout;
  while (std::chrono::steady_clock::now() < deadline) {
    const auto text = line();
    if (!text) break;
    Json message = Json::parse(*text);
    if (message.is_array() || !message.contains("method")) return message;
    notifications_.push_back(std::move(message));
  }
  throw std::runtime_error("no answer; the daemon has closed, or tells other things for minutes");
}

Json RawClient::call(const std::string& method, const Json& params) {
  const Json request{
      {"jsonrpc", "2.0"}, {"id", ++next_id_}, {"method", method}, {"params", params}};
  send(request.dump() + "\n");
  const Json reply = response();
  if (reply.value("id", Json()) != next_id_)
    throw std::runtime_error("not the answer to " + request.dump() + ": " + reply.dump());
  const auto known = protocol::method_named(method);
  if (known && reply.contains("error")) {
    const auto code = static_cast<protocol::ErrorCode>(reply["error"].value("code", 0));
    if (!protocol::possible_errors(protocol::info(*known)).contains(code))
      throw std::runtime_error(method + " lists no such error: " + reply.dump());
  }
  return reply.contains("result") ? reply["result"] : reply["error"];
}

Json RawClient::notification(const std::string& method, const std::string& type) {
  const auto deadline = std::chrono::steady_clock::now() + kLongTimeout;
  for (;;) {
    if (std::chrono::steady_clock::now() > deadline)
      throw std::runtime_error("no " + method + " " + type + " in ten minutes");
    while (!notifications_.empty()) {
      const Json message = std::move(notifications_.front());
      notifications_.pop_front();
      if (message["method"] == method &&
          (type.empty() || message["params"].value("type", "") == type))
        return message["params"];
    }
    const auto text = line();
    if (!text) throw std::runtime_error("the daemon has closed before " + method + " " + type);
    Json message = Json::parse(*text);
    if (message.contains("method")) notifications_.push_back(std::move(message));
  }
}

bool RawClient::closed_by_daemon() {
  while (const auto text = line())
    if (!Json::parse(*text).contains("method")) return false;
  return true;
}

void RawClient::half_close() { ::shutdown(fd_, SHUT_WR); }

void RawClient::close() {
  if (fd_ >= 0) {
    ::close(fd_);
    fd_ = -1;
  }
}

}  // namespace hedgehog::e2e
