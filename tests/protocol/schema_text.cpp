// SPDX-License-Identifier: MIT
#include "tests/protocol/schema_text.h"

#include <map>

namespace hedgehog::protocol {

std::string_view summary_of(Method method) {
  static const std::map<Method, std::string_view> kSummaries{
      {Method::kConnectionList, "Who is connected, since when, and what they play."},
      {Method::kDeviceArm, "Lets the coils be driven again, when the cause of the stop is gone."},
      {Method::kDeviceClaim, "Only this connection plays until it releases, ends, or is silent."},
      {Method::kDeviceDescribe, "The ball: pins, coils, limits, calibration, identity."},
      {Method::kDeviceEmergencyStop, "Coils off at the next tick, latched until armed."},
      {Method::kDeviceList, "USB and HID devices: which are used, and why the others are not."},
      {Method::kDeviceRelease, "Gives a claim back."},
      {Method::kDeviceStatus, "Everything that can be known of the ball now."},
      {Method::kEffectCircle, "The field walks round an axis, from pin to pin."},
      {Method::kEffectHold, "A push that lasts as long as it is renewed."},
      {Method::kEffectPlay, "Plays key frames, of a named pattern or its own."},
      {Method::kEffectPreview, "What an effect would do, without doing it."},
      {Method::kEffectPulse, "One push towards a direction."},
      {Method::kEffectStop, "Ends one of the connection's own effects."},
      {Method::kEffectStopAll, "Ends all effects of the connection, or of everybody."},
      {Method::kEffectUpdate, "Changes a playing effect and renews its lease."},
      {Method::kEffectVibrate, "A push with a waveform."},
      {Method::kEventsHistory, "What has happened, also before the last start."},
      {Method::kEventsSubscribe, "Asks for notifications of what happens."},
      {Method::kEventsUnsubscribe, "Ends the subscription to events."},
      {Method::kHello, "Introduces the client; answers who the server is and what it allows."},
      {Method::kOrientationRecenter, "The front of the ball points at this azimuth now."},
      {Method::kOrientationSet, "Feeds the orientation from outside."},
      {Method::kOutputSetGain, "The owner's comfort setting for everything, stored."},
      {Method::kPatternGet, "One named pattern with its key frames."},
      {Method::kPatternList, "The named patterns there are."},
      {Method::kPatternPut, "Keeps a pattern under vendor/name."},
      {Method::kPatternRemove, "Forgets a pattern that was put."},
      {Method::kPing, "The device time."},
      {Method::kSimSet, "Changes the simulated world."},
      {Method::kSimTruth, "The simulated ball as it really is."},
      {Method::kTelemetrySubscribe, "Asks for the status again and again."},
      {Method::kTelemetryUnsubscribe, "Ends the subscription to telemetry."},
      {Method::kThermalForecast, "How long a current or an effect can flow."},
  };
  return kSummaries.at(method);
}

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
      {"priority", "Only the highest active one is felt; 8 and 9 need the role operate."},
      {"if_limited", "\"refuse\": an error instead of less than what was asked."},
      {"effect", "The number of an effect, from its admission."},
      {"scope", "\"all\" for effects of others too."},
      {"client", "Name and version of the client, for the operator."},
      {"protocol", "The version that the client speaks."},
      {"token", "Gives the connection the token's role."},
      {"quaternion", "Device to world, of length 1."},
      {"orientation", "Device to world, of length 1."},
      {"azimuth_deg", "Anticlockwise seen from above."},
      {"fields", "Keys of the status object; default all but pins."},
      {"types", "Names of events; default all."},
      {"method", "A method that plays."},
      {"params", "The parameters of that method."},
      {"ambient_c", "Temperature of the simulated room."},
      {"fault", "Replaces all simulated faults; {} mends the ball."},
      {"errors", "Replaces all errors of measurement and of the ball; [] ends them."},
  };
  const auto found = kMeanings.find(parameter);
  return found == kMeanings.end() ? std::string_view{} : found->second;
}

}  // namespace hedgehog::protocol
