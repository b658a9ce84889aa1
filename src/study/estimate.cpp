#include "study/estimate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/table.h"

namespace flatray {
namespace {

// Where the samples do not differ, rounding of the sums is all there is.
constexpr double kRounding = 1e-12;

std::string verdict(const Measure& measure) {
  if (!measure.expected) return "";
  return agrees(measure) ? "yes" : "no";
}

Cell z_cell(const Measure& measure) {
  if (!measure.expected) return std::string();
  const double difference = measure.value - *measure.expected;
  return difference == 0 ? 0 : difference / measure.standard_error;
}

Table table_of(const std::vector<Measure>& measures) {
  Table table({"measure", "value", "low", "high", "standard_error", "expected", "z", "agrees"});
  for (const Measure& one : measures) {
    const double half = kHalfInterval * one.standard_error;
    table.add({one.name, one.value, one.value - half, one.value + half, one.standard_error,
               one.expected ? Cell(*one.expected) : Cell(std::string()), z_cell(one),
               verdict(one)});
  }
  return table;
}

}  // namespace

void RatioSums::add(double sample_x, double sample_y) {
  *this += {1, sample_x, sample_y, sample_x * sample_x, sample_x * sample_y, sample_y * sample_y};
}

RatioSums& RatioSums::operator+=(const RatioSums& other) {
  samples += other.samples;
  x += other.x;
  y += other.y;
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  return *this;
}

double RatioSums::standard_error() const {
  const double r = ratio();
  const double squares = xx - 2 * r * xy + r * r * yy;
  return std::sqrt(std::max(squares, 0.0) * samples / (samples - 1)) / std::fabs(y);
}

void RatioSums::append_to(Numbers& numbers) const {
  numbers.insert(numbers.end(), {samples, x, y, xx, xy, yy});
}

RatioSums RatioSums::from(std::span<const double> six) {
  return {six[0], six[1], six[2], six[3], six[4], six[5]};
}

bool agrees(const Measure& measure) {
  if (!measure.expected) return true;
  return std::fabs(measure.value - *measure.expected) <=
         kAllowedErrors * measure.standard_error + kRounding * std::fabs(*measure.expected);
}

ExperimentResult measured(const ExperimentContext& context, const std::string& name,
                          const std::string& headline, std::vector<Measure> measures) {
  const Table table = table_of(measures);
  ExperimentResult result;
  result.holds = std::all_of(measures.begin(), measures.end(), agrees);
  result.files.push_back({name + ".csv", table.csv()});
  result.files.push_back(
      {name + ".json", json_document({{"experiment", name},
                                      {"scene", context.scene.name},
                                      {"scene_hash", fmt::format("{:016x}", context.scene.hash)},
                                      {"seed", context.seed},
                                      {"count", context.count}},
                                     {{"measures", &table}})});
  result.summary = fmt::format("{}\n\n{}", headline, table.text());
  if (!result.holds)
    result.summary += fmt::format(
        "\nDISAGREES: more than {} standard errors from what must come "
        "out\n",
        kAllowedErrors);
  result.measures = std::move(measures);
  return result;
}

}  // namespace flatray
