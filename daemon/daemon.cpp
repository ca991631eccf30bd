// SPDX-License-Identifier: MIT
#include "daemon/daemon.h"

#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <sysexits.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "base/wall_time.h"
#include "daemon/logging.h"
#include "daemon/server/device/remedy.h"
#include "daemon/server/disk/load_saved_state.h"
#include "daemon/server/effects/preview.h"
#include "daemon/server/history/history_files.h"
#include "daemon/server/net/wait.h"
#include "daemon/startup_grace.h"
#include "protocol/methods/hello.h"

namespace hedgehog::daemon {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kResponsePause{1};
constexpr std::chrono::milliseconds kClosingPause{10};
constexpr std::chrono::milliseconds kShutdownTimeout{1500};
/// Time for responses that wait for the disk; control has ended. Previews have a pump per slice.
constexpr std::chrono::milliseconds kLastResponses{1000};

}  // namespace

Daemon::Daemon(const Options& options, const config::Paths& paths, const config::Config& config)
    : options_(options),
      config_(config),
      signals_(io_, SIGINT, SIGTERM, SIGHUP),
      listener_(io_, config),
      saved_(server::load_saved_state(config.state_directory, server::ball_of(config))),
      threads_([&]() -> DeviceThreads {
        // Opened first: a second daemon must not access the board of the first.
        listener_.open(config);
        const StartState start = start_state(config, saved_, server::boot_time_now());
        return {config, start.settings, start.simulated_c, options.pace()};
      }()),
      reload_(paths, options.overrides),
      event_wait_(io_, threads_.mailbox().wake_io, options.pace().value_or(control::Pace{})),
      device_view_(config, threads_.mailbox(), threads_.port(), threads_.loop().origin_ns()),
      state_store_(config.state_directory, disk_, device_view_, saved_),
      devices_(config_, threads_.sensors(), scan_thread_),
      pattern_files_(config.state_directory, disk_),
      patterns_(pattern_files_, pattern_files_.load()),
      history_(server::history_writer(config.state_directory, disk_),
               server::load_history(config.state_directory)),
      recordings_(config.state_directory, disk_, threads_.recorder(), history_.last_recording()),
      telemetry_file_(config.state_directory, disk_),
      server_(
          device_view_, state_store_, patterns_, history_,
          [this](const control::Event& e, const server::Effect* x) { on_event(e, x); },
          base::unix_ms_now) {
  server_.set_access(config_);
  server_.set_devices(devices_);
  device_view_.set_board_info_source([this] { return threads_.sensors().board_info(); });
  server_.set_recordings(recordings_);
  server_.telemetry().restore(server::load_telemetry(config.state_directory),
                              device_view_.now().tick, base::unix_ms_now());
}

int Daemon::run() {
  threads_.loop().start();
  log_start();
  asio::co_spawn(io_, pump(), asio::detached);
  asio::co_spawn(io_, handle_signals(), asio::detached);
  io_.run();
  return EX_OK;
}

void Daemon::log_start() {
  if (config_.backend == config::Backend::kSimulator) {
    spdlog::warn(
        "hedgehogd {} on the SIMULATOR{}: no real ball is driven{}", HEDGEHOG_VERSION,
        options_.speed.value_or(1) > 1 ? fmt::format(", {} times as fast", *options_.speed) : "",
        config_.configured || options_.overrides.simulate ? ""
                                                          : "; there is no configuration file");
  } else {
    spdlog::info("hedgehogd {}", HEDGEHOG_VERSION);
  }
  for (const std::string& file : config_.files) spdlog::info("configured by {}", file);
  spdlog::info("{} ({}), limits {} A, {} A for ever; state in {}", config_.device.name,
               config_.device.model, config_.limits.current_a, config_.limits.continuous_a,
               config_.state_directory);
  if (!options_.speed && !threads_.loop().realtime())
    spdlog::warn("no real-time scheduling (LimitRTPRIO, ulimit -r); a busy machine may skip ticks");
}

void Daemon::start_listening() {
  ready_ = true;
  if (start_blocker_) log_state(*std::exchange(start_blocker_, std::nullopt));
  listener_.start(server_);
  for (const std::string& address : listener_.addresses()) {
    spdlog::info("listening on {}", address);
    std::cout << "listening on " << address << '\n';
  }
  std::cout.flush();
  if (const auto port = announced_port(listener_.addresses())) {
    announcement_.emplace(AnnouncedService{config_.device.name, *port, config_.device.usb_serial,
                                           protocol::HelloResult{}.protocol});
  }
  manager_.ready(status_line());
}

asio::awaitable<void> Daemon::pump() {
  const StartupGrace startup_grace(Clock::now());
  while (!stopping_) {
    server_.pump();
    state_store_.pump();
    telemetry_file_.pump(server_.telemetry(), device_view_.now().tick, base::unix_ms_now());
    for (const std::string& line : threads_.sensors().messages()) spdlog::info("{}", line);
    for (const std::string& line : warnings_.step(device_view_)) spdlog::warn("{}", line);
    manager_.alive(threads_.loop().heartbeat());
    cpu_latency_.request(!options_.speed && device_view_.now().state == control::State::kArmed);
    if (auto loaded = reload_.step(config_)) apply(*std::move(loaded));
    if (ready_)
      manager_.status(status_line());
    else if (device_view_.now().state == control::State::kArmed ||
             startup_grace.over(Clock::now(), threads_.loop().heartbeat()))
      start_listening();
    if (server_.has_unsent_telemetry()) {
      // After the requests received meanwhile.
      co_await asio::post(io_, asio::use_awaitable);
      continue;
    }
    co_await event_wait_.wait(server_.pump_due_in());
  }
}

