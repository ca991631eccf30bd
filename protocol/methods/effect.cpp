// SPDX-License-Identifier: MIT
#include "protocol/methods/effect.h"

namespace hedgehog::protocol {
namespace {

constexpr std::array<std::string_view, 2> kScopes{"mine", "all"};

constexpr auto kStarts = [] {
  std::array<std::string_view, EffectStart::kMethods.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = EffectStart::kMethods[i].name;
  return names;
}();

void exactly_one(Fields& f, bool effect, bool slot) {
  if (effect && slot)
    f.fail(invalid_params("slot", "effect is given too; give only one of effect and slot"));
  else if (!effect && !slot)
    f.fail(invalid_params("effect", "is missing; give effect or slot"));
}

}  // namespace

Names names_of(Scope) noexcept { return kScopes; }
Names names_of(model::EffectMethod) noexcept { return kStarts; }

void Admission::describe(Fields& f) {
  f.required("effect", effect);
  f.optional("slot", slot);
  f.required("accepted", accepted);
  f.nullable("limited_by", limited_by);
  f.required("current_a", current_a, decimals(2));
  f.required("force_n", force_n, decimals(4));
  f.required("pin", pin);
  f.nullable("headroom_s", headroom_s, decimals(1));
  f.required("seq", seq);
  f.optional("period_ms", period_ms, decimals(3));
}

void EffectUpdate::describe(Fields& f) {
  f.optional("effect", effect, kEffectNumber);
  params.describe(f, std::nullopt);
  if (f.checks()) exactly_one(f, effect.has_value(), params.slot.has_value());
}

void EffectStop::describe(Fields& f) {
  f.optional("effect", effect, kEffectNumber);
  f.optional("slot", slot, {.min = 1, .max = kMaxSlotCharacters});
  if (f.checks()) exactly_one(f, effect.has_value(), slot.has_value());
}

void PreviewResult::describe(Fields& f) {
  constexpr std::size_t kSteps = kMaxSteps;
  f.required("duration_ms", duration_ms);
  f.required("step_ms", step_ms);
  f.required("duty", duty, {.decimals = 4, .items = kSteps});
  f.required("current_a", current_a, {.decimals = 3, .items = kSteps});
  f.required("peak_current_a", peak_current_a, decimals(3));
  f.required("temperature_c", temperature_c, decimals(2));
  f.required("peak_temperature_c", peak_temperature_c, decimals(2));
  f.nullable("limited_by", limited_by);
  f.nullable("limited_from_ms", limited_from_ms);
  f.required("delivered", delivered);
}

void LatencyQuantiles::describe(Fields& f) {
  f.required("p50", p50, decimals(1));
  f.required("p99", p99, decimals(1));
  f.required("max", max, decimals(1));
}

void LatencyResult::describe(Fields& f) {
  f.required("effects", effects);
  f.nullable("received_to_queued_us", received_to_queued_us);
  f.nullable("queued_to_applied_us", queued_to_applied_us);
  f.nullable("applied_to_written_us", applied_to_written_us);
  f.nullable("received_to_written_us", received_to_written_us);
}

void EffectPreview::describe(Fields& f) {
  describe_planned(f, start);
  if (f.checks() && !start)
    f.fail(invalid_params("method", "is missing; for example \"effect.pulse\""));
}

void describe_planned(Fields& f, std::optional<EffectStart>& start) {
  std::optional<model::EffectMethod> method;
  if (start) method = start->method;
  f.optional("method", method);
  if (method && !start) start.emplace(EffectStart{.method = *method});
  const bool has_params = f.has("params");
  if (f.checks() && !method && has_params)
    f.fail(invalid_params("method", "is missing beside params"));
  f.optional("params", start);
  if (f.checks() && start && !has_params)
    f.fail(invalid_params("params", "is missing beside method"));
}

}  // namespace hedgehog::protocol
