// SPDX-License-Identifier: MIT
#include "clients/ctl/command_line.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "cli/program.h"
#include "clients/common/ascii_output.h"
#include "clients/common/interrupts.h"
#include "clients/ctl/calibrate_arguments.h"
#include "clients/ctl/demo/demo.h"
#include "clients/ctl/discover/discover_verb.h"
#include "clients/ctl/discover/discovery.h"
#include "clients/ctl/discover/on_all.h"
#include "clients/ctl/effect_arguments.h"
#include "clients/ctl/flash_arguments.h"
#include "clients/ctl/follow_arguments.h"
#include "clients/ctl/forecast_arguments.h"
#include "clients/ctl/import_arguments.h"
#include "clients/ctl/record_arguments.h"
#include "clients/ctl/token/token_arguments.h"
#include "clients/ctl/tunnel/tunnel_arguments.h"
#include "clients/ctl/verbs/act_verbs.h"
#include "clients/ctl/verbs/latency_verb.h"
#include "clients/ctl/verbs/look_verbs.h"
#include "clients/ctl/verbs/pattern_verbs.h"
#include "clients/ctl/verbs/play_verbs.h"
#include "clients/ctl/verbs/record_verb.h"
#include "clients/ctl/verbs/sound_verbs.h"

namespace hedgehog::client {
namespace {

class CommandLine {
 public:
  CommandLine() {
    app_.require_commands(1, 1);
    app_.accept_options_above();
    app_.set_version(std::string("hedgehogctl " HEDGEHOG_VERSION));
    const cli::OptionSpec address = app_.add_option(
        "--address", common_.address,
        "where the daemon listens: host:port, tls://host:port, mdns://NAME or a socket's path "
        "(HEDGEHOG_ADDRESS)");
    app_.add_flag("--all", all_, "the verb on every daemon of this machine at once")
        .excludes(address);
    app_.add_flag("--json", common_.json, "answers as JSON, for programs");
    app_.set_footer(
        "Exit: 0 done, 1 the effect ended otherwise than completed, 64 usage, 65 a bad file, 66 no "
        "such file or\npattern, 69 no daemon, no ball or not armed, 70 a fault of hedgehogctl or "
        "of the daemon, 73 a file\ncannot be written or a port is in use, 75 try later, 76 not "
        "understood, 77 the role does\nnot suffice, 130 interrupted.");
    add_looking();
    add_playing(app_, [](Session& session, const PlayOptions& options) {
      return is_sound_file(options.pattern) ? run_sound(session, options)
                                            : run_play(session, options);
    });
    add_preview();
    add_patterns();
    add_record();
    add_acting();
    add_calibrate();
    add_board();
    add_following();
    add_alone();
  }

  int run(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    // Also valid if parsing fails before the flag.
    const bool json = std::count(arguments.begin(), arguments.end(), "--json") > 0;
    if (json) report_errors_as_json();
    print_as_the_locale_allows(arguments);
    if (const auto ended = app_.parse(arguments)) {
      if (ended->code == kUsage) return refuse(ended->text, json);
      std::fputs(ended->text.c_str(), stdout);
      return ended->code;
    }
    return all_ ? run_verb_on_all(json) : verb_();
  }

 private:
  using Verb = std::function<int(Session&)>;

  /// A monitoring plug-in exits with 3 on a usage error.
  int refuse(const std::string& sentence, bool json) const {
    return app_.is_given("check") ? print_unknown(sentence, json) : report_usage_error(sentence);
  }

  int run_verb_on_all(bool json) {
    for (const char* name : {"watch", "record", "calibrate", "board", "demo", "discover", "tunnel"})
      if (app_.is_given(name))
        return refuse(
            app_.usage_error("--all: " + std::string(name) + " works with one daemon at a time"),
            json);
    const std::vector<LocalDaemon> daemons = running_daemons();
    if (daemons.empty())
      return report_error({Failure::kNoDaemon, "no daemon runs on this machine", {}});
    return run_on_all(daemons, json, [this](const LocalDaemon& daemon) {
      common_.address = "unix:" + daemon.socket;
      return verb_();
    });
  }

