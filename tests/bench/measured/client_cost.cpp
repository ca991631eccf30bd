// SPDX-License-Identifier: MIT
// Processor time, us, of one telemetry notification in a program: with the C++ client library, each
// decoded; then with a plain socket that only reads the bytes. `client_cost PORT SECONDS`, for a
// server that sends like reference_telemetry_sender.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

#include "clients/lib/connection.h"

namespace {

namespace client = hedgehog::client;
using Clock = std::chrono::steady_clock;

double thread_us() {
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return static_cast<double>(spent.tv_sec) * 1e6 + static_cast<double>(spent.tv_nsec) * 1e-3;
}

double by_library(const std::string& port, double seconds) {
  const auto address = client::parse_address("127.0.0.1:" + port).value();
  auto connection = client::Connection::open({address}).value();
  connection.notify_raw("telemetry.subscribe", "").value();
  const auto next = [&] { return connection.next(std::chrono::seconds(60)).value().has_value(); };
  next();
  const double before_us = thread_us();
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  int count = 0;
  do count += next();
  while (Clock::now() < until);
  return (thread_us() - before_us) / std::max(1, count);
}

double by_socket(const std::string& port, double seconds) {
  const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(port)));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::array<char, 16 * 1024> buffer;
  if (::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::send(fd, "\n", 1, MSG_NOSIGNAL) != 1 || ::recv(fd, buffer.data(), buffer.size(), 0) <= 0) {
    std::cerr << "client_cost: no server at port " << port << '\n';
    std::exit(EXIT_FAILURE);
  }
  const double before_us = thread_us();
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  std::ptrdiff_t count = 0;
  do {
    const ssize_t bytes = ::recv(fd, buffer.data(), buffer.size(), 0);
    if (bytes <= 0) break;
    count += std::count(buffer.begin(), buffer.begin() + bytes, '\n');
  } while (Clock::now() < until);
  ::close(fd);
  return (thread_us() - before_us) / static_cast<double>(std::max<std::ptrdiff_t>(1, count));
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc == 3 ? std::atof(argv[2]) : 0.0;
  if (seconds <= 0.0) {
    std::cerr << "client_cost PORT SECONDS\n";
    return EXIT_FAILURE;
  }
  std::cout << by_library(argv[1], seconds) << '\n' << by_socket(argv[1], seconds) << '\n';
}
