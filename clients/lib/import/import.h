// SPDX-License-Identifier: MIT
// Patterns from other formats. What a ball cannot play is left out and reported.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/client_error.h"
#include "protocol/values/pattern.h"

namespace hedgehog::client {

struct Imported {
  protocol::Pattern pattern;  // without a name
  /// What was left out or changed, one sentence each.
  std::vector<std::string> notes;
};

/// Files larger than this are refused.
inline constexpr std::size_t kMaxImportBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMaxImportNesting = 32;
/// Limit of entries, effects or key frames of a file; files with more are refused.
inline constexpr std::size_t kMaxImportEvents = 1000;
/// Limit of points of an AHAP's parameter curves; further points are left out.
inline constexpr std::size_t kMaxImportPoints = 4000;
/// Length of the push that represents a transient: that of the shipped `tick`.
inline constexpr double kTransientMs = 25.0;

/// A file of either format:
/// - Apple Haptic and Audio Pattern, version 1: transient and continuous events with intensity,
///   attack, decay and release; parameter curves and dynamic parameters of the intensity. Format:
///   "Representing haptic patterns in AHAP files", Apple developer documentation. Its samples have
///   trailing commas, which are accepted and reported.
/// - MPEG-I haptics (ISO/IEC 23090-31) in its JSON form, .hjif: perceptions, channels with their
///   gain, bands (transients, curves, vectorial waves) and key frames; effects of the library. Key
///   frames are interpreted as in the MPEG reference software (Effect.cpp), whose encoder writes
///   `Other` for every modality and 65534 for a `relative_position` of -2.
/// `decode_pattern` accepts the result once it has a name. kBadData: the error.
Outcome<Imported> import_pattern(std::string_view text);

}  // namespace hedgehog::client
