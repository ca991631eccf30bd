// SPDX-License-Identifier: MIT
#include "clients/study/journal/codec.h"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/parse_json.h"
#include "clients/study/experiment_file.h"

namespace hedgehog::study {

namespace {

using nlohmann::ordered_json;

template <class T>
ordered_json or_null(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

template <class T>
std::optional<T> maybe(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? std::nullopt
                                                   : std::optional<T>(found->get<T>());
}

ordered_json daemon_json(const DaemonFacts& daemon) {
  return {{"address", daemon.address}, {"start_id", daemon.start_id}};
}

/// Reads the member `daemon`, which is missing in older journals.
DaemonFacts read_daemon(const ordered_json& in) {
  const auto daemon = in.find("daemon");
  if (daemon == in.end()) return {};
  return {daemon->at("address"), daemon->at("start_id")};
}

void write(ordered_json& out, const RunStarted& e) {
  out["event"] = "run_started";
  out["participant"] = e.participant;
  out["run"] = e.run;
  out["seeds"] = {{"order", e.seeds.order}, {"catches", e.seeds.catches}};
  out["ball"] = {{"name", e.ball.name},
                 {"model", e.ball.model},
                 {"serial", or_null(e.ball.serial)},
                 {"simulated", e.ball.simulated},
                 {"force_n_per_a", e.ball.force_n_per_a}};
  out["daemon"] = daemon_json(e.daemon);
  out["simulated_person"] = e.simulated_person;
  out["software_version"] = e.software_version;
  out["blind"] = e.blind;
  out["person_seed"] = e.person_seed;
  out["experiment"] = ordered_json::parse(experiment_text(e.experiment));
}

RunStarted read_run_started(const ordered_json& in) {
  RunStarted e;
  e.participant = in.at("participant");
  e.run = in.at("run");
  e.seeds = {in.at("seeds").at("order"), in.at("seeds").at("catches")};
  const ordered_json& ball = in.at("ball");
  e.ball = {ball.at("name"), ball.at("model"), maybe<std::string>(ball, "serial"),
            ball.at("simulated"), ball.at("force_n_per_a")};
  e.daemon = read_daemon(in);
  e.simulated_person = in.at("simulated_person");
  e.software_version = in.at("software_version");
  e.blind = in.value("blind", false);
  e.person_seed = in.value("person_seed", std::uint64_t{0});
  e.experiment = parse_experiment(in.at("experiment").dump(), "experiment").value();
  return e;
}

void write(ordered_json& out, const Checklist& e) {
  out["event"] = "checklist";
  out["headphones"] = e.headphones;
  out["hand_on_top"] = e.hand_on_top;
  out["consent"] = e.consent;
  out["hand_size_cm"] = or_null(e.hand_size_cm);
  out["dominant_hand"] = e.dominant_hand;
  out["age_band"] = e.age_band;
  out["experimenter"] = e.experimenter;
}

Checklist read_checklist(const ordered_json& in) {
  return {in.at("headphones"),    in.at("hand_on_top"),
          in.at("consent"),       maybe<double>(in, "hand_size_cm"),
          in.at("dominant_hand"), in.at("age_band"),
          in.at("experimenter")};
}

void write(ordered_json& out, const TrialStarted& e) {
  out["event"] = "trial_started";
  out["kind"] = name(e.trial.kind);
  out["trial"] = e.trial.number;
  out["attempt"] = e.trial.attempt;
  out["level"] = e.trial.level;
  out["interval_of_test"] = e.trial.interval_of_test;
}

TrialStarted read_trial_started(const ordered_json& in) {
  const auto kind = trial_kind_named(in.at("kind").get<std::string>());
  if (!kind) throw std::runtime_error("unknown kind of trial");
  return {{*kind, in.at("trial"), in.at("attempt"), in.at("level"), in.at("interval_of_test")}};
}

void write(ordered_json& out, const IntervalPlayed& e) {
  out["event"] = "interval";
  out["interval"] = e.interval;
  out["current_a"] = e.stimulus.current_a;
  out["speed_pins_s"] = e.stimulus.speed_pins_s;
  out["command_ns"] = e.command_ns;
  out["ack_ns"] = e.ack_ns;
  out["onset_ns"] = or_null(e.onset_ns);
  out["offset_ns"] = or_null(e.offset_ns);
  out["reason"] = e.reason;
  out["delivered_min"] = or_null(e.delivered_min);
  out["delivered_mean"] = or_null(e.delivered_mean);
  out["masked_ms"] = or_null(e.masked_ms);
  out["mixed_ms"] = or_null(e.mixed_ms);
  out["measured_a"] = or_null(e.measured_a);
  out["temperature_c"] = or_null(e.temperature_c);
  out["orientation"] = nullptr;
  if (e.orientation)
    out["orientation"] = {e.orientation->w, e.orientation->x, e.orientation->y, e.orientation->z};
}

std::optional<model::Quaternion> read_orientation(const ordered_json& in) {
  const auto q = maybe<std::array<double, 4>>(in, "orientation");
  if (!q) return std::nullopt;
  return model::Quaternion{(*q)[0], (*q)[1], (*q)[2], (*q)[3]};
}

IntervalPlayed read_interval(const ordered_json& in) {
  return {in.at("interval"),
          {in.at("current_a"), in.at("speed_pins_s")},
          in.at("command_ns"),
          in.at("ack_ns"),
          maybe<std::int64_t>(in, "onset_ns"),
          maybe<std::int64_t>(in, "offset_ns"),
          in.at("reason"),
          maybe<double>(in, "delivered_min"),
          maybe<double>(in, "delivered_mean"),
          maybe<std::int64_t>(in, "masked_ms"),
          maybe<std::int64_t>(in, "mixed_ms"),
          maybe<double>(in, "measured_a"),
          maybe<double>(in, "temperature_c"),
          read_orientation(in)};
}

void write(ordered_json& out, const Answered& e) {
  out["event"] = "answered";
  out["answer"] = name(e.answer);
  out["response_ms"] = e.response_ms;
}

Answered read_answered(const ordered_json& in) {
  const auto answer = answer_named(in.at("answer").get<std::string>());
  if (!answer) throw std::runtime_error("unknown answer");
  return {*answer, in.at("response_ms")};
}

void write(ordered_json& out, const Voided& e) {
  out["event"] = "voided";
  out["reason"] = e.reason;
}

void write(ordered_json& out, const DaemonChanged& e) {
  out["event"] = "daemon_changed";
  out["text"] = e.daemon.address;  // older versions of the program read it as a remark
  out["daemon"] = daemon_json(e.daemon);
}

void write(ordered_json& out, const Remark& e) {
  out["event"] = e.kind;
  out["text"] = e.text;
}

Event read_event(const ordered_json& in) {
  const std::string event = in.at("event");
  if (event == "run_started") return read_run_started(in);
  if (event == "checklist") return read_checklist(in);
  if (event == "trial_started") return read_trial_started(in);
  if (event == "interval") return read_interval(in);
  if (event == "answered") return read_answered(in);
  if (event == "voided") return Voided{in.at("reason")};
  if (event == "daemon_changed") return DaemonChanged{read_daemon(in)};
  return Remark{event, in.at("text")};
}

}  // namespace

std::string encode(const Line& line) {
  ordered_json out;
  out["n"] = line.number;
  out["time"] = line.time;
  std::visit([&](const auto& event) { write(out, event); }, line.event);
  // Text typed by the user may not be UTF-8; the line must not be lost.
  return out.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

Result<Line> decode(std::string_view text) {
  const auto parsed = base::parse_json<ordered_json>(text);
  if (!parsed.good()) return Problem{EX_DATAERR, parsed.problem};
  try {
    const ordered_json& in = parsed.value;
    return Line{in.at("n"), in.at("time"), read_event(in)};
  } catch (const std::exception& error) {
    return Problem{EX_DATAERR, error.what()};
  }
}

}  // namespace hedgehog::study
