// SPDX-License-Identifier: MIT
#include "daemon/server/session/failed_tokens.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/network_v6.hpp>

namespace hedgehog::server {

std::string FailedTokens::key_of(std::string_view address) {
  constexpr unsigned short kNetworkBits = 64;
  std::string host(address.substr(0, address.rfind(':')));
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  boost::system::error_code ec;
  const auto ip = boost::asio::ip::make_address(host, ec);
  if (ec || !ip.is_v6()) return host;
  const auto v6 = ip.to_v6();
  if (v6.is_v4_mapped())
    return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, v6).to_string();
  return boost::asio::ip::make_network_v6(v6, kNetworkBits).canonical().to_string();
}

model::Tick FailedTokens::remaining(const std::string& key, model::Tick now) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? 0 : std::max<model::Tick>(0, found->second.until - now);
}

void FailedTokens::failed(const std::string& key, model::Tick now) {
  if (!entries_.contains(key)) make_space(now);
  Entry& entry = entries_[key];
  if (now - entry.last > kMemory) entry = {};
  entry.last = now;
  ++entry.failures;
  if (entry.failures <= kFree) return;
  const int doublings = std::min(entry.failures - kFree - 1, 16);
  entry.until = now + std::min<model::Tick>(kFirstWait << doublings, kMaxWait);
}

void FailedTokens::make_space(model::Tick now) {
  std::erase_if(entries_, [&](const auto& one) { return now - one.second.last > kMemory; });
  if (entries_.size() < kMaxAddresses) return;
  entries_.erase(
      std::min_element(entries_.begin(), entries_.end(),
                       [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
}

}  // namespace hedgehog::server
