// SPDX-License-Identifier: MIT
#include "tests/protocol/schema_text.h"

#include <map>

namespace hedgehog::protocol {

std::string_view meaning_of(std::string_view parameter) {
  static const std::map<std::string_view, std::string_view> kMeanings{
      {"direction", "Where the pins push out."},
      {"axis", "The axis of the circle."},
      {"ring_deg", "Angle between the axis and the circle; 90 is the equator."},
      {"speed_pins_s", "Steps a second; a step is the pitch of the pins."},
      {"sense", "As seen from outside along the axis."},
      {"stepping", "From pin to pin, or gliding."},
      {"frame", "The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)."},
      {"level", "Strength as a part of limits.current_a."},
      {"current_a", "Strength as a current; at most limits.current_a."},
      {"force_n", "Strength as the force on the pin that is pointed at."},
      {"gain", "Multiplies the strength."},
      {"start_at_ns", "Device time of the onset."},
      {"delay_ms", "From now to the onset."},
      {"attack_ms", "Linear rise, inside the duration."},
      {"fade_ms", "Linear fall, inside the duration; not with a lease."},
      {"attack_level", "Where the rise begins, as a part of the strength."},
      {"fade_level", "Where the fall ends, as a part of the strength."},
      {"waveform", "Runs between 0 and the strength."},
      {"on_fraction", "The part of a period that a square is on."},
      {"since", "Not before this time, RFC 3339."},
      {"limit", "The newest so many."},
      {"pattern", "The name of a pattern, or keyframes instead."},
      {"keyframes", "Where and how strongly, at points in time; t_ms never falls."},
      {"rotate_to", "Patterns face front; this turns the front there by the shortest way."},
      {"rate", "So many times as fast."},
      {"loop", "Begins again at its end."},
      {"name", "Of a pattern: vendor/name, or that of a shipped one."},
      {"description", "One sentence for whoever chooses a pattern."},
      {"duration_ms", "The effect ends after it. Never together with lease_ms."},
      {"lease_ms", "Ends after it unless renewed."},
      {"on_close",
       "\"finish\" lets an effect of up to 2000 ms play out after the connection ended."},
      {"slot", "The connection's own name for an effect."},
      {"priority",
       "Only effects of the highest active priority are output; 8 and 9 need the role operate."},
      {"if_limited", "\"refuse\": an error instead of a reduced effect."},
      {"effect", "The number of an effect, from its admission."},
      {"scope", "\"all\" for effects of others too."},
      {"client", "Name and version of the client, for the operator."},
      {"protocol", "The protocol version of the client."},
      {"token", "Gives the connection the token's role."},
      {"quaternion", "Device to world, of length 1."},
      {"orientation", "Device to world, of length 1."},
      {"azimuth_deg", "Anticlockwise seen from above."},
      {"fields", "Keys of the status object; default all but pins."},
      {"types", "Names of events; default all."},
      {"method", "A method that plays."},
      {"params", "The parameters of that method."},
      {"ambient_c", "Temperature of the simulated room."},
      {"fault", "Replaces all simulated faults; {} clears them."},
      {"errors", "Replaces all errors of measurement and of the ball; [] ends them."},
  };
  const auto found = kMeanings.find(parameter);
  return found == kMeanings.end() ? std::string_view{} : found->second;
}

std::string_view meaning_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kParseError:
      return "The line is not JSON.";
    case ErrorCode::kInvalidRequest:
      return "JSON, but no request.";
    case ErrorCode::kMethodNotFound:
      return "There is no such method.";
    case ErrorCode::kInvalidParams:
      return "A parameter is unknown, missing, of the wrong type, out of range, or at odds with "
             "another.";
    case ErrorCode::kInternalError:
      return "A bug; or the request was applied, but not written to disk.";
    case ErrorCode::kNotArmed:
      return "Nothing can be played: state, reason and remedy say why.";
    case ErrorCode::kBusy:
      return "A queue or pool is full, or the daemon is stopping; nothing was changed.";
    case ErrorCode::kNoSuchEffect:
      return "The effect has ended, or belongs to another connection.";
    case ErrorCode::kUnauthorized:
      return "The token is unknown or revoked.";
    case ErrorCode::kForbidden:
      return "It needs role_needed.";
    case ErrorCode::kDeviceAbsent:
      return "There is no board, or no orientation sensor.";
    case ErrorCode::kUnsupported:
      return "Not by this server, not in this configuration.";
    case ErrorCode::kRefusedThermal:
      return "The thermal limit would reduce the effect, and if_limited is refuse.";
    case ErrorCode::kNoSuchPattern:
      return "There is no pattern of that name.";
    case ErrorCode::kClaimed:
      return "Another client has exclusive use of the ball, or sets its orientation.";
    case ErrorCode::kArmed:
      return "It is refused while the ball is armed.";
  }
  return {};
}

}  // namespace hedgehog::protocol
