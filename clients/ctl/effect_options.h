// SPDX-License-Identifier: MIT
// The parameters of the effects as options of the playing verbs, from the protocol's schema.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/effect/effect.h"
#include "protocol/wire/field_list.h"

namespace hedgehog::client {

struct EffectOption {
  /// Name on the wire: duration_ms.
  std::string parameter;
  /// --duration-ms
  std::string flag;
  /// Accepted values, for --help: "1..10000", "device|world|coil", "DIRECTION"; empty: a flag
  /// without a value.
  std::string values;
  std::string help;
  protocol::FieldType type = protocol::FieldType::kNumber;
};

/// One for each parameter of the method, in the protocol's order.
std::vector<EffectOption> effect_options(model::EffectMethod method);

/// "--duration-ms" of "duration_ms".
std::string flag_of(std::string_view parameter);

}  // namespace hedgehog::client
