// SPDX-License-Identifier: MIT
// Reference server: sends each line back. `--parse`: parses it with nlohmann/json, and sends the
// serialised response to `ping`. Prints its port.
#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t kReadBytes = 16 * 1024;
constexpr std::int64_t kAnyTimeNs = 273'660'123'456'789;

/// Appends the response to `line`, which is given without its LF.
void respond(std::string_view line, bool parse, std::string& out) {
  if (parse) {
    const nlohmann::json request = nlohmann::json::parse(line);
    const nlohmann::json response{
        {"jsonrpc", "2.0"}, {"id", request.at("id")}, {"result", {{"time_ns", kAnyTimeNs}}}};
    out += response.dump();
  } else {
    out += line;
  }
  out += '\n';
}

asio::awaitable<void> serve(tcp::socket socket, bool parse) {
  std::array<char, kReadBytes> buffer;
  std::string received;
  std::string reply;
  for (;;) {
    error_code ec;
    const std::size_t count = co_await socket.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    received.append(buffer.data(), count);
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = received.find('\n', begin)) != received.npos; begin = end + 1)
      respond(std::string_view(received).substr(begin, end - begin), parse, reply);
    received.erase(0, begin);
    if (reply.empty()) continue;
    co_await asio::async_write(socket, asio::buffer(reply),
                               asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    reply.clear();
  }
}

asio::awaitable<void> accept(tcp::acceptor acceptor, bool parse) {
  for (;;) {
    tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
    socket.set_option(tcp::no_delay(true));
    asio::co_spawn(acceptor.get_executor(), serve(std::move(socket), parse), asio::detached);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool parse = argc == 2 && std::string_view(argv[1]) == "--parse";
  if (argc > 1 && !parse) {
    std::cerr << "reference_echo [--parse]\n";
    return EXIT_FAILURE;
  }
  asio::io_context io(1);
  tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), 0});
  std::cout << "listening on 127.0.0.1:" << acceptor.local_endpoint().port() << std::endl;
  asio::co_spawn(io, accept(std::move(acceptor), parse), asio::detached);
  io.run();
}
