// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/play_verbs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "clients/common/interrupts.h"
#include "clients/ctl/arguments/direction_argument.h"
#include "clients/ctl/arguments/text_argument.h"
#include "clients/ctl/effect_options.h"
#include "clients/ctl/patterns/pattern_file.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/preview_screen.h"
#include "clients/ctl/terminal/words.h"
#include "model/effect/effect.h"
#include "model/geometry/direction.h"
#include "model/geometry/pin_array.h"
#include "protocol/methods.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;
using std::chrono::milliseconds;

constexpr milliseconds kEndPoll{50};
// Telemetry tells when to renew: its rate, like the lease, counts the device's time (--speed).
constexpr double kRenewalHz = 20.0;
constexpr int kHoldLeaseMs = 1000;

/// A parameter as typed: a number where it reads as one, else a word, which the daemon refuses with
/// the parameter's name.
json typed(const std::string& text) {
  const json number = json::parse(text, nullptr, false);
  return number.is_number() || number.is_boolean() ? number : json(text);
}

bool is_given(const PlayOptions& options, std::string_view parameter) {
  return std::any_of(
      options.params.begin(), options.params.end(),
      [&](const auto& given) { return given.first == parameter; });
}

/// A number among the parameters, or what it is when it is not given.
std::optional<double> number_of(const PlayOptions& options, std::string_view parameter,
                                double otherwise) {
  double number = otherwise;
  for (const auto& [name, text] : options.params) {
    if (name != parameter) continue;
    const json value = typed(text);
    if (!value.is_number()) return std::nullopt;
    number = value.get<double>();
  }
  return number;
}

/// The value of a parameter on the wire, as JSON text.
Outcome<std::string> wire_value(protocol::FieldType type, const std::string& name,
                                const std::string& text) {
  switch (type) {
    case protocol::FieldType::kText:
    case protocol::FieldType::kEnumerator:
      return text_json(name, text);
    case protocol::FieldType::kDirection:
      return direction_json(text);
    case protocol::FieldType::kList:
    case protocol::FieldType::kObject:
      if (!json::accept(text)) return ClientError{Failure::kBadAddress, name + ": is not JSON", {}};
      return text;
    case protocol::FieldType::kBoolean:
    case protocol::FieldType::kNumber:
      break;
  }
  const json number = typed(text);
  return number.is_string() ? text_json(name, text) : number.dump();
}

std::string verb_of(const std::string& method) { return method.substr(method.find('.') + 1); }

/// Waits for the end of `effect`, renewing its lease when it is held; nothing when the person
/// interrupts.
class Stay {
 public:
  Stay(Session& session, std::uint32_t effect, const PlayOptions& options)
      : session_(session), effect_(effect), held_(options.held()), hold_s_(options.hold_s) {}

  Outcome<std::optional<protocol::EventMessage>> wait() {
    if (auto asked = ask_for_time(); !asked) return asked.error();
    while (!interrupted()) {
      auto notification = session_.connection.next(kEndPoll);
      if (!notification) return notification.error();
      if (!*notification) continue;
      if (const auto* event = std::get_if<protocol::EventMessage>(&**notification)) {
        if (event->event.type == "effect_ended" && event->event.effect == effect_)
          return std::optional(*event);
      } else if (auto kept = keep_going(std::get<protocol::TelemetryMessage>(**notification));
                 !kept) {
        return kept.error();
      }
    }
    return std::optional<protocol::EventMessage>{};
  }

  /// A hold that was stopped because its time was over has done what was asked.
  bool stopped_in_time() const noexcept { return stopped_; }

 private:
  Outcome<void> ask_for_time() {
    if (!held_) return {};
    protocol::StatusKeys only_time;
    only_time.add(protocol::StatusKey::kTimeNs);
    const auto asked =
        session_.connection.call(protocol::TelemetrySubscribe{kRenewalHz, only_time});
    return asked ? Outcome<void>() : Outcome<void>(asked.error());
  }

  Outcome<void> keep_going(const protocol::TelemetryMessage& message) {
    const std::int64_t now_ns = message.telemetry.status.time_ns;
    if (!started_) {
      started_ = true;
      start_ns_ = now_ns;
    }
    if (stopped_) return {};
    if (hold_s_ && static_cast<double>(now_ns - start_ns_) * 1e-9 >= *hold_s_) {
      stopped_ = true;
      return session_.connection.notify(protocol::EffectStop{effect_, std::nullopt});
    }
    return session_.connection.notify(protocol::EffectUpdate{effect_, {}});
  }

  Session& session_;
  std::uint32_t effect_;
  bool held_;
  bool stopped_ = false;
  std::optional<double> hold_s_;
  bool started_ = false;
  std::int64_t start_ns_ = 0;
};

/// "play tick left".
std::string words_of(const PlayOptions& options) {
  const std::string pattern = options.pattern.empty() ? "" : " " + options.pattern;
  const std::string direction = options.direction.empty() ? "" : " " + options.direction;
  return verb_of(options.method) + pattern + direction;
}

void print_start(const PlayOptions& options, const protocol::Admission& admission) {
  std::printf("%s   %s A   %s N at pin %lld", left(words_of(options), 10).c_str(),
              fixed(admission.current_a, 1).c_str(), fixed(admission.force_n, 3).c_str(),
              static_cast<long long>(admission.pin));
  if (admission.limited_by) std::printf("   limited by %s", admission.limited_by->c_str());
  std::fflush(stdout);
}

void print_end(const protocol::Event& event, const std::string& reason) {
  std::int64_t played_ms = 0;
  if (event.onset_ns && event.offset_ns)
    played_ms = (*event.offset_ns - *event.onset_ns) / 1'000'000;
  std::printf("   %lld ms   %s", static_cast<long long>(played_ms), reason.c_str());
  if (event.delivered && event.delivered->mean < 0.995)
    std::printf(", %s %% of its strength", fixed(100.0 * event.delivered->mean, 0).c_str());
  std::puts("");
}

}  // namespace

