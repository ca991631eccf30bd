// SPDX-License-Identifier: MIT
// What the flight recorder holds when the ball trips, as files `trip-0001.hhr` in the state
// directory: the newest 50, and at most 20 MB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "daemon/control/flight_recorder.h"
#include "daemon/server/disk_thread.h"

namespace hedgehog::server {

class TripRecordings {
 public:
  static constexpr std::size_t kMaxFiles = 50;
  static constexpr std::uintmax_t kMaxBytes = 20u << 20;

  TripRecordings(std::string directory, DiskThread& disk, control::FlightRecorder& recorder)
      : directory_(std::move(directory)), disk_(disk), recorder_(recorder) {}

  /// io thread: the ball has tripped. The rest happens on the disk thread.
  void tripped();

 private:
  std::string directory_;
  DiskThread& disk_;
  control::FlightRecorder& recorder_;
};

/// Path for the next recording in `directory`.
std::string next_recording(const std::string& directory);
/// Removes the oldest recordings until the limits hold. Disk thread.
void prune_recordings(const std::string& directory, std::size_t max_files,
                      std::uintmax_t max_bytes);

}  // namespace hedgehog::server
