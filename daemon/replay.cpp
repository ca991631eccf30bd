// SPDX-License-Identifier: MIT
#include "daemon/replay.h"

#include <sysexits.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "daemon/control/recording/recording.h"

namespace hedgehog::daemon {
namespace {

using Json = nlohmann::ordered_json;

Json events_of(const control::ReplayedTick& t) {
  Json names = Json::array();
  for (const control::Event& event : t.events) names.push_back(control::name(event.type));
  return names;
}

Json tick_of(const control::ReplayedTick& t) {
  control::StatusSnapshot snapshot;
  t.controller.fill(snapshot);
  Json json{{"tick", t.inputs.tick},
            {"state", control::name(t.replayed.state)},
            {"reason", nullptr},
            {"sensor_c", t.inputs.board.sensor_c},
            {"model_c", t.replayed.hottest_c},
            {"asked_a", model::norm(snapshot.demand_a)},
            {"current_a", model::norm(t.replayed.passed_a)},
            {"measured_a", model::norm(t.inputs.board.current_a)},
            {"events", events_of(t)},
            {"same", t.same}};
  if (t.replayed.reason != control::Reason::kNone)
    json["reason"] = control::name(t.replayed.reason);
  return json;
}

}  // namespace

int replay(const std::string& path, std::ostream& out, std::ostream& errors) {
  const control::ReplayResult result = control::replay_recording(
      path, [&out](const control::ReplayedTick& t) { out << tick_of(t).dump() << '\n'; });
  switch (result.error) {
    case control::ReplayError::kUnreadable:
      errors << path << ": cannot be read\n";
      return EX_NOINPUT;
    case control::ReplayError::kNotARecording:
      errors << path << ": not a recording, or damaged\n";
      return EX_DATAERR;
    case control::ReplayError::kOtherBuild:
      errors << path << ": written by another build of hedgehogd (" << result.written_by << ")\n";
      return EX_UNAVAILABLE;
    case control::ReplayError::kNone:
      break;
  }
  out << Json{{"ticks", result.ticks},
              {"different", result.different},
              {"written_by", result.written_by}}
             .dump()
      << '\n';
  return result.different == 0 ? EX_OK : 1;
}

}  // namespace hedgehog::daemon
