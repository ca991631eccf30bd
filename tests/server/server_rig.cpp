// SPDX-License-Identifier: MIT
#include "tests/server/server_rig.h"

#include <gtest/gtest.h>

namespace hedgehog::server {
namespace {

constexpr std::int64_t kEpochNs = 5'000'000'000;
constexpr model::Tick kMaxTicks = 1000;

control::ControlSettings armed_settings(const config::Config& config,
                                        const device::SimulatedBoardOptions& board) {
  control::ControlSettings s;
  s.coils = config.device.coils;
  s.thermal = config.device.thermal;
  s.limits = config.limits;
  s.ceiling = config.device.limits;
  s.arm_at_start = true;
  s.start_known = true;
  s.start_measured.fill(true);
  s.start.winding_c.fill(board.start_c);
  s.start.core_c = board.start_c;
  s.start_ambient_c = board.ambient_c;
  return s;
}

}  // namespace

ServerRig::ServerRig(config::Config settings, const device::SimulatedBoardOptions& board)
    : config(std::move(settings)), world(*port, board) {
  control = std::make_unique<control::ControlTick>(armed_settings(config, board), *mailbox, *port,
                                                   nullptr);
  device_view = std::make_unique<DeviceView>(config, *mailbox, *port, kEpochNs);
  server = std::make_unique<Server>(
      *device_view, state_store, patterns, history,
      [this](const control::Event& event, const Effect*) {
        events.push_back(event);
        if (on_listener_call) on_listener_call(event);
      },
      [this] { return wall_ms(); });
  run(200);
  EXPECT_EQ(device_view->now().state, control::State::kArmed);
}

FakeClient& ServerRig::connect(protocol::Role role) {
  FakeClient& client = clients_.emplace_back(*server);
  client.session.role = role;
  client.session.transport = "tcp";
  client.session.sink = &client;
  server->open(client.session);
  return client;
}

void ServerRig::disconnect(FakeClient& client) { server->close(client.session); }

void ServerRig::run(model::Tick ticks) {
  for (model::Tick i = 0; i < ticks; ++i) {
    control->run(++tick_, 0, {});
    world.step();
    server->pump();
  }
}

void ServerRig::run_without_pump(model::Tick ticks) {
  for (model::Tick i = 0; i < ticks; ++i) {
    control->run(++tick_, 0, {});
    world.step();
    device_view->refresh();
  }
}

Json ServerRig::exchange(FakeClient& client, const std::string& line) {
  server->line(client.session, line);
  for (model::Tick i = 0; i < kMaxTicks; ++i) {
    for (auto it = client.lines.begin(); it != client.lines.end(); ++it) {
      if (it->kind == LineKind::kResponse) {
        Json response = Json::parse(it->text);
        client.lines.erase(it);
        return response;
      }
    }
    run(1);
  }
  ADD_FAILURE() << "no answer to " << line;
  return {};
}

Json ServerRig::call(FakeClient& client, const std::string& method, const Json& params) {
  const Json request{
      {"jsonrpc", "2.0"}, {"id", ++next_id_}, {"method", method}, {"params", params}};
  const Json response = exchange(client, request.dump());
  EXPECT_EQ(response.value("id", -1), next_id_);
  const auto known = protocol::method_named(method);
  if (known && response.contains("error")) {
    const auto code = static_cast<protocol::ErrorCode>(response["error"].value("code", 0));
    EXPECT_TRUE(protocol::possible_errors(protocol::info(*known)).contains(code))
        << method << " lists no " << protocol::name(code) << " among its errors";
  }
  return response.contains("result") ? response["result"] : response.value("error", Json::object());
}

std::vector<Json> ServerRig::on_event(FakeClient& client, LineKind kind) {
  std::vector<Json> found;
  std::deque<FakeClient::Line> rest;
  for (FakeClient::Line& line : client.lines)
    if (line.kind == kind)
      found.push_back(Json::parse(line.text)["params"]);
    else
      rest.push_back(std::move(line));
  client.lines.swap(rest);
  return found;
}

}  // namespace hedgehog::server