asio::awaitable<void> Daemon::handle_signals() {
  for (;;) {
    error_code ec;
    const int signal = co_await signals_.async_wait(asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    if (signal == SIGHUP) {
      manager_.reloading();
      reload_.request();
    } else if (!stopping_) {
      asio::co_spawn(io_, shut_down(signal == SIGINT ? "interrupted" : "stop"), asio::detached);
    } else if (signal == SIGINT) {
      // The safe command was sent on the first signal.
      std::_Exit(EXIT_FAILURE);
    }
  }
}

asio::awaitable<void> Daemon::shut_down(std::string reason) {
  stopping_ = true;
  manager_.stopping();
  if (threads_.loop().stop())
    spdlog::info("coils off, {:.1f} °C remembered", device_view_.hottest_c());
  else if (device_view_.now().state == control::State::kAbsent)
    spdlog::info("no ball is connected");
  else
    spdlog::warn(
        "the board has not confirmed that the coils are off; its dead-man switches them off");
  server_.pump();
  server_.announce_shutdown(std::move(reason));
  state_store_.stopped_cleanly();
  telemetry_file_.write(server_.telemetry(), device_view_.now().tick, base::unix_ms_now());
  asio::steady_timer timer(io_);
  const auto last_response = Clock::now() + kLastResponses;
  model::Tick pumps = 0;
  while (server_.has_pending() &&
         (pumps++ < server::Preview::kMaxSlices || Clock::now() < last_response)) {
    timer.expires_after(kResponsePause);
    co_await server::wait(timer);
    server_.pump();
  }
  listener_.close();
  announcement_.reset();
  const auto until = Clock::now() + kShutdownTimeout;
  while ((!history_.flush() || !listener_.empty()) && Clock::now() < until) {
    timer.expires_after(kClosingPause);
    co_await server::wait(timer);
  }
  if (!history_.flush()) spdlog::warn("the disk is slow; the history may lack the newest events");
  io_.stop();
}

void Daemon::apply(ConfigReload::Loaded fresh) {
  if (fresh.has_error()) {
    spdlog::error("the new configuration is invalid; the old one remains in effect:\n{}",
                  keys::to_string(fresh.error()));
    manager_.ready(status_line());
    return;
  }
  config::Config next = config_;
  next.limits = fresh->limits;
  next.log_level = fresh->log_level;
  next.telemetry_max_rate_hz = fresh->telemetry_max_rate_hz;
  next.connections = fresh->connections;
  next.access = config::reloaded_access(config_.access, fresh->access);
  // A board never widens its limits.
  const bool too_wide =
      !model::is_within(next.limits, next.device.limits) ||
      device::BoardLimits::of(next.limits).wider_than(device::BoardLimits::of(config_.limits));
  if (too_wide) next.limits = config_.limits;
  if (!(next.limits == config_.limits) &&
      !device_view_.outbox().add(0, control::SetLimits{next.limits})) {
    spdlog::error(
        "the queue to the control loop is full; the new limits were not applied, reload again");
    next.limits = config_.limits;
  }
  device_view_.outbox().commit();
  config_ = next;
  device_view_.set_config(next);
  listener_.set_config(next);
  server_.set_access(next);
  set_log_level(next.log_level);
  const std::vector<std::string> waiting = config::different_keys(*fresh, next);
  spdlog::info(
      "configuration reloaded{}",
      waiting.empty() ? "" : fmt::format("; at the next start only: {}", fmt::join(waiting, ", ")));
  manager_.ready(status_line());
}

void Daemon::log_state(const control::Event& event) {
  const auto remedy = server::remedy(event.state, event.reason, device_view_.remedy_facts());
  const auto level = event.state == control::State::kTripped ? spdlog::level::err
                     : event.state == control::State::kArmed ? spdlog::level::info
                                                             : spdlog::level::warn;
  spdlog::log(level, "{}{}{}", control::name(event.state),
              event.reason == control::Reason::kNone
                  ? ""
                  : fmt::format(": {}", control::name(event.reason)),
              remedy ? ". " + *remedy : "");
  if (event.state == control::State::kArmed && device_view_.is_board_limited())
    spdlog::warn("the board keeps tighter limits than configured: unplug the ball's supply once");
}

void Daemon::on_event(const control::Event& event, const server::Effect*) {
  if (event.type != control::EventType::kStateChanged) {
    log_event(event);
    return;
  }
  // Not a warning if it arms itself before clients are accepted.
  start_blocker_.reset();
  if (!ready_ && event.state == control::State::kDisarmed &&
      event.reason == control::Reason::kNeverArmed)
    start_blocker_ = event;
  else
    log_state(event);
  state_store_.state_changed(event.state);
  // The latch is persisted before any longer operation.
  if (event.state == control::State::kTripped) state_store_.persist_latch(event.reason);
}

std::string Daemon::status_line() const {
  const control::StatusSnapshot& now = device_view_.now();
  std::string line = device_view_.simulated() ? "SIMULATOR: " : "";
  line += std::string(control::name(now.state));
  if (const auto reason = device_view_.reason_now()) line += " (" + *reason + ")";
  if (const auto remedy = device_view_.remedy_now()) line += ". " + *remedy;
  return line;
}

}  // namespace hedgehog::daemon
