// SPDX-License-Identifier: MIT
// Flight recordings of trips: `trip-0001.hhr` in the state directory, newest 50, at most 20 MB.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "daemon/control/recording/flight_recorder.h"
#include "daemon/server/disk/disk_thread.h"

namespace hedgehog::server {

/// Numbers of the stored recordings. Any thread.
class RecordingNumbers {
 public:
  void set(std::set<unsigned> numbers);
  bool contains(unsigned number) const;

 private:
  mutable std::mutex mutex_;
  std::set<unsigned> numbers_;
};

/// A recording being read.
struct RecordingRead {
  std::atomic<bool> done{false};
  std::string bytes;  // valid once done; empty: removed or unreadable
};

class TripRecordings {
 public:
  static constexpr std::size_t kMaxFiles = 50;
  static constexpr std::uintmax_t kMaxBytes = 20u << 20;
  static constexpr std::size_t kMaxFileBytes = 6u << 20;  // exceeds the size of a recording

  /// Reads what is stored. `last_named`: highest number in the history; never reused, even if gone.
  TripRecordings(std::string directory, DiskThread& disk, control::FlightRecorder& recorder,
                 unsigned last_named);

  // io thread.

  /// The ball has tripped: the number of its recording, which the disk thread writes.
  unsigned tripped();
  bool has(unsigned number) const;  // written, and not yet removed for newer ones
  /// The whole recording, read on the disk thread; nullptr: the disk is too slow.
  std::shared_ptr<const RecordingRead> read(unsigned number) const;

 private:
  std::string directory_;
  DiskThread& disk_;
  control::FlightRecorder& recorder_;
  unsigned last_;
  std::shared_ptr<RecordingNumbers> written_;  // shared: the disk thread may outlive this
  /// A job for a trip is already queued.
  std::shared_ptr<std::atomic<bool>> queued_ = std::make_shared<std::atomic<bool>>(false);
};

/// "trip-0017"; and the number of such a name, 0 for other names.
std::string recording_name(unsigned number);
unsigned recording_number(std::string_view name);
unsigned recording_number_of_file(std::string_view file);  // of "trip-0017.hhr"
/// Path of recording `number` in `directory`, and the highest number there, 0: none.
std::string recording_path(const std::string& directory, unsigned number);
unsigned last_recording(const std::string& directory);
/// Removes the oldest recordings until the limits hold. Disk thread.
void prune_recordings(const std::string& directory, std::size_t max_files,
                      std::uintmax_t max_bytes);

}  // namespace hedgehog::server
