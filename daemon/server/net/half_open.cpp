// SPDX-License-Identifier: MIT
#include "daemon/server/net/half_open.h"

#include <sys/socket.h>

#include <algorithm>
#include <utility>

#include "daemon/server/session/failed_tokens.h"

namespace hedgehog::server {

HalfOpen::Ticket::Ticket(Ticket&& other) noexcept
    : owner_(std::exchange(other.owner_, nullptr)), entry_(other.entry_) {}

HalfOpen::Ticket& HalfOpen::Ticket::operator=(Ticket&& other) noexcept {
  if (this == &other) return *this;
  release();
  owner_ = std::exchange(other.owner_, nullptr);
  entry_ = other.entry_;
  return *this;
}

void HalfOpen::Ticket::release() noexcept {
  if (const auto owner = std::exchange(owner_, nullptr)) owner->entries_.erase(entry_);
}

HalfOpen::Ticket HalfOpen::enter(int descriptor, const std::string& address) {
  const std::string host = FailedTokens::key_of(address);
  make_space(host);
  entries_.push_back(
      {++last_id_, descriptor, host, false, boost::asio::steady_timer(executor_, timeout_)});
  const auto entry = std::prev(entries_.end());
  entry->timer.async_wait(
      [weak = weak_from_this(), id = last_id_](const boost::system::error_code& cancelled) {
        const auto self = weak.lock();
        if (!cancelled && self) self->expire(id);
      });
  return {shared_from_this(), entry};
}

void HalfOpen::make_space(const std::string& host) {
  const auto open = [](const Entry& entry) { return !entry.ended; };
  const auto of_host = [&](const Entry& entry) { return open(entry) && entry.host == host; };
  const auto count = [&](const auto& which) {
    return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), which));
  };
  if (count(of_host) >= kMaxOfAddress)
    disconnect(*std::find_if(entries_.begin(), entries_.end(), of_host));
  else if (count(open) >= kMax)
    disconnect(*std::find_if(entries_.begin(), entries_.end(), open));
}

void HalfOpen::expire(std::uint64_t id) noexcept {
  // The entry may have been removed while this call was queued.
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& one) { return one.id == id; });
  if (entry != entries_.end()) disconnect(*entry);
}

void HalfOpen::disconnect(Entry& entry) noexcept {
  if (std::exchange(entry.ended, true)) return;
  ++disconnected_;
  ::shutdown(entry.descriptor, SHUT_RDWR);
}

}  // namespace hedgehog::server
