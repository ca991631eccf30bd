// SPDX-License-Identifier: MIT
// Incremental reading of sound files, in the formats of libsndfile (WAV, FLAC, Ogg, AIFF, MP3).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "clients/lib/client_error.h"

namespace hedgehog::sound {

inline constexpr int kMinRateHz = 8'000;
inline constexpr int kMaxRateHz = 192'000;
inline constexpr int kMaxChannels = 8;
inline constexpr double kMaxFileSeconds = 24.0 * 3600.0;

/// One sample of both channels, -1..1.
struct StereoSample {
  double left = 0.0;
  double right = 0.0;
};

/// Movable; one thread at a time. Memory use is independent of the file's length.
class SoundFile {
 public:
  /// kNoInput: missing, or not a regular file; kBadData: not a sound file, or beyond the limits
  /// above.
  static client::Outcome<SoundFile> open(const std::string& path);
  SoundFile(SoundFile&&) noexcept;
  SoundFile& operator=(SoundFile&&) noexcept;
  ~SoundFile();

  double rate_hz() const noexcept;
  double seconds() const noexcept;
  /// The next `count` samples, fewer at the end, none after it. A mono channel is used for both
  /// sides; of more than two channels the first is left, the second right, and the others are added
  /// to both, halved. Non-finite values are 0, those beyond full scale are clamped.
  std::vector<StereoSample> read(std::size_t count);

 private:
  struct Open;
  explicit SoundFile(std::unique_ptr<Open> file);

  std::unique_ptr<Open> file_;
};

}  // namespace hedgehog::sound
