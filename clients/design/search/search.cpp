// SPDX-License-Identifier: MIT
#include "clients/design/search/search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "clients/design/ball_numbers.h"
#include "clients/design/search/pull.h"
#include "clients/design/search/workers.h"
#include "clients/design/study.h"
#include "model/magnets/electromagnet.h"

namespace hedgehog::design {
namespace {

/// Rest of a pin without current, and its extension from there.
struct Reach {
  std::size_t pins = 0;
  double rest_mm = 0.0;
  double extension_mm = 0.0;
};

/// The median by rest.
Reach median_of(std::vector<Reach> classes) {
  std::sort(classes.begin(), classes.end(),
            [](const Reach& a, const Reach& b) { return a.rest_mm < b.rest_mm; });
  std::size_t pins = 0;
  for (const Reach& one : classes) pins += one.pins;
  std::size_t before = 0;
  for (const Reach& one : classes)
    if ((before += one.pins) > (pins - 1) / 2) return one;
  return {};
}

/// Rest and extension of the typical pin; nullopt if a demand is not met.
std::optional<Reach> reach_of(const std::vector<model::PinClass>& classes,
                              const std::vector<Pull>& pulls, double diameter_mm,
                              double coil_force_n, const Demands& demands) {
  std::vector<Reach> reached;
  const auto moved_of = [&](const std::vector<double>& force_n) {
    const double moved_mm = falls_through(force_n, -coil_force_n);
    return std::isnan(falls_through(force_n, 0.0)) || moved_mm > demands.travel_mm ? std::nan("")
                                                                                   : moved_mm;
  };
  for (std::size_t c = 0; c < classes.size(); ++c) {
    // With weaker shields a pin rests farther out and moves farther: the critical case.
    if (std::isnan(moved_of(pulls[c].force_n(diameter_mm, 1.0 - demands.margin)))) return {};
    const std::vector<double> force_n = pulls[c].force_n(diameter_mm, 1.0);
    const double zero_mm = falls_through(force_n, 0.0);
    const double moved_mm = moved_of(force_n);
    if (std::isnan(zero_mm) || std::isnan(moved_mm)) return {};
    // The shell limits it to 0.
    const double rest_mm = std::max(zero_mm, 0.0);
    reached.push_back({classes[c].pins.size(), rest_mm, std::max(moved_mm - rest_mm, 0.0)});
  }
  const Reach typical = median_of(std::move(reached));
  return typical.extension_mm >= demands.min_extension_mm ? std::optional(typical) : std::nullopt;
}

double nearest_shields_deg(const model::Arrangement& array) {
  double largest_cosine = -1.0;
  model::Vec3 a;
  model::Vec3 b;
  for (std::size_t i = 0; i < array.shields.size(); ++i) {
    for (std::size_t j = i + 1; j < array.shields.size(); ++j) {
      const double cosine = model::dot(array.shields[i].direction, array.shields[j].direction);
      if (cosine <= largest_cosine) continue;
      largest_cosine = cosine;
      a = array.shields[i].direction;
      b = array.shields[j].direction;
    }
  }
  return model::angle_deg(a, b);
}

}  // namespace

Result<Search> Search::in(const SearchSpace& space, const Demands& demands) {
  Search search(space, demands);
  for (const double sphere_mm : space.spheres_mm) {
    if (space.coil_forces_n.empty() && sphere_mm < kElectromagnetRadiusMm) {
      return Problem{kUsage, "--spheres: " + to_text(sphere_mm) +
                                 " mm is inside the electromagnet, which has a radius of " +
                                 to_text(kElectromagnetRadiusMm) +
                                 " mm; for another one say its force with --coil-force"};
    }
  }
  for (const std::string& name : space.arrays) {
    if (name.find('-') != std::string::npos) {
      return Problem{kUsage, "--arrays: '" + name +
                                 "': a search takes whole arrays (cD, wD, tkD, GP(m,n)) and "
                                 "makes the fan's opening itself"};
    }
    const auto whole = find_arrangement(name);
    if (!whole) return whole.error();
    if (whole->pins.size() <= 12)
      return Problem{kUsage, "--arrays: " + name + " has too few pins to take six out"};
    auto opened = find_arrangement(name + "-" + std::to_string(whole->pins.size() - 6));
    if (!opened) return opened.error();
    Array array;
    array.opened = std::move(*opened);
    array.classes = model::symmetry_classes(*whole);
    array.opened_classes = model::symmetry_classes(array.opened);
    array.pin_pin_deg = 180.0;
    array.pin_shield_deg = 180.0;
    for (const model::PinClass& one : array.classes) {
      array.pin_pin_deg = std::min(array.pin_pin_deg, one.to_pins.front().angle_deg);
      array.pin_shield_deg = std::min(array.pin_shield_deg, one.to_shields.front().angle_deg);
    }
    array.shield_shield_deg = nearest_shields_deg(*whole);
    search.arrays_.push_back(std::move(array));
  }
  return search;
}

std::vector<Search::Job> Search::jobs() const {
  std::map<double, std::vector<double>> diameters;
  for (const Size& shield : space_.shields)
    diameters[shield.height_mm].push_back(shield.diameter_mm);
  std::vector<Job> jobs;
  for (const Array& array : arrays_) {
    for (const Size& pin : space_.pins) {
      for (const double sphere_mm : space_.spheres_mm)
        for (const auto& [height_mm, of_height] : diameters)
          jobs.push_back({&array, pin, height_mm, of_height, sphere_mm});
    }
  }
  return jobs;
}

bool Search::fits(const Job& job, double diameter_mm) const {
  const model::CylinderMagnet pin{job.pin.diameter_mm, job.pin.height_mm};
  const model::CylinderMagnet shield{diameter_mm, job.shield_height_mm};
  const auto apart = [&](const model::CylinderMagnet& a, const model::CylinderMagnet& b,
                         double angle_deg) {
    return model::gap_mm({a, b, job.sphere_mm}, {angle_deg, 0.0, 0.0}) >= demands_.wall_mm;
  };
  return apart(pin, pin, job.array->pin_pin_deg) && apart(pin, shield, job.array->pin_shield_deg) &&
         apart(shield, shield, job.array->shield_shield_deg);
}

std::vector<double> Search::coil_forces_n(const Job& job) const {
  if (!space_.coil_forces_n.empty()) return space_.coil_forces_n;
  return {model::coil_force_n(model::fea_electromagnet(), model::kBurstCurrentA,
                              {job.pin.diameter_mm, job.pin.height_mm}, job.sphere_mm, 0.0, 0.0)};
}

Search::Batch Search::look(const Job& job) const {
  Batch batch;
  std::vector<double> diameters;
  std::copy_if(job.diameters_mm.begin(), job.diameters_mm.end(), std::back_inserter(diameters),
               [&](double diameter_mm) { return fits(job, diameter_mm); });
  const std::vector<double> forces_n = coil_forces_n(job);
  batch.fit = diameters.size() * forces_n.size();
  if (diameters.empty()) return batch;
  std::sort(diameters.begin(), diameters.end());
  Design design;
  design.array = job.array->opened.name;
  design.magnet = job.pin;
  design.shield = {diameters.front(), job.shield_height_mm};
  design.sphere_mm = job.sphere_mm;
  std::vector<Pull> pulls;
  for (const model::PinClass& one : job.array->classes)
    pulls.emplace_back(one, design.sizes(), diameters);
  for (const double diameter_mm : diameters) {
    design.shield.diameter_mm = diameter_mm;
    for (const double force_n : forces_n) {
      const auto reach = reach_of(job.array->classes, pulls, diameter_mm, force_n, demands_);
      if (!reach) continue;
      design.coil_force_n = force_n;
      batch.found.push_back({design, job.array->opened.pins.size(),
                             job.array->opened.shields.size(), reach->rest_mm, reach->extension_mm,
                             mass_of(job.array->opened, design).total_g(),
                             outer_diameter_mm(design)});
    }
  }
  return batch;
}

std::optional<Found> Search::opened(const Found& found) const {
  const auto array = std::find_if(arrays_.begin(), arrays_.end(), [&](const Array& one) {
    return one.opened.name == found.design.array;
  });
  const double diameter_mm = found.design.shield.diameter_mm;
  std::vector<Pull> pulls;
  for (const model::PinClass& one : array->opened_classes)
    pulls.emplace_back(one, found.design.sizes(), std::vector{diameter_mm});
  if (!reach_of(array->opened_classes, pulls, diameter_mm, found.design.coil_force_n, demands_))
    return {};
  // The figures of this ball as in all verbs.
  const auto classes = study_classes(array->opened_classes, found.design);
  const ClassStudy& typical = typical_of(classes);
  if (!typical.rest_mm() || !typical.extension_mm()) return {};
  Found built = found;
  built.rest_mm = *typical.rest_mm();
  built.extension_mm = *typical.extension_mm();
  built.wall_mm = thinnest_wall(casing_of(found.design, array->opened), array->opened).mm;
  return built;
}

SearchOutcome Search::run(int threads, const Progress& progress) const {
  SearchOutcome outcome;
  const std::vector<Job> all = jobs();
  std::vector<Batch> batches(all.size());
  const std::size_t per_force = std::max<std::size_t>(1, space_.coil_forces_n.size());
  parallel_for(
      all.size(), threads, [&](std::size_t i) { batches[i] = look(all[i]); },
      [&](std::size_t done) {
        progress(done * space_.size() / std::max<std::size_t>(1, all.size()));
      });
  std::vector<Found> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    outcome.looked_at += all[i].diameters_mm.size() * per_force;
    outcome.fit += batches[i].fit;
    found.insert(found.end(), batches[i].found.begin(), batches[i].found.end());
  }
  outcome.feasible = found.size();
  auto checked = checked_front(std::move(found), [&](const std::vector<Found>& some) {
    std::vector<std::optional<Found>> built(some.size());
    parallel_for(
        some.size(), threads, [&](std::size_t k) { built[k] = opened(some[k]); },
        [&](std::size_t) { progress(outcome.looked_at); });
    return built;
  });
  outcome.front = std::move(checked.front);
  outcome.refused_when_opened = checked.refused;
  return outcome;
}

}  // namespace hedgehog::design
