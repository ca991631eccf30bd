// SPDX-License-Identifier: MIT
// Pairs computed by an independent program, all digits (reference: physics.md section 1). Force on
// the first magnet along its axis; both polarised outwards, inner faces on the sphere, 1.37 T.
#pragma once

#include <array>

#include "model/magnets/pair/pair_force.h"

namespace hedgehog::model {

struct ReferencePair {
  MagnetPair pair;
  double angle_deg;
  double offset_mm;
  double exact_n;
  double dipole_n;
};

inline constexpr std::array<ReferencePair, 12> kReferencePairs{{
    {{{8, 10}, {4, 10}, 35}, 12, 0, 0.28148187398398, 0.4867188738955518},
    {{{8, 10}, {4, 10}, 35}, 12, 0.5, 0.5095441733500783, 1.246068616018648},
    {{{8, 10}, {4, 10}, 35}, 12, 2, 0.9421484072010542, 2.6164603182666384},
    {{{8, 10}, {4, 10}, 35}, 13.513, 0.5, 0.3552409299605853, 0.761415847670665},
    {{{8, 10}, {4, 10}, 35}, 16.79, 0, 0.12904550841977205, 0.18046503088032406},
    {{{8, 10}, {4, 10}, 35}, 25, 5, 0.11309120522264823, 0.14255055341433612},
    {{{8, 10}, {4, 10}, 35}, 120, 1, 0.0014450872296794914, 0.0014217509264193094},
    {{{8, 10}, {3, 10}, 35}, 12.887, 0, 0.1330857673649944, 0.22160024397549014},
    {{{8, 10}, {8, 10}, 35}, 19.818, 0, 0.3316491209986348, 0.4444021181025483},
    {{{8, 10}, {8, 10}, 35}, 31.717, 0, 0.10457390778605125, 0.11583990523874907},
    {{{8, 10}, {8, 10}, 35}, 90, 0, 0.009388069201430772, 0.009331655045688503},
    {{{6, 8}, {4, 5}, 30}, 15, 0.5, 0.32011784600833043, 0.5534602031850118},
}};

}  // namespace hedgehog::model
