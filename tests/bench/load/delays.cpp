// SPDX-License-Identifier: MIT
#include "tests/bench/load/delays.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace hedgehog::bench {

double quantile(std::vector<double> delays, double q) {
  if (delays.empty()) return 0.0;
  const auto last = static_cast<double>(delays.size() - 1);
  const auto at = delays.begin() + static_cast<std::ptrdiff_t>(q * last);
  std::nth_element(delays.begin(), at, delays.end());
  return *at;
}

double quantile_us(const std::string& counts, double q) {
  std::map<double, double> by_us;
  double total = 0.0;
  std::istringstream lines(counts);
  for (std::string line; std::getline(lines, line);) {
    double us = 0.0;
    double count = 0.0;
    if (line.starts_with('#') || !(std::istringstream(line) >> us >> count)) continue;
    by_us[us] += count;
    total += count;
  }
  double sum = 0.0;
  for (const auto& [us, count] : by_us)
    if ((sum += count) >= q * total) return us + 1.0;
  throw std::runtime_error("a histogram without counts");
}

DelayHistogram::DelayHistogram(const std::string& page, const std::string& name) {
  std::istringstream lines(page);
  double below = 0.0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name + "_sum")) sum_s_ = std::stod(line.substr(line.rfind(' ')));
    if (!line.starts_with(name + "_bucket")) continue;
    const std::string bound = line.substr(line.find("le=\"") + 4);
    const double up_to = std::stod(line.substr(line.rfind(' ')));
    upper_s_.push_back(bound.starts_with("+Inf") ? std::numeric_limits<double>::infinity()
                                                 : std::stod(bound));
    counts_.push_back(up_to - below);
    below = up_to;
  }
  if (counts_.empty()) throw std::runtime_error("no histogram " + name + " in /metrics");
}

DelayHistogram DelayHistogram::since(const DelayHistogram& earlier) const {
  DelayHistogram rest = *this;
  for (std::size_t i = 0; i < counts_.size(); ++i) rest.counts_[i] -= earlier.counts_[i];
  rest.sum_s_ -= earlier.sum_s_;
  return rest;
}

double DelayHistogram::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), 0.0);
}

double DelayHistogram::quantile_us(double q) const {
  const double rank = q * count();
  double below = 0.0;
  double lower_s = 0.0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const bool is_last = i + 1 == counts_.size();
    if (counts_[i] > 0.0 && below + counts_[i] >= rank) {
      const double width_s = is_last ? 0.0 : upper_s_[i] - lower_s;
      return 1e6 * (lower_s + width_s * (rank - below) / counts_[i]);
    }
    below += counts_[i];
    lower_s = upper_s_[i];
  }
  return 0.0;
}

}  // namespace hedgehog::bench
