// SPDX-License-Identifier: MIT
#include "tests/bench/load/client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

namespace hedgehog::bench {
namespace {

constexpr timeval kTimeout{60, 0};

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

Client::Client(int port) : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const int on = 1;
  const sockaddr_in address = loopback(port);
  ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &kTimeout, sizeof kTimeout);
  if (fd_ < 0 || ::connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (fd_ >= 0) ::close(fd_);
    throw std::runtime_error("no connection to port " + std::to_string(port));
  }
  ::setsockopt(fd_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

Client::Client(Client&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), read_(std::move(other.read_)) {}

Client::~Client() {
  if (fd_ >= 0) ::close(fd_);
}

void Client::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) throw std::runtime_error("a server closed its connection");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Client::receive() {
  std::array<char, 16 * 1024> bytes;
  const ssize_t count = ::recv(fd_, bytes.data(), bytes.size(), 0);
  if (count <= 0) throw std::runtime_error("a server closed its connection, or does not answer");
  read_.append(bytes.data(), static_cast<std::size_t>(count));
}

std::string Client::line() {
  std::size_t end = 0;
  while ((end = read_.find('\n')) == read_.npos) receive();
  std::string found = read_.substr(0, end);
  read_.erase(0, end + 1);
  return found;
}

std::string Client::call(std::string_view request) {
  send(request);
  for (;;) {
    std::string found = line();
    if (!found.starts_with(R"({"jsonrpc":"2.0","method")")) return found;
    // An echo server's response is the request itself.
    if (found.size() + 1 == request.size()) return found;
  }
}

void Client::skip(std::size_t bytes) {
  while (read_.size() < bytes) receive();
  read_.erase(0, bytes);
}

Client connect_when_listening(int port) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(kTimeout.tv_sec);
  for (;;) {
    try {
      return Client(port);
    } catch (const std::runtime_error&) {
      if (std::chrono::steady_clock::now() > until) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}

std::string http_get(int port, const std::string& path) {
  Client client(port);
  client.send("GET " + path + " HTTP/1.0\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n");
  std::size_t length = 0;
  for (std::string header; (header = client.line()) != "\r";)
    if (header.starts_with("Content-Length: ")) length = std::stoul(header.substr(16));
  std::string body;
  while (body.size() < length) body += client.line() + '\n';
  return body;
}

}  // namespace hedgehog::bench
