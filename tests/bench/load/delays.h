// SPDX-License-Identifier: MIT
// Quantiles: of delays that were measured one by one, and of histograms with buckets as wide as
// those of /metrics.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::bench {

/// Of all `delays`, which may be in any order; 0 without any. `q` 0..1.
double quantile(std::vector<double> delays, double q);

/// Counts by seconds. Quantiles are interpolated within a bucket, so those of two histograms can be
/// compared only if they have the same bounds.
class DelayHistogram {
 public:
  /// `name` of a page of metrics in Prometheus' text form.
  DelayHistogram(const std::string& page, const std::string& name);

  /// What was counted since `earlier`.
  DelayHistogram since(const DelayHistogram& earlier) const;
  /// The lines "US COUNT" of a text (cyclictest --histogram), in buckets like these.
  DelayHistogram like_this(const std::string& text) const;

  double quantile_us(double q) const;
  double count() const;
  double mean_us() const { return count() > 0.0 ? sum_s_ * 1e6 / count() : 0.0; }

 private:
  std::vector<double> upper_s_;  // the last is infinite
  std::vector<double> counts_;
  double sum_s_ = 0.0;
};

}  // namespace hedgehog::bench
