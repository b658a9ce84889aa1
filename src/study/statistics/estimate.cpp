#include "study/statistics/estimate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/table.h"

namespace flatray {
namespace {

// Where the samples do not differ, rounding of the sums is all there is.
constexpr double kRounding = 1e-12;

std::optional<double> z(const Measure& measure) {
  if (!measure.expected || !measure.standard_error) return std::nullopt;
  const double difference = measure.value - *measure.expected;
  return difference == 0 ? 0 : difference / *measure.standard_error;
}

Table table_of(const std::vector<Measure>& measures) {
  Table table(
      {"measure", "value", "low", "high", "standard_error", "expected", "z", "agrees", "remark"});
  for (const Measure& one : measures) {
    const bool known = std::isfinite(one.value);
    table.add({one.name, known ? JsonValue(one.value) : JsonValue(), end_cell(one, &Range::low),
               end_cell(one, &Range::high), one.standard_error, one.expected, z(one), verdict(one),
               known ? one.remark : "nothing was measured"});
  }
  return table;
}

// Wilson and Hilferty's cube of a normal number.
double chi_squared(double freedom, double normal) {
  const double ninth = 2 / (9 * freedom), root = 1 - ninth + normal * std::sqrt(ninth);
  return freedom * root * root * root;
}

}  // namespace

void RatioSums::add(double sample_x, double sample_y) {
  ++samples;
  x += sample_x;
  y += sample_y;
  sample_x -= about * sample_y;
  const double square_x = sample_x * sample_x, square_y = sample_y * sample_y;
  xx += square_x;
  xy += sample_x * sample_y;
  yy += square_y;
  xxx += square_x * sample_x;
  xxy += square_x * sample_y;
  xyy += sample_x * square_y;
  yyy += square_y * sample_y;
}

double RatioSums::standard_error() const {
  const double r = ratio() - about, squares = xx - 2 * r * xy + r * r * yy;
  return std::sqrt(std::max(squares, 0.0) * samples / (samples - 1)) / std::fabs(y);
}

double RatioSums::widening() const {
  constexpr double z = 1.959963984540054, part = (z * z * (z * z + 2) - 3) / 18;
  const double r = ratio() - about, squares = xx - 2 * r * xy + r * r * yy;
  if (!(squares > 0)) return 1;
  const double cubes = xxx - 3 * r * xxy + 3 * r * r * xyy - r * r * r * yyy;
  const double skewness = cubes / squares / std::sqrt(squares),
               skewness2 = skewness * skewness * samples;
  if (!std::isfinite(skewness2)) return kInfinity;
  const double by_chance = 6 / samples;
  return 1 + part * std::clamp((skewness2 - by_chance) / samples, 0.0, 1.0);
}

void RatioSums::append_to(SumList& list) {
  list.insert(list.end(), {&samples, &x, &y, &xx, &xy, &yy, &xxx, &xxy, &xyy, &yyy});
}

Measure RatioSums::measure(std::string name, std::optional<double> expected) const {
  if (samples < 2)
    return {std::move(name), ratio(), {}, {}, 0, {}, "no error: of one sample alone"};
  Measure one{std::move(name), ratio(), standard_error(), expected, samples - 1};
  one.widening = widening();
  const bool lost = (yy == 0 && y != 0) || (xx == 0 && x != 0 && about == 0);
  if (!lost && std::isfinite(*one.standard_error * one.widening)) return one;
  withhold_error(one, "no error: squares of such numbers are beyond the doubles");
  return one;
}

Measure RatioSums::share(std::string name, std::string remark) const {
  constexpr double kFewest = 10;
  // Groups that all count as many may yet be off by what none of them shows: three of all samples
  // at most in 95 % of runs, nine in all but one of 16,000.
  constexpr double kLeastError = 2;
  Measure one = measure(std::move(name));
  if (one.standard_error) one.standard_error = std::max(*one.standard_error, kLeastError / y);
  if (!remark.empty()) one.remark = std::move(remark);
  if (x < kFewest || y - x < kFewest)
    withhold_error(one, one.remark + (one.remark.empty() ? "" : "; ") +
                            "no error: fewer than ten are of one kind");
  return one;
}

double student_95(double freedom) {
  constexpr double z = 1.959963984540054, s = z * z;
  const double n = 1 / freedom;
  return z *
         (1 + n * ((s + 1) / 4 +
                   n * (((5 * s + 16) * s + 3) / 96 +
                        n * ((((3 * s + 19) * s + 17) * s - 15) / 384 +
                             n * ((((79 * s + 776) * s + 1482) * s - 1920) * s - 945) / 92160))));
}
double allowed_errors(double freedom) {
  const double n = std::min(freedom, 1e9), z = kAllowedErrors * (8 * n + 3) / (8 * n + 1);
  return std::sqrt(n * (portable::exp(z * z / n) - 1));
}
double chi_squared_95(double freedom) { return chi_squared(freedom, 1.6448536269514722); }
double chi_squared_5(double freedom) { return chi_squared(freedom, -1.6448536269514722); }

double half_of_rms(double count) { return std::sqrt(count / chi_squared_5(count)) - 1; }

std::optional<double> half_interval(const Measure& measure) {
  if (!measure.standard_error || !std::isfinite(measure.value + *measure.standard_error))
    return std::nullopt;
  return student_95(measure.freedom) * measure.widening * *measure.standard_error;
}

std::optional<Range> interval(const Measure& measure) {
  if (measure.proven) return measure.proven;
  const std::optional<double> half = half_interval(measure);
  if (!half) return std::nullopt;
  return Range{measure.value - *half, measure.value + *half};
}

JsonValue end_cell(const Measure& measure, double Range::*end) {
  const std::optional<Range> ends = interval(measure);
  return ends ? JsonValue((*ends).*end) : JsonValue();
}

bool agrees(const Measure& measure) {
  if (!measure.expected) return true;
  if (!std::isfinite(measure.value)) return false;
  const double errors = allowed_errors(measure.freedom) * measure.widening;
  const std::optional<double> allowed =
      measure.standard_error ? errors * *measure.standard_error : measure.allowed;
  return !allowed || std::fabs(measure.value - *measure.expected) <=
                         *allowed + kRounding * std::fabs(*measure.expected);
}

std::optional<std::string> verdict(const Measure& measure) {
  if (!measure.expected || !(measure.standard_error || measure.allowed)) return {};
  return agrees(measure) ? "yes" : "no";
}

ExperimentResult measured(const ExperimentContext& context, const std::string& name,
                          const std::string& headline, std::vector<Measure> measures,
                          const std::vector<Measure>& audit) {
  measures.insert(measures.end(), audit.begin(), audit.end());
  ExperimentResult result{.table = table_of(measures)};
  result.holds = std::ranges::all_of(measures, agrees);
  Fields fields = head_of(name, context);
  fields.emplace_back("measures", result.table);
  result.files.push_back(csv_file(name, result.table));
  result.files.push_back(json_file(name, fields));
  result.summary = fmt::format("{}\n\n{}", headline, aligned_text(result.table, kBrief));
  if (!result.holds)
    result.summary +=
        "\nDISAGREES: not what must come out, or farther from it than its standard error allows\n";
  result.measures = std::move(measures);
  return result;
}

}  // namespace flatray
