// SPDX-License-Identifier: MIT
// What an importer reads from a file, before its conversion to key frames. Included by the
// importers only.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/import/foreign_json.h"
#include "clients/lib/import/timeline.h"

namespace hedgehog::client {

/// What was left out or changed; each sentence once.
class Notes {
 public:
  void add(std::string sentence) {
    if (std::find(all_.begin(), all_.end(), sentence) == all_.end())
      all_.push_back(std::move(sentence));
  }
  const std::vector<std::string>& all() const noexcept { return all_; }

 private:
  std::vector<std::string> all_;
};

struct Reading {
  std::string description;
  std::vector<Layer> layers;
  std::optional<model::Waveform> waveform;
  std::optional<double> frequency_hz;
  Notes notes;
};

/// kBadData with the message `what`.
inline ClientError bad_data(std::string what) { return {Failure::kBadData, std::move(what), {}}; }

Outcome<Reading> read_ahap(const ForeignJson& file);
Outcome<Reading> read_hjif(const ForeignJson& file);

}  // namespace hedgehog::client
