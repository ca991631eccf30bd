// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/metrics.h"

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "model/limit/rearm.h"

namespace hedgehog::server {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;
using Labels = std::vector<ClientMetric::Label>;

constexpr const char* kCoils[] = {"x", "y", "z"};

/// Families in the order in which they were named.
class Page {
 public:
  explicit Page(std::string device) : device_{"device", std::move(device)} {}

  Page& family(const std::string& name, const std::string& help, MetricType type) {
    families_.push_back({"hedgehog_" + name, help, type, {}});
    return *this;
  }
  Page& gauge(const std::string& name, const std::string& help) {
    return family(name, help, MetricType::Gauge);
  }
  Page& counter(const std::string& name, const std::string& help) {
    return family(name, help, MetricType::Counter);
  }

  void add(double value, Labels labels = {}) {
    ClientMetric metric = labelled(std::move(labels));
    if (families_.back().type == MetricType::Counter)
      metric.counter.value = value;
    else
      metric.gauge.value = value;
    families_.back().metric.push_back(std::move(metric));
  }
  void add(std::uint64_t value, Labels labels = {}) {
    add(static_cast<double>(value), std::move(labels));
  }
  /// What is not known is left out.
  void add(const std::optional<double>& value, Labels labels = {}) {
    if (value && std::isfinite(*value)) add(*value, std::move(labels));
  }
  void histogram(const std::string& name, const std::string& help, const base::Histogram& h) {
    family(name, help, MetricType::Histogram);
    ClientMetric metric = labelled({});
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < h.counts.size(); ++i) {
      sum += h.counts[i];
      const double bound = i < base::Histogram::kBoundsNs.size()
                               ? static_cast<double>(base::Histogram::kBoundsNs[i]) * 1e-9
                               : std::numeric_limits<double>::infinity();
      metric.histogram.bucket.push_back({sum, bound});
    }
    metric.histogram.sample_count = sum;
    metric.histogram.sample_sum = h.sum_s;
    families_.back().metric.push_back(std::move(metric));
  }

  std::string text() const { return prometheus::TextSerializer().Serialize(families_); }

 private:
  ClientMetric labelled(Labels labels) const {
    ClientMetric metric;
    metric.label = std::move(labels);
    metric.label.insert(metric.label.begin(), device_);
    return metric;
  }

  ClientMetric::Label device_;
  std::vector<MetricFamily> families_;
};

void identity(Page& page, const DeviceView& device_view) {
  page.gauge("build_info", "The daemon's version")
      .add(1.0, {{"version", HEDGEHOG_VERSION}, {"protocol", "1.0"}});
  page.gauge("device_info", "The ball")
      .add(1.0, {{"model", device_view.config().device.model},
                 {"backend", device_view.simulated() ? "simulator" : "usb"}});
  page.gauge("device_state", "1 for the state that the ball is in");
  using control::State;
  for (const State state : {State::kArmed, State::kDisarmed, State::kTripped, State::kAbsent}) {
    page.add(device_view.now().state == state ? 1.0 : 0.0,
             {{"state", std::string(control::name(state))}});
  }
}

void heat(Page& page, const DeviceView& device_view, const protocol::Status& status) {
  const control::StatusSnapshot& now = device_view.now();
  const model::Limits& limits = device_view.limits();
  page.gauge("temperature_celsius", "Hottest winding; absent when unknown");
  page.add(status.temperature_c.sensor, {{"source", "sensor"}});
  page.add(status.temperature_c.model, {{"source", "model"}});
  page.add(status.temperature_c.thermometer, {{"source", "second"}});
  page.gauge("temperature_threshold_celsius", "Where less current is allowed, none, and again");
  page.add(limits.derate_from_c, {{"threshold", "derate"}});
  page.add(limits.trip_c, {{"threshold", "trip"}});
  page.add(model::rearm_below_c(limits, now.thermal.ambient_c), {{"threshold", "arm"}});
  page.gauge("sensor_age_seconds", "Since the last reading");
  if (now.board_present) page.add(now.sensor_age_s, {{"sensor", "coil"}});
  if (now.orientation_present) {
    page.add(static_cast<double>(now.orientation_age) * model::kTickSeconds,
             {{"sensor", "orientation"}});
  }
  page.gauge("current_limit_amperes", "Allowed now").add(status.limit_a);
  page.gauge("headroom_seconds", "Until what flows now is derated; +Inf: never")
      .add(status.headroom_s ? *status.headroom_s : std::numeric_limits<double>::infinity());
  page.counter("derated_seconds_total", "Time in which an effect was being reduced")
      .add(now.totals.derated_s);
  page.gauge("fan_speed_rpm", "Measured").add(status.fan.speed_rpm);
  page.gauge("fan_duty_ratio", "0 to 1").add(status.fan.duty);
}

