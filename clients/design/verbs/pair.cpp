// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "clients/design/output/table.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Result<void> run_pair(const PairOptions& options, const Screen& screen) {
  auto design = design_from(options.design);
  if (!design) return design.error();
  if (options.other) {
    const auto other = parse_size(*options.other, "--other");
    if (!other) return other.error();
    design->shield = *other;
  }
  if (!(options.angle_deg >= 0.0 && options.angle_deg <= 180.0))
    return Problem{kUsage, "--angle: must be from 0 to 180 degrees"};
  if (!(std::abs(options.offset_mm) <= 100.0))
    return Problem{kUsage, "--offset: must be from -100 to 100 mm"};
  if (options.offset_mm <= -design->sphere_mm) {
    return Problem{kUsage, "--offset: " + to_text(options.offset_mm) +
                               " mm is beyond the centre of a sphere of " +
                               to_text(design->sphere_mm) + " mm"};
  }
  if (const auto problem = model::problem_with(design->sizes())) return Problem{kUsage, *problem};
  const model::MagnetPair pair = design->sizes().pin_and_shield();
  const model::PairPlace place{options.angle_deg, options.offset_mm, 0.0};
  const double gap = model::gap_mm(pair, place);
  if (!(gap > 0.0)) {
    return Problem{kBadData, (gap > -0.005 ? "the magnets touch: "
                                           : "the magnets overlap by " + fixed(-gap, 2) + " mm: ") +
                                 to_text(design->magnet) + " and " + to_text(design->shield) + " " +
                                 to_text(options.angle_deg) + "° apart on a sphere of " +
                                 to_text(design->sphere_mm) + " mm"};
  }
  const auto force_by = [&](model::ForceModel model) {
    return model::pair_force(pair, place, {model, design->settings.accuracy});
  };
  const model::PairForce asked = force_by(design->settings.model);
  const bool reached = asked.error_n <= design->settings.accuracy * std::abs(asked.force_n);
  if (!reached) {
    screen.err << "  known to ± " << fmt::format("{:.1e}", asked.error_n)
               << " N only: the magnets nearly touch, or what they do cancels\n";
  }
  Table table({{"model", "model", true}, {"force N", "force_n"}, {"± N", "error_n"}});
  Json root{{"force_n", asked.force_n},
            {"error_n", asked.error_n},
            {"model", model::name_of(design->settings.model)},
            {"accuracy", design->settings.accuracy},
            {"accuracy_reached", reached},
            {"gap_mm", gap}};
  for (const auto model :
       {model::ForceModel::kExact, model::ForceModel::kHybrid, model::ForceModel::kDipole}) {
    const std::string name(model::name_of(model));
    const model::PairForce force = force_by(model);
    root[name + "_n"] = force.force_n;
    table.add({name, fixed(force.force_n, 9), fixed(force.error_n, 9)});
  }
  switch (screen.format) {
    case Format::kJson:
      screen.out << root.dump(2) << "\n";
      break;
    case Format::kCsv:
      screen.out << table.csv();
      break;
    case Format::kText:
      screen.out << "  force on " << to_text(design->magnet) << ", from " << to_text(design->shield)
                 << " of the same polarity; outwards is positive\n"
                 << "  " << to_text(options.angle_deg) << "° apart on a sphere of "
                 << to_text(design->sphere_mm) << " mm, offset " << to_text(options.offset_mm)
                 << " mm, gap " << fixed(gap, 2) << " mm\n\n"
                 << table.text();
  }
  return {};
}

}  // namespace hedgehog::design
