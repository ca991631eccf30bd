// SPDX-License-Identifier: MIT
// Patterns from other formats. What has no counterpart on a ball is left out, and said.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/client_error.h"
#include "protocol/values/pattern.h"

namespace hedgehog::client {

struct Imported {
  protocol::Pattern pattern;  // without a name
  /// What was left out or changed, a sentence each.
  std::vector<std::string> notes;
};

/// Files larger than this are refused.
inline constexpr std::size_t kMaxImportBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMaxImportNesting = 32;
/// So many entries, effects or key frames of the file; more are refused.
inline constexpr std::size_t kMaxImportEvents = 1000;
/// So many points of an AHAP's parameter curves; more are left out.
inline constexpr std::size_t kMaxImportPoints = 4000;
/// A transient is a push of this length: that of the shipped `tick`.
inline constexpr double kTransientMs = 25.0;

/// A file of either format:
/// - Apple Haptic and Audio Pattern, version 1: transient and continuous events with intensity,
///   attack, decay and release; parameter curves and dynamic parameters of the intensity. Format:
///   "Representing haptic patterns in AHAP files", Apple developer documentation. Its samples have
///   commas behind last items, which are read and told.
/// - MPEG-I haptics (ISO/IEC 23090-31) in its JSON form, .hjif: perceptions, channels with their
///   gain, bands (transients, curves, vectorial waves) and key frames; effects of the library. How
///   key frames are read is that of the MPEG reference software (Effect.cpp), whose encoder calls
///   every modality `Other` and writes a `relative_position` of -2 as 65534.
/// `decode_pattern` takes what comes of it, once it has a name. kBadData: what is wrong.
Outcome<Imported> import_pattern(std::string_view text);

}  // namespace hedgehog::client
