// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/metrics.h"

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "daemon/server/net/http/process_usage.h"
#include "model/limit/rearm.h"

namespace hedgehog::server {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;
using Labels = std::vector<ClientMetric::Label>;

constexpr const char* kCoils[] = {"x", "y", "z"};

/// Families in the order in which they were added.
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
  /// Unknown values are omitted.
  void add(const std::optional<double>& value, Labels labels = {}) {
    if (value && std::isfinite(*value)) add(*value, std::move(labels));
  }
  /// A metric of the process: without the common name prefix and labels.
  void process_gauge(const std::string& name, const std::string& help,
                     const std::optional<double>& value) {
    families_.push_back({"process_" + name, help, MetricType::Gauge, {}});
    if (!value) return;
    families_.back().metric.emplace_back().gauge.value = *value;
  }
  void process_counter(const std::string& name, const std::string& help, double value) {
    families_.push_back({"process_" + name, help, MetricType::Counter, {}});
    families_.back().metric.emplace_back().counter.value = value;
  }
  void histogram(const std::string& name, const std::string& help, const base::Histogram& h) {
    family(name, help, MetricType::Histogram);
    add(h);
  }
  void add(const base::Histogram& h, Labels labels = {}) {
    ClientMetric metric = labelled(std::move(labels));
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
  page.gauge("build_info", "Version of the daemon and of its protocol; always 1")
      .add(1.0, {{"version", HEDGEHOG_VERSION}, {"protocol", "1.0"}});
  page.gauge("device_info", "Kind of the ball, and whether it is real or simulated; always 1")
      .add(1.0, {{"model", device_view.config().device.model},
                 {"backend", device_view.simulated() ? "simulator" : "usb"}});
  page.gauge("device_state", "1 for the state that the ball is in, 0 for the others");
  using control::State;
  for (const State state : {State::kArmed, State::kDisarmed, State::kTripped, State::kAbsent}) {
    page.add(device_view.now().state == state ? 1.0 : 0.0,
             {{"state", std::string(control::name(state))}});
  }
}

void temperatures(Page& page, const DeviceView& device_view, const protocol::Status& status) {
  const protocol::TemperatureStatus& temperature = status.temperature_c;
  page.gauge(
      "temperature_celsius",
      "Temperature in the ball. model: its hottest winding as estimated, which the "
      "thresholds are for; upper: the upper bound of this winding's temperature; sensor: the "
      "thermistor, which is on one winding; second: the second thermometer. Absent while "
      "not known");
  page.add(temperature.model, {{"source", "model"}});
  page.add(temperature.upper, {{"source", "upper"}});
  page.add(temperature.sensor, {{"source", "sensor"}});
  page.add(temperature.thermometer, {{"source", "second"}});
  page.gauge("winding_temperature_celsius",
             "Temperature of each winding as estimated; absent while not known");
  for (std::size_t i = 0; temperature.model && i < temperature.coils.size(); ++i)
    page.add(temperature.coils[i], {{"coil", kCoils[i]}});
  const model::Limits& limits = device_view.limits();
  page.gauge("temperature_threshold_celsius",
             "Temperatures of the hottest winding at which something changes. derate: from here on "
             "less current is allowed; trip: the coils are switched off; arm: below this the ball "
             "can be armed again");
  page.add(limits.derate_from_c, {{"threshold", "derate"}});
  page.add(limits.trip_c, {{"threshold", "trip"}});
  page.add(model::rearm_below_c(limits, device_view.now().thermal.ambient_c),
           {{"threshold", "arm"}});
}

void heat(Page& page, const DeviceView& device_view, const protocol::Status& status) {
  const control::StatusSnapshot& now = device_view.now();
  temperatures(page, device_view, status);
  page.gauge("sensor_age_seconds", "Time since the last reading of the sensor");
  if (now.board_present) page.add(now.sensor_age_s, {{"sensor", "coil"}});
  if (now.orientation_present) {
    page.add(static_cast<double>(now.orientation_age) * model::kTickSeconds,
             {{"sensor", "orientation"}});
  }
  page.gauge("current_limit_amperes", "Current that the heat of the ball allows now")
      .add(status.limit_a);
  page.gauge("headroom_seconds",
             "Time until the current that flows now would have to be reduced; +Inf: never. Absent "
             "while the temperature is not known");
  if (status.temperature_c.model)
    page.add(status.headroom_s ? *status.headroom_s : std::numeric_limits<double>::infinity());
  page.counter("derated_seconds_total", "Time in which an effect was reduced because of heat")
      .add(now.totals.derated_s);
  page.gauge("fan_speed_rpm", "Measured speed of the fan, turns per minute; absent while not known")
      .add(status.fan.speed_rpm);
  page.gauge("fan_duty_ratio", "Duty ratio of the fan, 0 to 1").add(status.fan.duty);
}

void coils(Page& page, const DeviceView& device_view) {
  const control::StatusSnapshot& now = device_view.now();
  page.gauge("winding_r25_ohms",
             "Resistance of each winding at 25 C as measured since this start; absent until then");
  for (int i = 0; i < 3; ++i)
    if (const auto r25 = device_view.r25(i)) page.add(r25->ohm, {{"coil", kCoils[i]}});
  page.gauge("winding_r25_drift_ratio",
             "Relative deviation of that resistance from the device file's (file) and from that of "
             "an earlier start (kept)");
  for (int i = 0; i < 3; ++i) {
    if (const auto r25 = device_view.r25(i)) {
      page.add(r25->from_file, {{"coil", kCoils[i]}, {"from", "file"}});
      page.add(r25->from_kept, {{"coil", kCoils[i]}, {"from", "kept"}});
    }
  }
  page.gauge("current_amperes", "Measured current of each winding at this moment");
  const model::Vec3 flowing = flowing_a(now.board);
  for (int i = 0; now.board_present && i < 3; ++i) page.add(flowing[i], {{"coil", kCoils[i]}});
  page.gauge("duty_ratio", "Duty of the bridge of each winding at this moment, -1 to 1");
  for (int i = 0; now.board_present && i < 3; ++i)
    page.add(now.board.duty[i], {{"coil", kCoils[i]}});
  page.counter("on_seconds_total",
               "Integral of the duty's magnitude: its rate is the mean duty between two scrapes");
  for (int i = 0; i < 3; ++i) page.add(now.totals.on_s[i], {{"coil", kCoils[i]}});
  page.counter("heat_ampere_squared_seconds_total",
               "Integral of the squared currents of all windings: its rate is how much they are "
               "heated")
      .add(now.totals.heat_a2s);
}

void effects(Page& page, const Counters& counters, const protocol::Status& status) {
  page.gauge("effects_active", "Effects that have been started and have not ended")
      .add(static_cast<double>(status.effects.size()));
  page.counter("effects_total",
               "Effects by how they ended; refused: never started, because of heat");
  for (const auto& [key, count] : counters.effects)
    page.add(count, {{"method", std::string(key.first)}, {"outcome", std::string(key.second)}});
  page.counter("effects_limited_total", "Effects admitted with less than requested");
  for (const auto& [by, count] : counters.limited) page.add(count, {{"by", std::string(by)}});
  page.counter("trips_total", "How often the ball was switched off for safety, by reason");
  for (const auto& [why, count] : counters.trips) page.add(count, {{"reason", std::string(why)}});
}

void clients(Page& page, const HandlerContext& context) {
  const Counters& counters = context.counters;
  page.gauge("connections", "Clients that are connected");
  std::map<std::string, double> connections{{"tcp", 0}, {"unix", 0}, {"websocket", 0}};
  for (const auto& [id, session] : context.sessions) ++connections[session->transport];
  for (const auto& [transport, count] : connections) page.add(count, {{"transport", transport}});
  page.counter(
      "connections_rejected_total",
      "Connections rejected or closed by the daemon. cap: too many; slow: did not "
      "read; not_json: no client of this protocol; host, origin: a web page of another site");
  for (const auto& [why, count] : counters.rejected)
    page.add(count, {{"reason", std::string(why)}});
  page.counter("requests_total", "Requests by method and error code; code 0: carried out");
  counters.requests.for_each([&](const RequestCounts::Series& of) {
    page.add(of.count, {{"method", std::string(of.method)}, {"code", std::to_string(of.code)}});
  });
  page.counter("telemetry_dropped_total",
               "Telemetry messages left out for clients that read too slowly")
      .add(counters.telemetry_dropped);
}

void latency(Page& page, const LatencyLog& log) {
  page.family("effect_latency_seconds",
              "Latency of effects, from the request to the board, by stage. received: the request "
              "was read; queued: to the control loop; applied: by a tick; written: the first frame "
              "with it was sent",
              MetricType::Histogram);
  for (std::size_t i = 0; i < kLatencyStageNames.size(); ++i) {
    page.add(log.histogram(static_cast<LatencyStage>(i)),
             {{"stage", std::string(kLatencyStageNames[i])}});
  }
}

void loop(Page& page, const control::StatusSnapshot& now) {
  page.histogram("request_to_coil_seconds",
                 "Time from reading a request to handing what follows from it to the board",
                 now.totals.request_to_coil);
  page.histogram("tick_lateness_seconds", "How late the control loop woke for a tick of 1 ms",
                 now.loop.lateness);
  page.histogram("tick_work_seconds", "Time that the control loop worked in a tick", now.loop.work);
  page.counter("ticks_total", "Ticks of 1 ms that the control loop has made").add(now.loop.ticks);
  page.counter("ticks_skipped_total", "Ticks that were left out because the loop woke too late")
      .add(now.loop.skipped);
  page.counter("link_frames_total", "Frames to and from the board");
  page.add(now.link.frames_out, {{"direction", "out"}});
  page.add(now.link.frames_in, {{"direction", "in"}});
  page.counter("link_errors_total",
               "Errors on the link to the board. crc: damaged frames; sequence: lost frames; "
               "timeout: set-points that could not be sent in time");
  page.add(now.link.errors, {{"kind", "crc"}});
  page.add(now.link.lost, {{"kind", "sequence"}});
  page.add(now.link.overdue, {{"kind", "timeout"}});
}

/// Uses the names of all Prometheus client libraries, without the ball as a label.
void process(Page& page) {
  const ProcessUsage usage = process_usage();
  page.process_counter("cpu_seconds_total", "Total user and system CPU time spent in seconds",
                       usage.cpu_s);
  page.process_gauge("open_fds", "Number of open file descriptors", usage.open_fds);
  page.process_gauge("max_fds", "Maximum number of open file descriptors", usage.max_fds);
  page.process_gauge("virtual_memory_bytes", "Virtual memory size in bytes",
                     usage.virtual_memory_bytes);
  page.process_gauge("resident_memory_bytes", "Resident memory size in bytes",
                     usage.resident_memory_bytes);
  page.process_gauge("threads", "Number of threads of the process", usage.threads);
  page.process_gauge("start_time_seconds",
                     "Start time of the process since the Unix epoch in seconds",
                     usage.start_time_s);
}

}  // namespace

std::string metrics_text(Server& server) {
  const DeviceView& device_view = server.device_view();
  const protocol::Status status = server.status();
  Page page(device_view.config().device.name);
  identity(page, device_view);
  heat(page, device_view, status);
  coils(page, device_view);
  effects(page, server.context().counters, status);
  clients(page, server.context());
  loop(page, device_view.now());
  latency(page, server.context().latency);
  process(page);
  return page.text();
}

}  // namespace hedgehog::server
