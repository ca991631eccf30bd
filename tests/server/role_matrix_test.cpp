// SPDX-License-Identifier: MIT
// Each role with each method of the protocol's table, on a server: accepted, or `forbidden`.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "protocol/methods.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr int kInvalidParams = -32602;
constexpr int kUnauthorized = -32003;
constexpr int kForbidden = -32004;

/// Valid parameters of the methods that require some.
Json params_of(std::string_view method) {
  static const std::map<std::string_view, Json> kParams{
      {"effect.pulse", {{"direction", "left"}}},
      {"effect.hold", {{"direction", "left"}}},
      {"effect.play", {{"pattern", "tick"}}},
      {"effect.update", {{"effect", 1}, {"level", 0.5}}},
      {"effect.stop", {{"effect", 1}}},
      {"effect.preview", {{"method", "effect.pulse"}, {"params", {{"direction", "left"}}}}},
      {"orientation.set", {{"quaternion", {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}}}}},
      {"output.set_gain", {{"gain", 0.5}}},
      {"pattern.get", {{"name", "tick"}}},
      {"pattern.remove", {{"name", "acme/none"}}},
      {"pattern.put",
       {{"name", "acme/x"},
        {"keyframes", {{{"t_ms", 0}, {"level", 1}}, {{"t_ms", 50}, {"level", 0}}}}}},
      {"sim.set", {{"ambient_c", 25}}},
      {"thermal.forecast", {{"current_a", 5}}},
  };
  const auto found = kParams.find(method);
  return found == kParams.end() ? Json::object() : found->second;
}

class RoleMatrix : public testing::Test {
 protected:
  /// The error code of `method` for a new client of `role`, nullopt: a locked client; 0: no error.
  int code_of(std::optional<protocol::Role> role, std::string_view method) {
    FakeClient& client = rig_.connect(role.value_or(protocol::Role::kOperate));
    client.session.locked = !role;
    const Json result = rig_.call(client, std::string(method), params_of(method));
    rig_.disconnect(client);
    return result.is_object() ? result.value("code", 0) : 0;
  }

  ServerRig rig_;
};

TEST_F(RoleMatrix, EachRoleMayCallOnlyTheMethodsOfTheTable) {
  using enum protocol::Role;
  for (const protocol::MethodInfo& method : protocol::kMethods) {
    for (const protocol::Role role : {kObserve, kPlay, kOperate}) {
      const int code = code_of(role, method.name);
      ASSERT_NE(code, kInvalidParams) << method.name << " needs parameters here";
      const bool allowed = !method.role || role >= *method.role;
      EXPECT_EQ(code != kForbidden, allowed) << protocol::name(role) << " " << method.name;
      EXPECT_NE(code, kUnauthorized) << protocol::name(role) << " " << method.name;
    }
  }
}

TEST_F(RoleMatrix, WithoutARequiredTokenNoMethodMayBeCalled) {
  for (const protocol::MethodInfo& method : protocol::kMethods)
    EXPECT_EQ(code_of(std::nullopt, method.name), kUnauthorized) << method.name;
}

TEST_F(RoleMatrix, AForbiddenRequestHasNoEffect) {
  FakeClient& client = rig_.connect(protocol::Role::kObserve);
  for (const protocol::MethodInfo& method : protocol::kMethods)
    if (method.role && *method.role > protocol::Role::kObserve)
      rig_.call(client, std::string(method.name), params_of(method.name));
  rig_.run(100);
  EXPECT_LT(rig_.plant_current_a(), 0.1);
  EXPECT_EQ(rig_.state_store.gain, -1.0);
  EXPECT_TRUE(rig_.storage.files.empty());
}

}  // namespace
}  // namespace hedgehog::server
