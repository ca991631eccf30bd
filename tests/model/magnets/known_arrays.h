// SPDX-License-Identifier: MIT
// Named arrays and their classes, computed once for a test program.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/magnets/arrangement.h"
#include "model/magnets/symmetry_classes.h"

namespace hedgehog::model {

inline const Arrangement& arrangement(const std::string& name) {
  static std::map<std::string, Arrangement> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second
                              : known.emplace(name, arrangement_named(name).value()).first->second;
}

inline const std::vector<PinClass>& classes(const std::string& name) {
  static std::map<std::string, std::vector<PinClass>> known;
  const auto found = known.find(name);
  return found != known.end()
             ? found->second
             : known.emplace(name, symmetry_classes(arrangement(name))).first->second;
}

}  // namespace hedgehog::model
