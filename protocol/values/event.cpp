// SPDX-License-Identifier: MIT
#include "protocol/values/event.h"

#include "protocol/wire/fields.h"

namespace hedgehog::protocol {
void Disagreement::describe(Fields& f) {
  f.required("coil", coil);
  f.required("between", between);
}

void EventDelivery::describe(Fields& f) {
  f.required("min", min, decimals(3));
  f.required("mean", mean, decimals(3));
}

void Event::describe(Fields& f) {
  f.required("type", type);
  f.required("time_ns", time_ns);
  f.optional("state", state);
  f.optional("effect", effect);
  if (effect) f.nullable("slot", slot);
  f.optional("seq", seq);
  if (state) {
    f.nullable("reason", reason);
    f.nullable("remedy", remedy);
  } else {
    f.optional("reason", reason);
  }
  if (delivered || f.has("delivered")) {
    f.nullable("onset_ns", onset_ns);
    f.nullable("offset_ns", offset_ns);
    f.optional("delivered", delivered);
    f.optional("masked_ms", masked_ms);
    f.optional("mixed_ms", mixed_ms);
  }
  f.optional("limit_a", limit_a);
  f.optional("temperature_c", temperature_c, decimals(2));
  f.optional("current_a", current_a, decimals(2));
  f.optional("disagreement", disagreement);
  f.optional("device", device);
  f.optional("skipped", skipped);
}

}  // namespace hedgehog::protocol
