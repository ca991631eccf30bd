// SPDX-License-Identifier: MIT
#include "clients/racer/server/page_acceptor.h"

#include <stdexcept>
#include <string>

namespace hedgehog::racer {

namespace asio = boost::asio;
using boost::system::error_code;

asio::ip::tcp::acceptor open_acceptor(asio::io_context& context, const HubSettings& settings) {
  const std::string where = settings.address + ":" + std::to_string(settings.port);
  error_code ec;
  const asio::ip::address address = asio::ip::make_address(settings.address, ec);
  if (ec) throw std::runtime_error("cannot listen on " + where + ": that is no address");
  if (!address.is_loopback()) {
    const std::string port = settings.port == 0 ? "PORT" : std::to_string(settings.port);
    throw std::runtime_error("refused to listen on " + where +
                             ": other machines would reach it without TLS and token; from another "
                             "machine use ssh -L " +
                             port + ":127.0.0.1:" + port + " to this one");
  }
  const asio::ip::tcp::endpoint endpoint(address, settings.port);
  asio::ip::tcp::acceptor acceptor(context);
  acceptor.open(endpoint.protocol());
  acceptor.set_option(asio::ip::tcp::acceptor::reuse_address(true));
  acceptor.bind(endpoint, ec);
  if (!ec) acceptor.listen(asio::socket_base::max_listen_connections, ec);
  if (ec) {
    throw std::runtime_error("cannot listen on " + where + ": " + ec.message() +
                             "; --listen chooses another port, 0 a free one");
  }
  return acceptor;
}

}  // namespace hedgehog::racer