void coils(Page& page, const DeviceView& device_view) {
  const control::StatusSnapshot& now = device_view.now();
  page.gauge("winding_r25_ohms", "As measured at this start; absent until then");
  for (int i = 0; i < 3; ++i)
    if (const auto r25 = device_view.r25(i)) page.add(r25->ohm, {{"coil", kCoils[i]}});
  page.gauge("winding_r25_drift_ratio", "Of that, by which share it is above another one");
  for (int i = 0; i < 3; ++i) {
    if (const auto r25 = device_view.r25(i)) {
      page.add(r25->from_file, {{"coil", kCoils[i]}, {"from", "file"}});
      page.add(r25->from_kept, {{"coil", kCoils[i]}, {"from", "kept"}});
    }
  }
  page.gauge("current_amperes", "Measured, each winding");
  const model::Vec3 flowing = flowing_a(now.board);
  for (int i = 0; now.board_present && i < 3; ++i) page.add(flowing[i], {{"coil", kCoils[i]}});
  page.gauge("duty_ratio", "Of each bridge, -1 to 1");
  for (int i = 0; now.board_present && i < 3; ++i)
    page.add(now.board.duty[i], {{"coil", kCoils[i]}});
  page.counter("on_seconds_total", "Integral of |duty|: its rate is the duty between two scrapes");
  for (int i = 0; i < 3; ++i) page.add(now.totals.on_s[i], {{"coil", kCoils[i]}});
  page.counter("heat_ampere_squared_seconds_total", "Integral of |I|^2").add(now.totals.heat_a2s);
}

void people(Page& page, const HandlerContext& context, const protocol::Status& status) {
  const Counters& counters = context.counters;
  page.gauge("effects_active", "Started and not ended")
      .add(static_cast<double>(status.effects.size()));
  page.counter("effects_total", "Effects by how they ended");
  for (const auto& [key, count] : counters.effects)
    page.add(count, {{"method", std::string(key.first)}, {"outcome", std::string(key.second)}});
  page.counter("effects_limited_total", "Admitted with less than asked");
  for (const auto& [by, count] : counters.limited) page.add(count, {{"by", std::string(by)}});
  page.counter("trips_total", "Times the ball tripped");
  for (const auto& [why, count] : counters.trips) page.add(count, {{"reason", std::string(why)}});
  page.gauge("connections", "Clients that are connected");
  std::map<std::string, double> connections{{"tcp", 0}, {"unix", 0}, {"websocket", 0}};
  for (const auto& [id, session] : context.sessions) ++connections[session->transport];
  for (const auto& [transport, count] : connections) page.add(count, {{"transport", transport}});
  page.counter("connections_rejected_total", "Clients turned away or cut off");
  for (const auto& [why, count] : counters.rejected)
    page.add(count, {{"reason", std::string(why)}});
  page.counter("requests_total", "By method and error code; 0 is ok");
  for (const auto& [key, count] : counters.requests)
    page.add(count, {{"method", std::string(key.first)}, {"code", std::to_string(key.second)}});
  page.counter("telemetry_dropped_total", "Left out for clients that read too slowly")
      .add(counters.telemetry_dropped);
}

void loop(Page& page, const control::StatusSnapshot& now) {
  page.histogram("request_to_coil_seconds",
                 "From reading a request to handing its set-point to the link",
                 now.totals.request_to_coil);
  page.histogram("tick_lateness_seconds", "How late the control loop woke", now.loop.lateness);
  page.histogram("tick_work_seconds", "What a tick took", now.loop.work);
  page.counter("ticks_total", "Ticks of the control loop").add(now.loop.ticks);
  page.counter("ticks_skipped_total", "Slept through").add(now.loop.skipped);
  page.counter("link_frames_total", "Frames to and from the board");
  page.add(now.link.frames_out, {{"direction", "out"}});
  page.add(now.link.frames_in, {{"direction", "in"}});
  page.counter("link_errors_total", "Bad frames, gaps, set-points that came too late");
  page.add(now.link.errors, {{"kind", "crc"}});
  page.add(now.link.lost, {{"kind", "sequence"}});
  page.add(now.link.overdue, {{"kind", "timeout"}});
}

}  // namespace

std::string metrics_text(Server& server) {
  const DeviceView& device_view = server.device_view();
  const protocol::Status status = server.status();
  Page page(device_view.config().device.name);
  identity(page, device_view);
  heat(page, device_view, status);
  coils(page, device_view);
  people(page, server.context(), status);
  loop(page, device_view.now());
  return page.text();
}

}  // namespace hedgehog::server
