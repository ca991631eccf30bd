// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/play_verbs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "clients/common/interrupts.h"
#include "clients/ctl/patterns/pattern_file.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/preview_screen.h"
#include "clients/ctl/terminal/words.h"
#include "model/geometry/pin_array.h"
#include "protocol/methods.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;
using std::chrono::milliseconds;

constexpr milliseconds kEndPoll{50};
// Telemetry times the renewals: its rate, like the lease, is in device time (--speed).
constexpr double kRenewalHz = 20.0;

std::string verb_of(const std::string& method) { return method.substr(method.find('.') + 1); }

/// Waits for the end of `effect`, renewing its lease if it has one; nullopt if interrupted.
class EffectWait {
 public:
  EffectWait(Session& session, std::uint32_t effect, const PlayOptions& options)
      : session_(session), effect_(effect), held_(options.held()), hold_s_(options.hold_s) {}

  Outcome<std::optional<protocol::EventMessage>> wait() {
    if (auto sent = subscribe_time(); !sent) return sent.error();
    while (!interrupted()) {
      auto notification = session_.connection.next(kEndPoll);
      if (!notification) return notification.error();
      if (!*notification) continue;
      if (const auto* event = std::get_if<protocol::EventMessage>(&**notification)) {
        if (event->event.type == "effect_ended" && event->event.effect == effect_)
          return std::optional(*event);
      } else if (auto kept = renew_lease(std::get<protocol::TelemetryMessage>(**notification));
                 !kept) {
        return kept.error();
      }
    }
    return std::optional<protocol::EventMessage>{};
  }

  /// A hold that was stopped after its requested duration is complete.
  bool stopped_in_time() const noexcept { return stopped_; }

 private:
  Outcome<void> subscribe_time() {
    if (!held_) return {};
    protocol::StatusKeys only_time;
    only_time.add(protocol::StatusKey::kTimeNs);
    const auto sent = session_.connection.call(protocol::TelemetrySubscribe{kRenewalHz, only_time});
    return sent ? Outcome<void>() : Outcome<void>(sent.error());
  }

  Outcome<void> renew_lease(const protocol::TelemetryMessage& message) {
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

/// The step of a circle on the connected ball; a default for other methods.
double pitch_deg(Session& session, const PlayOptions& options) {
  if (options.method == "effect.circle")
    if (const auto description = session.connection.call(protocol::DeviceDescribe{}))
      return model::pin_pitch_deg(pin_array(*description));
  return model::kThesisPitchDeg;
}

/// `given` with its file and an end; what was left out of the file is reported on stderr.
Outcome<PlayOptions> with_file_and_end(Session& session, const PlayOptions& given) {
  auto read = with_file(given);
  if (!read) return read.error();
  print_notes(given.pattern, read->notes);
  return with_end(std::move(read->options), pitch_deg(session, given));
}

}  // namespace

int run_preview(Session& session, const PlayOptions& given) {
  const auto completed = with_file_and_end(session, given);
  if (!completed) return report_error(completed.error());
  const PlayOptions& options = *completed;
  const auto params = play_params(options);
  if (!params) return report_error(params.error());
  json request{{"method", options.method}, {"params", json::parse(*params)}};
  if (options.hold_s) {
    request["params"]["lease_ms"] =
        std::min(1000.0 * *options.hold_s, static_cast<double>(protocol::kMaxLeaseMs));
  }
  const auto response = session.connection.call_raw("effect.preview", request.dump());
  if (!response) return report_error(response.error());
  if (session.json) {
    std::puts(response->c_str());
    return kDone;
  }
  const auto preview = protocol::decode_result<protocol::PreviewResult>(*response);
  if (!preview) return report_error({Failure::kProtocol, preview.error().message, {}});
  for (const std::string& line : preview_screen(words_of(options), *preview, session.style.ascii))
    std::puts(line.c_str());
  return kDone;
}

int run_play(Session& session, const PlayOptions& given) {
  const auto completed = with_file_and_end(session, given);
  if (!completed) return report_error(completed.error());
  const PlayOptions& options = *completed;
  const auto params = play_params(options);
  if (!params) return report_error(params.error());
  if (auto hello = session.connection.hello("hedgehogctl"); !hello)
    return report_error(hello.error());
  if (auto events = session.connection.call(protocol::EventsSubscribe{{"effect_ended"}}); !events)
    return report_error(events.error());
  const auto response = session.connection.call_raw(options.method, *params);
  if (!response) return report_error(response.error());
  const auto admission = protocol::decode_result<protocol::Admission>(*response);
  if (!admission) return report_error({Failure::kProtocol, admission.error().message, {}});
  if (session.json) {
    std::puts(response->c_str());
    std::fflush(stdout);
  } else {
    print_start(options, *admission);
  }

  EffectWait effect_wait(session, admission->effect, options);
  const auto ended = effect_wait.wait();
  if (!ended) {
    if (!session.json) std::puts("");
    return report_error(ended.error());
  }
  if (!*ended) {
    if (!session.json) std::puts("   interrupted");
    return kInterrupted;
  }
  const bool complete = (*ended)->event.reason == "completed" || effect_wait.stopped_in_time();
  if (session.json) {
    std::puts((*ended)->json.c_str());
  } else {
    print_end((*ended)->event,
              effect_wait.stopped_in_time() ? "completed" : (*ended)->event.reason.value_or(""));
  }
  return complete ? kDone : kEndedOtherwise;
}

}  // namespace hedgehog::client
