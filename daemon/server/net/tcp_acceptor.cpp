// SPDX-License-Identifier: MIT
#include "daemon/server/net/tcp_acceptor.h"

#include <spdlog/spdlog.h>

#include <boost/asio/ip/v6_only.hpp>
#include <stdexcept>
#include <string>

namespace hedgehog::server {

std::optional<boost::asio::ip::tcp::acceptor> open_acceptor(boost::asio::io_context& io,
                                                            const config::ListenAddress& wanted,
                                                            InheritedSockets& inherited,
                                                            const char* remedy) {
  namespace asio = boost::asio;
  const std::string name = config::to_string(wanted);
  boost::system::error_code ec;
  const auto address = asio::ip::make_address(wanted.host, ec);
  // The configuration ensures this; checked again where a violation would take effect.
  if (ec || (!address.is_loopback() && !wanted.tls))
    throw std::runtime_error(name + ": refused: other machines could reach it without TLS");
  asio::ip::tcp::acceptor acceptor(io);
  const asio::ip::tcp::endpoint endpoint(address, wanted.port);
  if (const int descriptor = inherited.take(endpoint); descriptor >= 0) {
    acceptor.assign(endpoint.protocol(), descriptor, ec);
    asio::ip::v6_only v6_only(true);
    if (!ec && address.is_v6() && address.is_unspecified()) acceptor.get_option(v6_only, ec);
    if (ec) throw std::runtime_error(name + ": " + ec.message());
    if (!v6_only) {
      throw std::runtime_error(name +
                               ": systemd's socket takes IPv4, too; add BindIPv6Only=ipv6-only to "
                               "its socket unit");
    }
    return acceptor;
  }
  acceptor.open(endpoint.protocol(), ec);
  if (address.is_v6() && (ec == asio::error::address_family_not_supported)) {
    spdlog::warn("{}: this machine has no IPv6; left out", name);
    return std::nullopt;
  }
  if (!ec) acceptor.set_option(asio::ip::tcp::acceptor::reuse_address(true), ec);
  if (!ec && address.is_v6()) acceptor.set_option(asio::ip::v6_only(true), ec);
  if (!ec) acceptor.bind(endpoint, ec);
  if (address.is_v6() && ec == boost::system::errc::address_not_available) {
    spdlog::warn("{}: this machine has no IPv6 loopback; left out", name);
    return std::nullopt;
  }
  if (!ec) acceptor.listen(asio::socket_base::max_listen_connections, ec);
  if (ec == asio::error::address_in_use) {
    throw std::runtime_error(name +
                             ": the address is in use, possibly by another hedgehogd; stop it, or "
                             "choose another port with " +
                             remedy);
  }
  if (ec) throw std::runtime_error(name + ": " + ec.message());
  return acceptor;
}

std::string endpoint_text(const boost::asio::ip::tcp::endpoint& endpoint) {
  return config::to_string({endpoint.address().to_string(), endpoint.port()});
}

}  // namespace hedgehog::server
