// SPDX-License-Identifier: MIT
#include "clients/study/journal/identity.h"

namespace hedgehog::study {

bool same_serial(const BallFacts& a, const BallFacts& b) {
  return !a.simulated && !b.simulated && a.serial && a.serial == b.serial;
}

Identity compare(const Pin& then, const Pin& now) {
  if (then.ball.name != now.ball.name || then.ball.model != now.ball.model ||
      then.ball.serial != now.ball.serial || then.ball.simulated != now.ball.simulated)
    return Identity::kOther;
  if (!then.daemon.start_id.empty() && !now.daemon.start_id.empty())
    return then.daemon.start_id == now.daemon.start_id ? Identity::kSame : Identity::kUnproven;
  const bool same_address =
      then.daemon.address.empty() || then.daemon.address == now.daemon.address;
  return same_address && same_serial(then.ball, now.ball) ? Identity::kSame : Identity::kUnproven;
}

}  // namespace hedgehog::study
