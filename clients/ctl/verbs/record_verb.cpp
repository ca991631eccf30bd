// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/record_verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "clients/common/interrupts.h"
#include "clients/ctl/arguments/direction_argument.h"
#include "clients/ctl/patterns/path.h"
#include "clients/ctl/patterns/pattern_file.h"
#include "model/quaternion.h"
#include "protocol/wire/direction.h"

namespace hedgehog::client {

namespace {

using model::Quaternion;
using model::Vec3;

constexpr double kRecordHz = 100.0;
constexpr Milliseconds kInterruptPoll{50};
/// Older measurements are outdated: the daemon reports the orientation as lost after 50 ms.
constexpr std::int64_t kStaleMs = 50;

/// The pointer as a unit vector in the device frame.
Outcome<Vec3> pointer_of(Session& session, const std::string& text) {
  const auto direction_text = direction_json(text);
  if (!direction_text) return direction_text.error();
  // The decoder of key frames accepts all directions of the protocol.
  const auto pattern = protocol::decode_pattern(
      R"({"name":"a/a","keyframes":[{"t_ms":1,"level":1,"direction":)" + *direction_text + "}]}");
  if (!pattern || !pattern->keyframes.front().direction)
    return ClientError{Failure::kBadAddress, "--pointer: '" + text + "' is no direction", {}};
  const auto description = session.connection.call(protocol::DeviceDescribe{});
  if (!description) return description.error();
  const auto direction = protocol::resolve(*pattern->keyframes.front().direction,
                                           pin_array(*description), "--pointer");
  if (!direction) return ClientError{Failure::kBadAddress, direction.error().message, {}};
  return *direction;
}

class Recorder {
 public:
  Recorder(const RecordOptions& options, const Vec3& pointer)
      : until_ms_(std::llround(
            1000.0 * std::min(options.seconds.value_or(kMaxRecordSeconds), kMaxRecordSeconds))),
        pointer_(pointer) {}

  /// False: the duration has elapsed.
  bool take(const protocol::Status& status) {
    const auto& orientation = status.orientation;
    if (begin_ns_ == 0) begin_ns_ = status.time_ns;
    if (!orientation || orientation->age_ms > kStaleMs) {
      ++lost_;
      return (status.time_ns - begin_ns_) / 1'000'000 < until_ms_;
    }
    if (points_.empty()) {
      begin_ns_ = status.time_ns;
      home_ = conjugate(orientation->quaternion);
    }
    const std::int64_t t_ms = (status.time_ns - begin_ns_) / 1'000'000;
    if (points_.empty() || t_ms > points_.back().t_ms) {
      const Vec3 points_to = rotate(home_ * orientation->quaternion, pointer_);
      points_.push_back({std::min(t_ms, until_ms_), model::unit_or(points_to, pointer_)});
    }
    return t_ms < until_ms_;
  }

  const std::vector<PathPoint>& points() const noexcept { return points_; }
  int lost() const noexcept { return lost_; }

 private:
  std::int64_t until_ms_;
  Vec3 pointer_;
  Quaternion home_{};
  std::int64_t begin_ns_ = 0;  // start of the recording, or of waiting for an orientation
  int lost_ = 0;
  std::vector<PathPoint> points_;
};

Outcome<void> record(Session& session, Recorder& recorder) {
  protocol::StatusKeys keys;
  keys.add(protocol::StatusKey::kOrientation);
  if (auto sent = session.connection.call(protocol::TelemetrySubscribe{kRecordHz, keys}); !sent)
    return sent.error();
  while (!interrupted()) {
    auto notification = session.connection.next(kInterruptPoll);
    if (!notification) return notification.error();
    if (!*notification) continue;
    const auto* message = std::get_if<protocol::TelemetryMessage>(&**notification);
    if (message != nullptr && !recorder.take(message->telemetry.status)) break;
  }
  return {};
}

int print_failed(const std::string& name, const std::string& message, int code) {
  print_failure(name, message);
  return code;
}

void print_recorded(const Session& session, const RecordOptions& options,
                    const SimplifiedPath& path, int lost) {
  const std::int64_t takes_ms = path.keyframes.back().t_ms;
  if (session.json) {
    std::puts(nlohmann::json{{"file", options.file},
                             {"duration_ms", takes_ms},
                             {"keyframes", path.keyframes.size()},
                             {"error_deg", std::round(path.error_deg * 100.0) / 100.0},
                             {"lost", lost}}
                  .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
                  .c_str());
    return;
  }
  fmt::print("{}: {:.1f} s as {} key frames, off by {:.1f} degrees at most: hedgehogctl play {}\n",
             options.file, static_cast<double>(takes_ms) / 1000.0, path.keyframes.size(),
             path.error_deg, options.file);
  if (lost > 0) fmt::print(stderr, "hedgehogctl: the orientation was not known {} times\n", lost);
}

/// Checks what would otherwise fail only after the recording; kDone: valid.
int check_before(const RecordOptions& options) {
  std::error_code ec;
  if (!options.replace && std::filesystem::exists(options.file, ec))
    return print_failed("failed", options.file + " is there already; --force replaces it",
                        kCannotCreate);
  const auto folder = std::filesystem::path(options.file).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ec))
    return print_failed("failed", options.file + ": there is no folder " + folder.string(),
                        kCannotCreate);
  protocol::Pattern any;
  any.name = options.name;
  any.keyframes = {{.t_ms = 1, .level = 0.0}};
  const auto good = protocol::decode_pattern(pattern_text(any));
  return good ? static_cast<int>(kDone) : print_failed("usage", good.error().message, kUsage);
}

}  // namespace

int run_record(Session& session, const RecordOptions& options) {
  if (const int code = check_before(options); code != kDone) return code;
  if (auto hello = session.connection.hello("hedgehogctl"); !hello)
    return report_error(hello.error());
  const auto pointer = pointer_of(session, options.pointer);
  if (!pointer) return report_error(pointer.error());
  if (!session.json)
    fmt::print(stderr, "Turn the ball{}. Ctrl-C ends the recording.\n",
               options.seconds ? fmt::format(" for {:g} s", *options.seconds) : std::string());
  Recorder recorder(options, *pointer);
  const auto recorded = record(session, recorder);
  if (recorder.points().size() < 2) {
    if (!recorded) return report_error(recorded.error());
    return print_failed(
        "failed", "nothing was recorded: the ball has no orientation sensor, or it was too short",
        kUnavailable);
  }
  const SimplifiedPath path =
      simplify_path(recorder.points(), options.tolerance_deg, options.level);
  protocol::Pattern pattern;
  pattern.name = options.name;
  pattern.keyframes = path.keyframes;
  const std::string text = pattern_text(pattern) + "\n";
  if (const std::string problem = base::write_file_atomically(options.file, text); !problem.empty())
    return print_failed("failed", options.file + ": " + problem, kCannotCreate);
  print_recorded(session, options, path, recorder.lost());
  // What was recorded before a lost connection is kept.
  return recorded ? static_cast<int>(kDone) : static_cast<int>(report_error(recorded.error()));
}

}  // namespace hedgehog::client