  void connected(Verb run) {
    verb_ = [this, run = std::move(run)] {
      auto session = open_session(common_);
      return session ? run(*session) : static_cast<int>(report_error(session.error()));
    };
  }

  /// A verb that requires a connection.
  cli::CommandSpec verb(const std::string& name, const std::string& help, Verb run) {
    return verb_of(app_, name, help, std::move(run));
  }
  cli::CommandSpec verb_of(const cli::CommandSpec& parent, const std::string& name,
                           const std::string& help, Verb run) {
    const cli::CommandSpec command = parent.add_command(name, help);
    command.on_given([this, run = std::move(run)] { connected(run); });
    return command;
  }

  void add_looking() {
    verb("status", "the state of the ball", run_status);
    verb("devices", "USB and HID devices: which are used, and why the others are not", run_devices);
    verb("clients", "the connected clients and their effects", run_clients);
    const cli::CommandSpec forecast =
        verb("forecast", "how long a current can flow",
             [this](Session& session) { return run_forecast(session, forecast_); });
    add_forecast_arguments(forecast, forecast_);
    verb("latency", "how long effects took from their request to the board", run_latency);
    verb("trips", "earlier trips: when, why, and what was playing", run_trips);
  }

  using Play = int (*)(Session&, const PlayOptions&);

  void add_effect(const cli::CommandSpec& parent, Play act, model::EffectMethod method,
                  const std::string& help) {
    const std::string full_name(protocol::name(method));
    const cli::CommandSpec command = verb_of(parent, full_name.substr(full_name.find('.') + 1),
                                             help, [this, act, full_name](Session& session) {
                                               play_.method = full_name;
                                               return act(session, play_);
                                             });
    add_effect_arguments(command, method, play_);
  }

  void add_playing(const cli::CommandSpec& parent, Play act) {
    using enum model::EffectMethod;
    add_effect(parent, act, kPulse, "one push");
    add_effect(parent, act, kCircle, "a push that walks once round the ball");
    add_effect(parent, act, kVibrate, "many pushes a second");
    add_effect(parent, act, kHold, "a push that stays, until Ctrl-C");
    add_effect(parent, act, kPlay,
               "a pattern, by its name or from a file (.json, .ahap, .hjif), or a sound file");
  }

  void add_preview() {
    const cli::CommandSpec preview = app_.add_command(
        "preview", "what an effect would do, without playing it: preview pulse left");
    preview.require_commands(1, 1);
    preview.accept_options_above();
    add_playing(preview, [](Session& session, const PlayOptions& options) {
      return is_sound_file(options.pattern) ? run_sound_preview(session, options)
                                            : run_preview(session, options);
    });
  }

  void add_patterns() {
    const cli::CommandSpec patterns =
        app_.add_command("patterns", "named patterns: list, get, put, remove, import");
    patterns.require_commands(0, 1);
    patterns.accept_options_above();
    patterns.on_given([this, patterns] {
      if (!patterns.has_given_command()) connected(run_pattern_list);
    });
    verb_of(patterns, "list", "all of them", run_pattern_list);
    const cli::CommandSpec get =
        verb_of(patterns, "get", "prints one as JSON",
                [this](Session& session) { return run_pattern_get(session, pattern_); });
    get.add_option("name", pattern_).required();
    const cli::CommandSpec put =
        verb_of(patterns, "put", "stores one; its name is vendor/name",
                [this](Session& session) { return run_pattern_put(session, pattern_); });
    put.add_option("file", pattern_, "as `patterns get` prints it").required();
    const cli::CommandSpec remove =
        verb_of(patterns, "remove", "removes one that was put",
                [this](Session& session) { return run_pattern_remove(session, pattern_); });
    remove.add_option("name", pattern_).required();
    const cli::CommandSpec foreign =
        patterns.add_command("import", "from Apple AHAP or MPEG-I hjif");
    add_import_arguments(foreign, import_);
    foreign.on_given([this] { verb_ = [this] { return run_pattern_import(common_, import_); }; });
  }

  void add_record() {
    const cli::CommandSpec record =
        verb("record", "records the path of the ball's front as a pattern file",
             [this](Session& session) { return run_record(session, record_); });
    add_record_arguments(record, record_);
  }

