#include "study/statistics/stretches.h"

#include <fmt/core.h>

#include <cmath>

namespace flatray {
namespace {

// How much of what a stretch is off the mean by the next one is too, from -1 to 1.
double likeness(std::span<const Stretch> stretches, double ratio) {
  double together = 0, square = 0, before = 0;
  for (const Stretch& one : stretches) {
    const double off = one.x - ratio * one.y;
    together += off * before;
    square += off * off;
    before = off;
  }
  return square > 0 ? together / square : 0;
}

}  // namespace

Measure measure_of_run(std::string name, std::span<const Stretch> stretches) {
  RatioSums sums, parts;
  Stretch part{0, 0};
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto& [x, y] = stretches[i];
    sums.add(x, y);
    part = {part.x + x, part.y + y};
    if ((i + 1) % kStretchesInPart != 0 && i + 1 < stretches.size()) continue;
    parts.add(part.x, part.y);
    part = {0, 0};
  }
  Measure measure = parts.measure(std::move(name));
  // Of independent stretches it is about normal, with a mean of -1/n and a variance of 1/n.
  constexpr double kOneInTwenty = 1.645;
  const double most = kOneInTwenty / std::sqrt(sums.samples) - 1 / sums.samples;
  if (stretches.size() < kStretches)
    measure.remark = "no error: too short a run";
  else if (likeness(stretches, sums.ratio()) > most)
    measure.remark = "no error: stretches of the run depend on each other";
  else
    measure.remark = fmt::format("error from {} stretches", parts.samples);
  if (measure.remark.starts_with("no")) measure.standard_error.reset();
  return measure;
}

}  // namespace flatray
