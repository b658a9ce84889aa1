#include "app/experiments/experiment_sweep.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/options/arguments.h"
#include "app/options/option_values.h"
#include "base/number_text.h"
#include "scene/reading/format.h"
#include "scene/reading/vocabulary.h"
#include "study/plots/plot.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

constexpr std::size_t kMostValues = 10'000;
constexpr const char* kHint = "write KEY=0.1..0.4:0.05 or KEY=a,b,c";

// Parts between commas, but for those within brackets and quotes.
std::vector<std::string> listed(std::string_view text) {
  std::vector<std::string> values(1);
  int depth = 0;
  char quote = '\0';
  for (const char one : text) {
    if (quote != '\0' && one == quote)
      quote = '\0';
    else if (quote == '\0' && (one == '"' || one == '\''))
      quote = one;
    if (quote == '\0') depth += one == '[' || one == '{' ? 1 : one == ']' || one == '}' ? -1 : 0;
    if (one == ',' && depth == 0 && quote == '\0')
      values.emplace_back();
    else
      values.back() += one;
  }
  return values;
}

// Steps are counted, not added up, and shown with the digits that matter.
std::optional<std::vector<std::string>> steps(std::string_view text) {
  const std::size_t dots = text.find(".."), colon = text.find(':');
  if (dots == std::string_view::npos || colon == std::string_view::npos || colon < dots)
    return std::nullopt;
  const auto from = parse_number(text.substr(0, dots));
  const auto to = parse_number(text.substr(dots + 2, colon - dots - 2));
  const auto step = parse_number(text.substr(colon + 1));
  if (!from || !to || !step || !(*step > 0)) return std::nullopt;
  const double count = std::floor((*to - *from) / *step + 1e-9);
  if (!(count >= 0 && count < static_cast<double>(kMostValues))) return std::nullopt;
  std::vector<std::string> values;
  const bool whole = std::floor(*from) == *from && std::floor(*step) == *step;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i) {
    const double value = *from + static_cast<double>(i) * *step;
    values.push_back(whole ? fmt::format("{:.0f}", value) : fmt::format("{:.12g}", value));
  }
  return values;
}

// What the vocabulary calls a number of a key, "degrees"; "" where it is a number, no more.
std::string unit_of(const std::string& key) {
  const std::vector<std::string_view> path = split(key, '.');
  for (std::size_t i = path.size() - 1; i-- > 0;)  // tables, names and numbers of their entries
    for (const TableInfo& table : vocabulary())
      for (const KeyInfo& one : table.keys) {
        if (KindInfo::name(table) != path[i] || one.name != path.back()) continue;
        const std::string takes(one.takes), unit = takes.substr(0, takes.find(" or "));
        return unit.starts_with("degrees") || unit == "seconds" ? unit : "";
      }
  return "";
}

// Whether there is something to see: a number that is counted may be the same for all values.
bool differ(const std::vector<Plot::Point>& points) {
  return std::ranges::any_of(
      points, [&](const Plot::Point& one) { return one.half > 0 || one.y != points.front().y; });
}

}  // namespace

Result<Sweep> parse_sweep(std::string_view text, const Place& where) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == text.size())
    return usage_error(where, fmt::format("'{}' has no key or no values", text), kHint);
  Sweep sweep{std::string(trimmed(text.substr(0, equals))), {}};
  const std::string_view values = text.substr(equals + 1);
  if (values.find("..") == std::string_view::npos || values.find_first_of("\"'[") == 0) {
    sweep.values = listed(values);
    return sweep;
  }
  auto stepped = steps(values);
  if (!stepped)
    return usage_error(
        where, fmt::format("'{}' is not a range of up to {} steps", values, kMostValues), kHint);
  sweep.values = std::move(*stepped);
  return sweep;
}

SweepResults::SweepResults(std::string experiment, Sweep sweep)
    : experiment_(std::move(experiment)), sweep_(std::move(sweep)), table_({sweep_.key}) {}

void SweepResults::add(const std::string& value, const ExperimentResult& result) {
  if (table_.columns.size() == 1)
    std::ranges::copy(result.table.columns, std::back_inserter(table_.columns));
  result.table.each_row([&](Values row) {
    row.insert(row.begin(), value);
    table_.add(std::move(row));
  });
  holds_ = holds_ && result.holds;
  for (const Measure& one : result.measures)
    if (std::ranges::find(names_, one.name) == names_.end()) names_.push_back(one.name);
  found_.emplace_back(value, result.measures);
}

ExperimentResult SweepResults::result() && {
  const std::string unit = unit_of(sweep_.key);
  ExperimentResult all;
  all.files.push_back(csv_file("sweep", table_));
  all.files.push_back(json_file(
      "sweep", {{"experiment", experiment_}, {"sweep", sweep_.key}, {"measures", table_}}));
  for (const std::string& name : names_) {
    Plot plot{
        experiment_ + ": " + name,
        sweep_.key + (unit.empty() ? "" : ", " + unit),
        name,
        {{"found", {}, true}, {"expected", {}, false}, {"found, without an interval", {}, true}}};
    plot.caption = "lengths in world units, times at speed 1";
    for (const auto& [value, measures] : found_) {
      const auto x = parse_number(value);
      for (const Measure& one : measures) {
        if (!x || one.name != name) continue;
        const auto half = half_interval(one);
        plot.series[half ? 0 : 2].points.push_back({*x, one.value, half.value_or(0)});
        if (one.expected) plot.series[1].points.push_back({*x, *one.expected, 0});
      }
    }
    if (differ(plot.series[0].points) || differ(plot.series[2].points))
      all.files.push_back({"sweep_" + name + ".svg", svg(plot)});
  }
  all.summary =
      fmt::format("{} over {}\n\n{}", experiment_, sweep_.key, aligned_text(table_, kBrief));
  all.holds = holds_;
  all.table = std::move(table_);
  return all;
}

}  // namespace flatray
