// SPDX-License-Identifier: MIT
// `analyse`, `export` and `levels`: results of a study.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::study {

struct AnalyseOptions {
  std::string out{};  // default: analysis/ in the study
  bool json = false;
};
int run_analyse(const AnalyseOptions& options);

struct ExportOptions {
  std::string format = "csv";
  std::string out{};                   // default: data.csv or bids/ in the study
  std::vector<std::string> authors{};  // of BIDS; default: the experimenters' codes
};
int run_export(const ExportOptions& options);

struct LevelsOptions {
  double threshold_a = 2.1;
  double force_percent = 13.0;
  double speed_percent = 49.0;
};
int run_levels(const LevelsOptions& options);

}  // namespace hedgehog::study
