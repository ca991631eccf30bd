// SPDX-License-Identifier: MIT
// Quantiles: of delays that were measured one by one, and of histograms.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::bench {

/// Of all `delays`, which may be in any order; 0 without any. `q` 0..1.
double quantile(std::vector<double> delays, double q);

/// Of the lines "US COUNT" of a text (cyclictest --histogram), in us: the end of that microsecond,
/// as the daemon's status has it.
double quantile_us(const std::string& counts, double q);

/// Counts by seconds.
class DelayHistogram {
 public:
  /// `name` of a page of metrics in Prometheus' text form.
  DelayHistogram(const std::string& page, const std::string& name);

  /// What was counted since `earlier`.
  DelayHistogram since(const DelayHistogram& earlier) const;

  /// Interpolated within a bucket, whose bounds are far apart.
  double quantile_us(double q) const;
  double count() const;
  double mean_us() const { return count() > 0.0 ? sum_s_ * 1e6 / count() : 0.0; }

 private:
  std::vector<double> upper_s_;  // the last is infinite
  std::vector<double> counts_;
  double sum_s_ = 0.0;
};

}  // namespace hedgehog::bench
