// SPDX-License-Identifier: MIT
#include "tests/bench/load/daemon.h"

#include <nlohmann/json.hpp>

#include "tests/bench/load/client.h"

namespace hedgehog::bench {
namespace {

nlohmann::json call(int port, const std::string& method) {
  Client client(port);
  return nlohmann::json::parse(
      client.call(R"({"jsonrpc":"2.0","id":1,"method":")" + method + "\"}\n"));
}

Daemon::Quantiles quantiles_of(const nlohmann::json& us) {
  return {us.at("p50").get<double>(), us.at("p99").get<double>()};
}

}  // namespace

Daemon::Daemon(const std::string& program) {
  home_.write("config/hedgehog/hedgehogd.json", R"({"connections":{"max":1024}})");
  process_.emplace(std::vector<std::string>{program, "--simulate", "--listen", "127.0.0.1:0",
                                            "--log-level", "error"},
                   std::vector<std::string>{
                       "XDG_RUNTIME_DIR=" + home_.path(), "XDG_STATE_HOME=" + home_.path("state"),
                       "XDG_CONFIG_HOME=" + home_.path("config"), "HOME=" + home_.path()});
  for (std::string address; !address.starts_with('/');) {
    address = process_->line_after("listening on ");
    const std::string tcp = "127.0.0.1:";
    const std::string http = "http://127.0.0.1:";
    if (address.starts_with(tcp)) port_ = std::stoi(address.substr(tcp.size()));
    if (address.starts_with(http)) http_port_ = std::stoi(address.substr(http.size()));
  }
}

Daemon::Quantiles Daemon::lateness() const {
  return quantiles_of(call(port_, "device.status").at("result").at("loop").at("lateness_us"));
}

std::optional<Daemon::Quantiles> Daemon::request_to_board() const {
  const nlohmann::json response = call(port_, "effect.latency");
  if (response.contains("result")) {
    const nlohmann::json& us = response["result"].at("received_to_written_us");
    return us.is_null() ? std::nullopt : std::optional(quantiles_of(us));
  }
  const DelayHistogram delays = histogram("request_to_coil_seconds");
  return Quantiles{delays.quantile_us(0.5), delays.quantile_us(0.99)};
}

DelayHistogram Daemon::histogram(const std::string& name) const {
  return {http_get(http_port_, "/metrics"), "hedgehog_" + name};
}

}  // namespace hedgehog::bench
