// SPDX-License-Identifier: MIT
#include "tests/bench/load/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

namespace hedgehog::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Three significant digits.
std::string number(double value) {
  const double size = std::abs(value);
  if (size >= 100'000) return fmt::format("{:.0f}k", value / 1000.0);
  if (size >= 100) return fmt::format("{:.0f}", value);
  if (size >= 10) return fmt::format("{:.1f}", value);
  return fmt::format("{:.2f}", value);
}

/// Processor time of each function that was measured, by program.
Json functions_in(const std::string& folder) {
  Json programs = Json::object();
  std::error_code ec;
  for (const auto& file : std::filesystem::directory_iterator(folder, ec)) {
    std::ifstream text(file.path());
    const Json measured = Json::parse(text, nullptr, false);
    if (!measured.is_object()) continue;
    const Json functions = measured.value("benchmarks", Json::array());
    for (const Json& one : functions)
      programs[file.path().stem().string()].push_back(
          {{"name", one["name"]}, {"value", one["cpu_time"]}, {"unit", one["time_unit"]}});
  }
  return programs;
}

std::string median_text(const std::optional<Range>& range) {
  return range ? number(range->median) : "-";
}

/// Of the ratio, or of the value if there is no reference.
std::string range_text(const Result& result) {
  if (const auto& ratio = result.ratio)
    return fmt::format("{:.2f} ({:.2f}..{:.2f})", ratio->median, ratio->min, ratio->max);
  if (const auto& value = result.value; value && result.row.reference.empty())
    return fmt::format("({}..{})", number(value->min), number(value->max));
  return "";
}

Json json_of(const std::optional<Range>& range) {
  if (!range) return nullptr;
  return {{"median", range->median}, {"min", range->min}, {"max", range->max}};
}

void add_round(const Row& row, const Figures& round, std::vector<double>& values,
               std::vector<double>& references, std::vector<double>& ratios) {
  const auto value = round.values.find(row.value);
  const auto reference = round.values.find(row.reference);
  const auto end = round.values.end();
  if (value != end) values.push_back(value->second);
  if (reference != end) references.push_back(reference->second);
  if (value != end && reference != end && reference->second > 0.0)
    ratios.push_back(value->second / reference->second);
}

}  // namespace

std::optional<Range> Range::of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median =
      values.size() % 2 != 0 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return Range{median, values.front(), values.back()};
}

std::vector<Result> results(const std::vector<Row>& rows, const std::vector<Figures>& rounds) {
  std::vector<Result> all;
  for (const Row& row : rows) {
    std::vector<double> values;
    std::vector<double> references;
    std::vector<double> ratios;
    Result& result = all.emplace_back(Result{row, {}, {}, {}, {}, {}});
    for (const Figures& round : rounds) {
      add_round(row, round, values, references, ratios);
      for (const std::string& name : {row.value, row.reference})
        if (const auto reason = round.left_out.find(name); reason != round.left_out.end())
          result.left_out = reason->second;
    }
    result.value = Range::of(values);
    result.reference = Range::of(references);
    result.ratio = Range::of(ratios);
    const auto& compared = row.goal.of == Goal::Of::kRatio ? result.ratio : result.value;
    if (row.goal.of != Goal::Of::kNothing && compared)
      result.is_met = row.goal.is_met_by(compared->median);
  }
  return all;
}

std::string table_of(const std::vector<Result>& results) {
  constexpr const char* kLine = "{:<38}{:>9} {:<5}{:>9}  {:<14}{:<22}{:<10}{}\n";
  std::string text =
      fmt::format(kLine, "measure", "ours", "unit", "theirs", "of", "ratio (range)", "goal", "");
  for (const Result& one : results) {
    const std::string outcome = !one.left_out.empty() ? one.left_out
                                : one.is_incomplete() ? "NO FIGURE"
                                : !one.is_met         ? ""
                                : *one.is_met         ? "met"
                                                      : "NOT MET";
    text += fmt::format(kLine, one.row.name, median_text(one.value), one.row.unit,
                        one.row.reference.empty() ? "" : median_text(one.reference),
                        one.row.reference_name, range_text(one), one.row.goal.text(), outcome);
  }
  return text;
}

std::string json_of(const std::vector<Result>& results, const Run& run) {
  Json rows = Json::array();
  for (const Result& one : results) {
    Json row{{"measure", one.row.name}, {"unit", one.row.unit}, {"value", json_of(one.value)}};
    if (!one.row.reference.empty()) {
      row["of"] = one.row.reference_name;
      row["reference"] = json_of(one.reference);
      row["ratio"] = json_of(one.ratio);
    }
    if (one.row.goal.of != Goal::Of::kNothing) {
      row["goal"] = one.row.goal.text();
      row["met"] = one.is_met ? Json(*one.is_met) : Json(nullptr);
    }
    if (!one.left_out.empty()) row["left_out"] = one.left_out;
    rows.push_back(std::move(row));
  }
  Json all{{"commit", run.commit}, {"date", run.date},       {"machine", run.machine},
           {"rounds", run.rounds}, {"seconds", run.seconds}, {"rows", rows}};
  if (!run.functions.empty()) all["functions"] = functions_in(run.functions);
  return all.dump(2) + "\n";
}

}  // namespace hedgehog::bench
