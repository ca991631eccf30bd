// SPDX-License-Identifier: MIT
// Connections without a token are limited in number, and keep no other client out.
#include "daemon/server/net/half_open.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace hedgehog::server {
namespace {

/// One end of a connection; the other end belongs to an unauthenticated client.
class HalfOpenClient {
 public:
  HalfOpenClient() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
  HalfOpenClient(const HalfOpenClient&) = delete;
  HalfOpenClient& operator=(const HalfOpenClient&) = delete;
  ~HalfOpenClient() {
    ticket.release();
    for (const int fd : ends_) ::close(fd);
  }
  int descriptor() const noexcept { return ends_[0]; }
  bool is_disconnected() const {
    char byte = 0;
    return ::recv(ends_[1], &byte, 1, MSG_DONTWAIT) == 0;
  }

  HalfOpen::Ticket ticket;

 private:
  std::array<int, 2> ends_{};
};

class HalfOpenTickets : public testing::Test {
 protected:
  HalfOpenClient& enter(const std::string& address) {
    HalfOpenClient& client = clients_.emplace_back();
    client.ticket = half_open_->enter(client.descriptor(), address);
    return client;
  }
  static std::string host(std::size_t i) { return "192.0.2." + std::to_string(i) + ":1"; }

  boost::asio::io_context io_{1};
  std::shared_ptr<HalfOpen> half_open_ =
      std::make_shared<HalfOpen>(io_.get_executor(), std::chrono::milliseconds(20));
  std::deque<HalfOpenClient> clients_;
};

TEST_F(HalfOpenTickets, OfOneAddressTheOldestIsDropped) {
  std::vector<HalfOpenClient*> all;
  for (std::size_t i = 0; i < HalfOpen::kMaxOfAddress; ++i)
    all.push_back(&enter("192.0.2.7:" + std::to_string(i)));
  HalfOpenClient& other = enter("192.0.2.8:1");
  for (const HalfOpenClient* one : all) EXPECT_FALSE(one->is_disconnected());
  enter("192.0.2.7:99");
  EXPECT_TRUE(all[0]->is_disconnected());
  EXPECT_FALSE(all[1]->is_disconnected());
  EXPECT_FALSE(other.is_disconnected());
  enter("192.0.2.7:100");
  EXPECT_TRUE(all[1]->is_disconnected()) << "who was disconnected counts no more";
  EXPECT_EQ(half_open_->disconnected(), 2u);
}

TEST_F(HalfOpenTickets, OfAllTheOldestIsDropped) {
  std::vector<HalfOpenClient*> all;
  for (std::size_t i = 0; i < HalfOpen::kMax; ++i) all.push_back(&enter(host(i)));
  EXPECT_EQ(half_open_->disconnected(), 0u);
  EXPECT_FALSE(enter(host(200)).is_disconnected());
  EXPECT_TRUE(all[0]->is_disconnected());
  EXPECT_FALSE(all[1]->is_disconnected());
}

TEST_F(HalfOpenTickets, ASlowHandshakeIsDisconnected) {
  HalfOpenClient& slow = enter(host(1));
  HalfOpenClient& known = enter(host(2));
  known.ticket.release();
  io_.run();
  EXPECT_TRUE(slow.is_disconnected());
  EXPECT_FALSE(known.is_disconnected()) << "it has logged in";
  EXPECT_EQ(half_open_->size(), 1u) << "until its connection has noticed";
  slow.ticket.release();
  EXPECT_EQ(half_open_->size(), 0u);
}

TEST_F(HalfOpenTickets, ATicketMovesWithItsConnection) {
  HalfOpenClient& one = enter(host(1));
  HalfOpen::Ticket moved = std::move(one.ticket);
  EXPECT_FALSE(one.ticket);
  EXPECT_EQ(half_open_->size(), 1u);
  moved = HalfOpen::Ticket();
  EXPECT_EQ(half_open_->size(), 0u);
}

TEST_F(HalfOpenTickets, MayOutliveTheListener) {
  HalfOpenClient& one = enter(host(1));
  half_open_.reset();
  one.ticket.release();
  EXPECT_FALSE(one.ticket);
  io_.run();
}

}  // namespace
}  // namespace hedgehog::server
