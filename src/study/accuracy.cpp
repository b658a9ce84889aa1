#include "study/accuracy.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/processor_time.h"

namespace flatray {

#define FLATRAY_ENTRY(name) extern const Choice name;
namespace choice_entries {
#include "choices.inc"
}  // namespace choice_entries
#undef FLATRAY_ENTRY

namespace {

constexpr std::size_t kRounds = 3;
constexpr double kTold = 0.002;  // seconds that the processor's clock tells well
constexpr std::uint64_t kMostRuns = 1 << 16;

// Of one run, of as many as the clock can tell.
double timed(const std::function<void()>& work) {
  for (std::uint64_t runs = 1;; runs *= 2) {
    const double start = processor_seconds();
    for (std::uint64_t run = 0; run < runs; ++run) work();
    const double taken = processor_seconds() - start;
    if (taken >= kTold || runs >= kMostRuns) return taken / static_cast<double>(runs);
  }
}

// The first round: which settings there is time for, what they come to, and how long they took.
struct FirstRound {
  std::vector<const Setting*> settings;
  std::vector<std::vector<double>> seconds;
};

FirstRound first_round(const std::vector<Setting>& settings, double budget, ChoiceReport& report) {
  FirstRound round;
  double used = 0, each = 0;  // seconds so far, and for each of n
  for (const Setting& setting : settings) {
    if (kRounds * (used + each * setting.n) > budget) {
      report.cut += (report.cut.empty() ? "" : ", ") + setting.words;
      continue;
    }
    const double taken = timed(setting.work);
    used += taken;
    if (setting.n > 0) each = taken / setting.n;
    round.settings.push_back(&setting);
    round.seconds.push_back({taken});
    report.points.push_back({setting.words, setting.n, 0, 0, setting.judge(), false});
  }
  return round;
}

bool beats(const AccuracyPoint& a, const AccuracyPoint& b) {
  return a.seconds <= b.seconds && a.outcome.error <= b.outcome.error &&
         (a.seconds < b.seconds || a.outcome.error < b.outcome.error);
}

void mark_best(std::vector<AccuracyPoint>& points) {
  for (AccuracyPoint& point : points)
    point.best = std::none_of(points.begin(), points.end(),
                              [&](const AccuracyPoint& other) { return beats(other, point); });
}

}  // namespace

const char* name(ErrorKind kind) {
  constexpr const char* kNames[] = {"sampling", "truncation", "discretisation", "rounding"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<const Choice*> choices() {
  return {
#define FLATRAY_ENTRY(name) &choice_entries::name,
#include "choices.inc"
#undef FLATRAY_ENTRY
  };
}

std::optional<FittedOrder> fit_order(const std::vector<AccuracyPoint>& points) {
  std::vector<std::pair<double, double>> logs;
  for (const AccuracyPoint& point : points)
    if (point.n > 0 && point.outcome.error > 0)
      logs.emplace_back(portable::log(point.n), portable::log(point.outcome.error));
  if (logs.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(logs.size());
  double x = 0, y = 0;
  for (const auto& [n, error] : logs) x += n / count, y += error / count;
  double xx = 0, xy = 0, rest = 0;
  for (const auto& [n, error] : logs) xx += (n - x) * (n - x), xy += (n - x) * (error - y);
  if (xx == 0) return std::nullopt;
  const double slope = xy / xx;
  for (const auto& [n, error] : logs) {
    const double off = error - y - slope * (n - x);
    rest += off * off;
  }
  return FittedOrder{slope, std::sqrt(rest / (count - 2) / xx)};
}

ChoiceReport measure_choice(const Choice& choice, const AccuracyContext& context) {
  ChoiceReport report;
  report.name = choice.name;
  report.question = choice.question;
  report.kind = choice.kind;
  report.left_out = choice.left_out(context.scene);
  if (!report.left_out.empty()) return report;
  const Result<ChoiceSettings> made = choice.settings(context);
  if (!made) {
    report.left_out = made.error().front().message;
    return report;
  }
  report.reference = made->reference;
  report.unit = made->unit;
  report.grows = made->grows;
  auto [settings, seconds] = first_round(made->settings, context.seconds, report);
  for (std::size_t round = 1; round < kRounds; ++round)
    for (std::size_t i = 0; i < settings.size(); ++i)
      seconds[i].push_back(timed(settings[i]->work));
  for (std::size_t i = 0; i < settings.size(); ++i) {
    std::sort(seconds[i].begin(), seconds[i].end());
    report.points[i].seconds = seconds[i][kRounds / 2];
    report.points[i].spread = 0.5 * (seconds[i].back() - seconds[i].front());
  }
  report.one_question = made->one_question;
  if (report.one_question) mark_best(report.points);
  if (made->ordered) report.order = fit_order(report.points);
  return report;
}

}  // namespace flatray
