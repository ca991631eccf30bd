// SPDX-License-Identifier: MIT
#include "clients/ctl/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "clients/common/arguments.h"
#include "clients/common/interrupts.h"
#include "clients/ctl/calibrate/calibrate_verb.h"
#include "clients/ctl/demo/demo.h"
#include "clients/ctl/parameter_help.h"
#include "clients/ctl/verbs/act_verbs.h"
#include "clients/ctl/verbs/follow_verbs.h"
#include "clients/ctl/verbs/look_verbs.h"
#include "clients/ctl/verbs/pattern_verbs.h"
#include "clients/ctl/verbs/pins_verb.h"
#include "clients/ctl/verbs/play_verbs.h"

namespace hedgehog::client {

namespace {

std::string flag_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    app_.fallthrough();
    app_.set_version_flag("--version", std::string("hedgehogctl " HEDGEHOG_VERSION));
    app_.add_option("--address", common_.address,
                    "where the daemon listens: host:port or a socket's path (HEDGEHOG_ADDRESS)");
    app_.add_flag("--json", common_.json, "answers as JSON, for programs");
    app_.footer(
        "Exit: 0 done, 1 the effect ended otherwise than completed, 64 usage, 65 and 66 a file,"
        " 69 no daemon, no ball\nor not armed, 75 try later, 77 the role does not suffice, 130 "
        "interrupted.");
    add_looking();
    add_playing(&app_, run_play);
    add_preview();
    add_patterns();
    add_acting();
    add_calibrate();
    add_following();
    add_alone();
  }

  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& done) {
      return app_.exit(done);
    } catch (const CLI::ParseError& error) {
      const std::vector<std::string> unknown = app_.remaining();
      if (app_.get_subcommands().empty() && !unknown.empty()) {
        std::fprintf(stderr, "hedgehogctl: there is no '%s'; hedgehogctl --help lists the verbs\n",
                     unknown.front().c_str());
        return kUsage;
      }
      return print_usage(error);
    }
    return verb_();
  }

 private:
  using Verb = std::function<int(Session&)>;

  /// What is wrong, in the words of every other complaint, and where to read on.
  int print_usage(const CLI::ParseError& error) const {
    std::string what = error.what();
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
      what = "'" + extra_word() + "' is not understood";
    else if (app_.get_subcommands().empty() && error.get_name() == "RequiredError")
      what = "a verb is missing";
    std::fprintf(stderr, "%s\n", usage_error(app_, what).c_str());
    return kUsage;
  }

  /// The first word that nothing takes; an unknown option rather than the value behind it.
  std::string extra_word() const {
    std::vector<std::string> words = app_.remaining(true);
    const auto option = std::find_if(
        words.begin(), words.end(), [](const std::string& word) { return word.starts_with("--"); });
    return option != words.end() ? *option : words.empty() ? std::string() : words.front();
  }

  /// `run` is what is to be done, over a connection.
  void connected(Verb run) {
    verb_ = [this, run = std::move(run)] {
      auto session = open_session(common_);
      return session ? run(*session) : static_cast<int>(complain(session.error()));
    };
  }

  /// A verb that needs a connection.
  CLI::App* verb(const std::string& name, const std::string& help, Verb run) {
    return verb_of(&app_, name, help, std::move(run));
  }
  CLI::App* verb_of(CLI::App* parent, const std::string& name, const std::string& help, Verb run) {
    CLI::App* command = parent->add_subcommand(name, help);
    command->callback([this, run = std::move(run)] { connected(run); });
    return command;
  }

  void add_looking() {
    verb("status", "the ball at one look", run_status);
    verb("devices", "what is connected, what is used, and why not", run_devices);
    verb("clients", "who is connected and what they play", run_clients);
    CLI::App* forecast = verb("forecast", "how long a current can flow", [this](Session& session) {
      return run_forecast(session, forecast_);
    });
    forecast->add_option("current_a", forecast_.current_a, "ampere")->capture_default_str();
    forecast->add_option("direction", forecast_.direction, "left, 34, 90,20 or 0,1,0.5");
    verb("trips", "when it tripped, why, and what played", run_trips);
  }

  template <class Parameters>
  void add_parameters(CLI::App* command, const Parameters& parameters) {
    for (const ParameterHelp& parameter : parameters) {
      const std::string name = parameter.name;
      command->add_option_function<std::string>(
          flag_of(name),
          [this, name](const std::string& text) { play_.params.emplace_back(name, text); },
          parameter.help);
    }
  }

  using Play = int (*)(Session&, const PlayOptions&);

  CLI::App* add_effect(CLI::App* parent, Play act, const std::string& name,
                       const std::string& help) {
    CLI::App* command = verb_of(parent, name, help, [this, act, name](Session& session) {
      play_.method = "effect." + name;
      return act(session, play_);
    });
    add_parameters(command, kPlayParameters);
    return command;
  }

  void add_playing(CLI::App* parent, Play act) {
    const char* towards =
        "where the pins push out: left, 34 (a pin), 90,20 (azimuth, elevation) "
        "or 0,1,0.5";
    CLI::App* pulse = add_effect(parent, act, "pulse", "one push");
    pulse->add_option("direction", play_.direction, towards)->required();
    add_parameters(pulse, kTimedParameters);
    CLI::App* circle = add_effect(parent, act, "circle", "a push that walks round the ball");
    add_parameters(circle, kTimedParameters);
    add_parameters(circle, kCircleParameters);
    CLI::App* vibrate = add_effect(parent, act, "vibrate", "many pushes a second");
    vibrate->add_option("direction", play_.direction, towards);
    add_parameters(vibrate, kTimedParameters);
    CLI::App* hold = add_effect(parent, act, "hold", "a push that stays, until Ctrl-C");
    hold->add_option("direction", play_.direction, towards)->required();
    hold->add_option("--for", play_.hold_s, "seconds; then it ends");
    CLI::App* play = add_effect(parent, act, "play", "a pattern, by its name or from a file");
    play->add_option("pattern", play_.pattern, "heartbeat, acme/knock, or mine.json")->required();
    play->add_option("rotate_to", play_.direction, "what its front turns to: left, 34, 90,20 ...");
    add_parameters(play, kTimedParameters);
    add_parameters(play, kPatternParameters);
    CLI::Option* loop = play->add_flag("--loop", play_.loop, "again and again, until Ctrl-C");
    play->add_option("--for", play_.hold_s, "with --loop: seconds; then it ends")->needs(loop);
  }

  void add_preview() {
    CLI::App* preview =
        app_.add_subcommand("preview", "what a verb that plays would do: preview pulse left ...");
    preview->require_subcommand(1);
    preview->fallthrough();
    add_playing(preview, run_preview);
  }

  void add_patterns() {
    CLI::App* patterns = app_.add_subcommand("patterns", "the named patterns: list, get, put ...");
    patterns->require_subcommand(0, 1);
    patterns->fallthrough();
    patterns->callback([this, patterns] {
      if (patterns->get_subcommands().empty()) connected(run_pattern_list);
    });
    verb_of(patterns, "list", "what there is", run_pattern_list);
    CLI::App* get = verb_of(patterns, "get", "one of them as JSON", [this](Session& session) {
      return run_pattern_get(session, pattern_);
    });
    get->add_option("name", pattern_)->required();
    CLI::App* put =
        verb_of(patterns, "put", "keeps one; its name is vendor/name",
                [this](Session& session) { return run_pattern_put(session, pattern_); });
    put->add_option("file", pattern_, "as `patterns get` prints it")->required();
    CLI::App* remove =
        verb_of(patterns, "remove", "forgets one that was put",
                [this](Session& session) { return run_pattern_remove(session, pattern_); });
    remove->add_option("name", pattern_)->required();
    CLI::App* foreign = patterns->add_subcommand("import", "from Apple AHAP or MPEG-I hjif");
    foreign->add_option("file", import_.file)->required();
    foreign->add_option("--name", import_.name, "vendor/name; else imported/ and the file's name");
    foreign->add_flag("--put", import_.put, "into the daemon; else it is printed as JSON");
    foreign->callback([this] { verb_ = [this] { return run_pattern_import(common_, import_); }; });
  }

  void add_acting() {
    verb("stop", "EMERGENCY STOP: coils off until `arm`", run_stop);
    verb("arm", "lets the ball play again", run_arm);
    CLI::App* gain = verb("gain", "the owner's comfort setting",
                          [this](Session& session) { return run_gain(session, gain_); });
    gain->add_option("gain", gain_, "0..1; nothing: say it");
  }

  void add_calibrate() {
    CLI::App* calibrate =
        verb("calibrate", "measures the windings and writes the ball's file",
             [this](Session& session) { return run_calibrate(session, calibrate_); });
    calibrate->add_option("--out", calibrate_.out, "the device file to write")->required();
    calibrate->add_option("--name", calibrate_.name, "of the ball; nothing: as it is called now");
    calibrate->add_option("--current-a", calibrate_.current_a, "ampere, 0.5..5")
        ->check(CLI::Range(0.5, 5.0))
        ->capture_default_str();
    calibrate
        ->add_option("--pushed", calibrate_.pushed,
                     "which side each winding pushes, instead of asking: x=front,y=left,z=up")
        ->delimiter(',');
    calibrate->add_flag("--thermal", calibrate_.thermal,
                        "heats and cools the ball for half an hour too, for its thermal constants");
    calibrate->add_flag(
        "--force", calibrate_.force,
        "replaces a file that is there; calibrates a ball that is not at one temperature");
  }

  void add_following() {
    verb("watch", "the ball as it lives; SPACE stops it, q quits", run_watch);
    CLI::App* events = verb("events", "what happens, a line each",
                            [this](Session& session) { return run_events(session, events_); });
    events->add_option("--types", events_.types, "only these, with commas")->delimiter(',');
    events->add_option("--since", events_.since,
                       "what happened since (yesterday, 2h, 23:14), and ends");
    events->add_flag("-f,--follow", events_.follow, "goes on after that");
    events->add_flag("--all")->description("everybody's effects: always so")->group("");
    CLI::App* pins = verb("pins", "the ball unrolled: which pins push now, and how far",
                          [this](Session& session) { return run_pins(session, pins_); });
    CLI::Option* live =
        pins->add_flag("--live", pins_.live, "again and again; on a terminal SPACE stops, q quits");
    pins->add_option("--count", pins_.count, "with --live: ends after so many lines")->needs(live);
    CLI::App* telemetry =
        verb("telemetry", "the status again and again, one JSON object a line",
             [this](Session& session) { return run_telemetry(session, telemetry_); });
    telemetry->add_option("--rate-hz", telemetry_.rate_hz, "0.1..200")->capture_default_str();
    telemetry->add_option("--fields", telemetry_.fields, "keys of the status, with commas")
        ->delimiter(',');
    telemetry->add_option("--count", telemetry_.count, "ends after so many");
  }

  /// The verbs that open their own connection.
  void add_alone() {
    CLI::App* check = app_.add_subcommand(
        "check", "one line for monitoring: 0 ok, 1 warning, 2 critical, 3 unknown");
    check->callback([this] { verb_ = [this] { return run_check(common_); }; });
    CLI::App* demo = app_.add_subcommand("demo", "a tour of 40 seconds");
    demo->add_flag("--private", demo_.private_daemon,
                   "on a daemon of its own with a simulated ball");
    demo->add_flag("--yes", demo_.confirmed, "on a real ball, do not ask first");
    demo->callback([this] { verb_ = [this] { return run_demo(common_, demo_); }; });
  }

  CLI::App app_{"hedgehogctl: look at the ball, play on it, stop it", "hedgehogctl"};
  CommonOptions common_;
  ForecastOptions forecast_;
  PlayOptions play_;
  std::string pattern_;
  ImportOptions import_;
  EventsOptions events_;
  PinsOptions pins_;
  TelemetryOptions telemetry_;
  DemoOptions demo_;
  CalibrateOptions calibrate_;
  std::optional<double> gain_;
  std::function<int()> verb_;
};

}  // namespace

int run_command_line(int argc, char** argv) {
  watch_interrupts();
  return CommandLine().run(argc, argv);
}

}  // namespace hedgehog::client
