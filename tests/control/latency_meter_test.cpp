// SPDX-License-Identifier: MIT
#include "daemon/control/loop/latency_meter.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace hedgehog::control {
namespace {

class LatencyMeterTest : public testing::Test {
 protected:
  /// A tick at `now_ns` applies `what`, and its set-point is number `set_point`.
  void apply(std::uint64_t seq, decltype(Command::what) what, std::uint64_t set_point,
             std::int64_t now_ns) {
    StepInputs inputs;
    inputs.command_count = 1;
    inputs.commands[0] = {seq, std::move(what)};
    meter_.applied(inputs, mailbox_->request_times, set_point, now_ns);
  }
  void request(std::uint64_t seq, std::int64_t received_ns, std::int64_t queued_ns) {
    mailbox_->request_times.received(seq, received_ns);
    mailbox_->request_times.queued(seq, queued_ns);
  }
  std::vector<EffectTimes> measured() {
    std::vector<EffectTimes> all;
    EffectTimes times;
    while (mailbox_->effect_times.pop(times)) all.push_back(times);
    return all;
  }
  static device::LinkReport written(std::uint64_t count, std::int64_t ns) {
    device::LinkReport report;
    report.present = true;
    report.written_count = count;
    report.written_ns = ns;
    return report;
  }

  std::unique_ptr<Mailbox> mailbox_ = std::make_unique<Mailbox>();
  LatencyMeter meter_;
};

TEST_F(LatencyMeterTest, ReportsAnEffectOnceItsSetPointIsWritten) {
  request(7, 100, 200);
  apply(7, StartEffect{}, 40, 300);
  meter_.written(written(39, 350), *mailbox_);
  EXPECT_TRUE(measured().empty());
  meter_.written(written(40, 400), *mailbox_);
  const auto times = measured();
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0].seq, 7u);
  EXPECT_EQ(times[0].received_ns, 100);
  EXPECT_EQ(times[0].queued_ns, 200);
  EXPECT_EQ(times[0].applied_ns, 300);
  EXPECT_EQ(times[0].written_ns, 400);
  meter_.written(written(41, 500), *mailbox_);
  EXPECT_TRUE(measured().empty());
}

TEST_F(LatencyMeterTest, ALaterSetPointContainsTheEffectToo) {
  request(7, 100, 200);
  apply(7, UpdateEffect{}, 40, 300);
  meter_.written(written(42, 900), *mailbox_);
  EXPECT_EQ(measured().size(), 1u);
}

TEST_F(LatencyMeterTest, MeasuresEffectsOnlyAndRequestsOnly) {
  request(7, 100, 200);
  apply(7, SetGain{}, 40, 300);
  apply(8, StartEffect{}, 40, 300);  // without a client's request
  meter_.written(written(40, 400), *mailbox_);
  EXPECT_TRUE(measured().empty());
}

TEST_F(LatencyMeterTest, WithoutABoardNothingIsWritten) {
  request(7, 100, 200);
  apply(7, StartEffect{}, 40, 300);
  meter_.written({}, *mailbox_);
  meter_.written(written(50, 9000), *mailbox_);
  EXPECT_TRUE(measured().empty());
}

TEST_F(LatencyMeterTest, AStuckLinkLosesMeasurementsOnly) {
  constexpr std::uint64_t kMany = 1000;
  for (std::uint64_t seq = 1; seq <= kMany; ++seq) {
    request(seq, 100, 200);
    apply(seq, StartEffect{}, seq, 300);
  }
  meter_.written(written(kMany, 400), *mailbox_);
  const std::size_t found = measured().size();
  EXPECT_GT(found, 0u);
  EXPECT_LT(found, kMany);
  request(kMany + 1, 100, 200);
  apply(kMany + 1, StartEffect{}, kMany + 1, 300);
  meter_.written(written(kMany + 1, 400), *mailbox_);
  EXPECT_EQ(measured().size(), 1u);
}

}  // namespace
}  // namespace hedgehog::control
