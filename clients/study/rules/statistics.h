// SPDX-License-Identifier: MIT
// Means, spreads and quantiles.
#pragma once

#include <vector>

namespace hedgehog::study {

double mean(const std::vector<double>& values);
/// With n - 1; 0 for fewer than two.
double standard_deviation(const std::vector<double>& values);
/// Linear between the order statistics (type 7 of Hyndman and Fan 1996). REQUIRES: not empty,
/// 0 <= share <= 1.
double quantile(std::vector<double> values, double share);
/// Pearson's. REQUIRES: the same number of each.
double correlation(const std::vector<double>& a, const std::vector<double>& b);
/// The probability of `count` or more heads among `tosses` fair coins.
double coin_tail(int count, int tosses);

}  // namespace hedgehog::study