  void add_acting() {
    verb("stop", "EMERGENCY STOP: coils off until `arm`", run_stop);
    verb("arm", "arms the ball after a stop or a trip", run_arm);
    const cli::CommandSpec gain =
        verb("gain", "the owner's gain, by which every effect is scaled",
             [this](Session& session) { return run_gain(session, gain_); });
    gain.add_option("gain", gain_, "0..1; without it the present gain is printed");
  }

  void add_calibrate() {
    const cli::CommandSpec calibrate =
        verb("calibrate", "measures the windings and writes the device file",
             [this](Session& session) { return run_calibrate(session, calibrate_); });
    add_calibrate_arguments(calibrate, calibrate_);
  }

  void add_board() {
    const cli::CommandSpec board = app_.add_command("board", "the driver board: flash");
    board.require_commands(1, 1);
    board.accept_options_above();
    const cli::CommandSpec flash = board.add_command("flash", "new firmware from a UF2 file");
    add_flash_arguments(flash, flash_);
    flash.on_given([this] { verb_ = [this] { return run_board_flash(common_, flash_); }; });
  }

  void add_following() {
    verb("watch", "the ball live; SPACE is the emergency stop, q quits", run_watch);
    add_events_arguments(verb(
                             "events", "events of the ball, one a line",
                             [this](Session& session) { return run_events(session, events_); }),
                         events_);
    add_pins_arguments(verb(
                           "pins", "a map of the ball: which pins push, and how far",
                           [this](Session& session) { return run_pins(session, pins_); }),
                       pins_);
    add_telemetry_arguments(
        verb("telemetry", "the status repeatedly, one JSON object a line",
             [this](Session& session) { return run_telemetry(session, telemetry_); }),
        telemetry_);
  }

  /// The verbs that open their own connection.
  void add_alone() {
    const cli::CommandSpec check = app_.add_command(
        "check", "one line for monitoring: 0 ok, 1 warning, 2 critical, 3 unknown");
    check.set_footer(
        "Exit: 0 ok, 1 warning, 2 critical, 3 unknown, a mistake on its command line too.");
    check.on_given([this] { verb_ = [this] { return run_check(common_); }; });
    const cli::CommandSpec discover =
        app_.add_command("discover", "the balls of this machine and of the network");
    discover.on_given([this] { verb_ = [this] { return run_discover(common_.json); }; });
    const cli::CommandSpec demo = app_.add_command("demo", "a tour of 40 seconds");
    demo.add_flag("--private", demo_.private_daemon,
                  "starts a daemon with a simulated ball for it");
    demo.add_flag("--yes", demo_.confirmed, "does not ask before it plays on a real ball");
    demo.on_given([this] { verb_ = [this] { return run_demo(common_, demo_); }; });
    const cli::CommandSpec tunnel = app_.add_command(
        "tunnel", "a ball on the network at a port of this machine, for games without TLS");
    add_tunnel_arguments(tunnel, app_.option("--address"), common_, tunnel_);
    tunnel.on_given([this] { verb_ = [this] { return run_tunnel(common_, tunnel_); }; });
    const cli::CommandSpec token =
        app_.add_command("token", "access from other machines: add, list, revoke, certificate");
    add_token_arguments(token, token_, [this](TokenVerb chosen) {
      verb_ = [this, chosen] { return chosen(common_, token_); };
    });
  }

  cli::Program app_{"hedgehogctl: shows the state of the ball, plays effects, stops it",
                    "hedgehogctl"};
  CommonOptions common_;
  ForecastOptions forecast_;
  PlayOptions play_;
  std::string pattern_;
  RecordOptions record_;
  ImportOptions import_;
  EventsOptions events_;
  PinsOptions pins_;
  TelemetryOptions telemetry_;
  DemoOptions demo_;
  CalibrateOptions calibrate_;
  FlashOptions flash_;
  TokenOptions token_;
  TunnelOptions tunnel_;
  std::optional<double> gain_;
  bool all_ = false;
  std::function<int()> verb_;
};

}  // namespace

int run_command_line(int argc, char** argv) {
  watch_interrupts();
  return CommandLine().run(argc, argv);
}

}  // namespace hedgehog::client