Outcome<std::string> play_params(const PlayOptions& options) {
  json params = json::object();
  if (!options.direction.empty()) {
    auto direction = direction_json(options.direction);
    if (!direction) return direction.error();
    params[options.method == "effect.play" ? "rotate_to" : "direction"] = json::parse(*direction);
  }
  if (!options.pattern.empty()) {
    if (!is_pattern_file(options.pattern)) {
      const auto pattern = text_json("pattern", options.pattern);
      if (!pattern) return pattern.error();
      params["pattern"] = json::parse(*pattern);
    } else if (const auto pattern = read_pattern(options.pattern); !pattern) {
      return pattern.error();
    } else {
      params.update(json::parse(protocol::encode_pattern(*pattern)));
      params.erase("name");
      params.erase("description");
    }
  }
  if (options.loop) params["loop"] = true;
  if (options.held()) params["lease_ms"] = kHoldLeaseMs;
  const auto method = protocol::enumerator_named<model::EffectMethod>(options.method);
  const auto known = method ? effect_options(*method) : std::vector<EffectOption>{};
  for (const auto& given : options.params) {
    const std::string& name = given.first;
    const auto option = std::find_if(known.begin(), known.end(),
                                     [&](const auto& one) { return one.parameter == name; });
    const auto type = option == known.end() ? protocol::FieldType::kNumber : option->type;
    const auto value = wire_value(type, name, given.second);
    if (!value) return value.error();
    params[name] = json::parse(*value);
  }
  return params.dump();
}

bool PlayOptions::held() const {
  const bool is_endless = method == "effect.hold" || loop;
  return hold_s || is_given(*this, "lease_ms") || (is_endless && !is_given(*this, "duration_ms"));
}

namespace {

/// The circle's step on the connected ball; others need none.
double pitch_deg(Session& session, const PlayOptions& options) {
  if (options.method == "effect.circle")
    if (const auto description = session.connection.call(protocol::DeviceDescribe{}))
      return model::pin_pitch_deg(pin_array(*description));
  return model::kThesisPitchDeg;
}

}  // namespace

PlayOptions with_end(PlayOptions options, double pitch_deg) {
  if (options.method != "effect.circle" || options.held() || is_given(options, "duration_ms"))
    return options;
  const protocol::EffectParams defaults = protocol::with_defaults(model::EffectMethod::kCircle, {});
  const auto ring_deg = number_of(options, "ring_deg", *defaults.ring_deg);
  const auto speed_pins_s = number_of(options, "speed_pins_s", *defaults.speed_pins_s);
  // The daemon refuses those that cannot be, with their names.
  if (!ring_deg || !speed_pins_s || !(*speed_pins_s > 0.0)) return options;
  const double round_s = model::circle_steps(*ring_deg, pitch_deg) / *speed_pins_s;
  if (1000.0 * round_s <= static_cast<double>(protocol::kMaxDurationMs))
    options.params.emplace_back("duration_ms", std::to_string(std::llround(1000.0 * round_s)));
  else
    options.hold_s = round_s;
  return options;
}

int run_preview(Session& session, const PlayOptions& given) {
  const PlayOptions options = with_end(given, pitch_deg(session, given));
  const auto params = play_params(options);
  if (!params) return complain(params.error());
  json asked{{"method", options.method}, {"params", json::parse(*params)}};
  if (options.hold_s) {
    asked["params"]["lease_ms"] =
        std::min(1000.0 * *options.hold_s, static_cast<double>(protocol::kMaxLeaseMs));
  }
  const auto answer = session.connection.call_raw("effect.preview", asked.dump());
  if (!answer) return complain(answer.error());
  if (session.json) {
    std::puts(answer->c_str());
    return kDone;
  }
  const auto preview = protocol::decode_result<protocol::PreviewResult>(*answer);
  if (!preview) return complain({Failure::kProtocol, preview.error().message, {}});
  for (const std::string& line : preview_screen(words_of(options), *preview, session.style.ascii))
    std::puts(line.c_str());
  return kDone;
}

int run_play(Session& session, const PlayOptions& given) {
  const PlayOptions options = with_end(given, pitch_deg(session, given));
  const auto params = play_params(options);
  if (!params) return complain(params.error());
  if (auto hello = session.connection.hello("hedgehogctl"); !hello) return complain(hello.error());
  if (auto events = session.connection.call(protocol::EventsSubscribe{{"effect_ended"}}); !events)
    return complain(events.error());
  const auto answer = session.connection.call_raw(options.method, *params);
  if (!answer) return complain(answer.error());
  const auto admission = protocol::decode_result<protocol::Admission>(*answer);
  if (!admission) return complain({Failure::kProtocol, admission.error().message, {}});
  if (session.json) {
    std::puts(answer->c_str());
    std::fflush(stdout);
  } else {
    print_start(options, *admission);
  }

  Stay stay(session, admission->effect, options);
  const auto ended = stay.wait();
  if (!ended) {
    if (!session.json) std::puts("");
    return complain(ended.error());
  }
  if (!*ended) {
    if (!session.json) std::puts("   interrupted");
    return kInterrupted;
  }
  const bool complete = (*ended)->event.reason == "completed" || stay.stopped_in_time();
  if (session.json) {
    std::puts((*ended)->json.c_str());
  } else {
    print_end((*ended)->event,
              stay.stopped_in_time() ? "completed" : (*ended)->event.reason.value_or(""));
  }
  return complete ? kDone : kEndedOtherwise;
}

}  // namespace hedgehog::client
