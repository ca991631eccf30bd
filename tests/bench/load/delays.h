// SPDX-License-Identifier: MIT
// Quantiles of delays measured one by one, and of histograms.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::bench {

/// Quantile of `delays`, which may be in any order; 0 if empty. `q` 0..1.
double quantile(std::vector<double> delays, double q);

/// Quantile of the lines "US COUNT" of a text (cyclictest --histogram), in us: the end of that
/// microsecond, as in the daemon's status.
double quantile_us(const std::string& counts, double q);

/// A histogram of delays, s.
class DelayHistogram {
 public:
  /// Reads `name` from a page of metrics in Prometheus' text form.
  DelayHistogram(const std::string& page, const std::string& name);

  /// The counts since `earlier`.
  DelayHistogram since(const DelayHistogram& earlier) const;

  /// Interpolated within a bucket, because the bucket bounds are far apart.
  double quantile_us(double q) const;
  double count() const;
  double mean_us() const { return count() > 0.0 ? sum_s_ * 1e6 / count() : 0.0; }

 private:
  std::vector<double> upper_s_;  // the last is infinite
  std::vector<double> counts_;
  double sum_s_ = 0.0;
};

}  // namespace hedgehog::bench
