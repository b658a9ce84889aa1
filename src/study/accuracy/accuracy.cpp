#include "study/accuracy/accuracy.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/processor_time.h"
#include "collide/scene_timeline.h"
#include "render/frame.h"
#include "study/accuracy/timed.h"

namespace flatray {

#include "choices.inc"  // choices()

namespace {

constexpr std::size_t kRounds = 3;
constexpr double kTold = 0.002;  // seconds that the processor's clock tells well

double timed(const std::function<void()>& work) {
  return seconds_of(work, &processor_seconds, kTold);
}

// What a choice takes of the processor from here on.
class Budget {
 public:
  explicit Budget(double seconds) : seconds_(seconds), start_(processor_seconds()) {}
  double used() const { return processor_seconds() - start_; }
  bool allows(double more) const { return used() + more <= seconds_; }

 private:
  double seconds_, start_;
};

// Times by setting, and how long a round of them takes.
struct Rounds {
  std::vector<const Setting*> settings;
  std::vector<std::vector<double>> seconds;
  double each = 0;
};

// An error below the doubt of the reference may be any up to that doubt.
Outcome as_far_as_known(Outcome outcome, double doubt) {
  if (!(outcome.error < doubt)) return outcome;
  for (std::optional<double>& part : outcome.parts)
    if (part == outcome.error) part = doubt;
  outcome.error = doubt;
  outcome.at_most = true;
  return outcome;
}

// The first round: which settings there is time for, what they come to, and how long they took.
Rounds first_round(const ChoiceSettings& made, const Budget& budget, bool at_least_one,
                   ChoiceReport& report) {
  Rounds round;
  double per_n = 0;
  for (const Setting& setting : made.settings) {
    const double likely = kRounds * per_n * setting.n + (kRounds - 1) * round.each;
    if (!(at_least_one && report.points.empty()) && !budget.allows(likely)) {
      report.cut += (report.cut.empty() ? "" : ", ") + setting.words;
      continue;
    }
    const double taken = timed(setting.work);
    Result<Outcome> outcome = setting.judge();
    if (!outcome) {
      report.missing.push_back({setting.words, outcome.error().front().message});
      continue;
    }
    round.each += taken;
    if (setting.n > 0) per_n = taken / setting.n;
    round.settings.push_back(&setting);
    round.seconds.push_back({taken});
    report.points.push_back({setting.words, setting.n, 0, 0,
                             as_far_as_known(*std::move(outcome), made.doubt), false,
                             setting.options, setting.series});
  }
  return round;
}

// Median and half of the range of all rounds there is time for.
void more_rounds(Rounds& round, const Budget& budget, ChoiceReport& report) {
  for (report.rounds = 1; report.rounds < kRounds && budget.allows(round.each); ++report.rounds)
    for (std::size_t i = 0; i < round.settings.size(); ++i)
      round.seconds[i].push_back(timed(round.settings[i]->work));
  for (std::size_t i = 0; i < round.settings.size(); ++i) {
    std::vector<double>& seconds = round.seconds[i];
    std::ranges::sort(seconds);
    report.points[i].seconds = seconds[seconds.size() / 2];
    report.points[i].spread = 0.5 * (seconds.back() - seconds.front());
  }
}

bool beats(const AccuracyPoint& a, const AccuracyPoint& b) {
  return a.seconds <= b.seconds && a.outcome.error <= b.outcome.error &&
         (a.seconds < b.seconds || a.outcome.error < b.outcome.error);
}

void mark_best(std::vector<AccuracyPoint>& points) {
  for (AccuracyPoint& point : points)
    point.best = std::ranges::none_of(
        points, [&](const AccuracyPoint& other) { return beats(other, point); });
}

}  // namespace

Share share_of(double wrong, double all) {
  constexpr double z = 1.96;
  if (all == 0) return {0, 1};
  const double share = wrong / all, middle = (wrong + 0.5 * z * z) / (all + z * z);
  const double half = z / (all + z * z) * std::sqrt(share * (all - wrong) + 0.25 * z * z);
  return {share, std::fabs(middle - share) + half};
}

const char* name(ErrorKind kind) {
  constexpr const char* kNames[] = {"sampling", "truncation", "discretisation", "rounding"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<std::string> series_of(const std::vector<AccuracyPoint>& points) {
  std::vector<std::string> series;
  for (const AccuracyPoint& point : points)
    if (std::ranges::find(series, point.series) == series.end()) series.push_back(point.series);
  return series;
}

std::string words(const FittedOrder& order, const std::string& grows) {
  const std::string of = order.series.empty() ? "" : order.series + ": ";
  return of + (order.law == Law::power ? fmt::format("error ~ ({})^{:.2f}", grows, order.slope)
                                       : fmt::format("error ~ e^({:.3f} {})", order.slope, grows));
}

std::optional<FittedOrder> fit_order(const std::vector<AccuracyPoint>& points,
                                     const std::string& series, Law law, double saturated) {
  std::vector<std::pair<double, double>> logs;
  for (const AccuracyPoint& point : points)
    if (const double error = point.outcome.error; point.series == series && point.n > 0 &&
                                                  error > 0 && error < saturated &&
                                                  !point.outcome.at_most)
      logs.emplace_back(law == Law::power ? portable::log(point.n) : point.n, portable::log(error));
  if (logs.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(logs.size());
  double x = 0, y = 0;
  for (const auto& [n, error] : logs) x += n / count, y += error / count;
  double xx = 0, xy = 0, spread = 0, rest = 0;
  for (const auto& [n, error] : logs) {
    xx += (n - x) * (n - x), xy += (n - x) * (error - y);
    spread = std::max(spread, std::fabs(error - logs.front().second));
  }
  if (xx == 0 || spread == 0) return std::nullopt;
  const double slope = xy / xx;
  for (const auto& [n, error] : logs) {
    const double off = error - y - slope * (n - x);
    rest += off * off;
  }
  return FittedOrder{slope, series, law, rest};
}

namespace {

// Of each series by the first law, unless another leaves less than half of what that does.
std::vector<FittedOrder> fit_orders(const ChoiceSettings& made,
                                    const std::vector<AccuracyPoint>& points) {
  std::vector<FittedOrder> orders;
  for (const std::string& series : series_of(points)) {
    std::optional<FittedOrder> nearest;
    for (const Law law : made.laws)
      if (auto order = fit_order(points, series, law, made.saturated);
          order && (!nearest || 2 * order->rest < nearest->rest))
        nearest = std::move(order);
    if (nearest) orders.push_back(*std::move(nearest));
  }
  return orders;
}

}  // namespace

unsigned middle_frame(const Scene& scene) { return (scene.frames + 1) / 2; }

Result<DrawList> middle_list(const AccuracyContext& context, std::uint64_t most_rays) {
  Scene scene = context.scene;
  scene.light.rays = std::min(scene.light.rays, most_rays);
  const unsigned frame = middle_frame(scene);
  FLATRAY_TRY(timeline, make_timeline(scene, context.seed, frame));
  return draw_list(make_plan(scene, false), *timeline, frame);
}

std::optional<Image> picture_of(const AccuracyContext& context) {
  constexpr std::uint64_t kMostRays = 1 << 14;  // for people to know the scene again
  const auto list = middle_list(context, kMostRays);
  if (!list) return std::nullopt;
  return render_image(*list, {std::nullopt, context.threads});
}

void shrink(Film& film, int side) {
  const double by = std::min(1.0, static_cast<double>(side) / std::max(film.width, film.height));
  film.width = std::max(1, static_cast<int>(by * film.width));
  film.height = std::max(1, static_cast<int>(by * film.height));
}

ChoiceReport measure_choice(const Choice& choice, const AccuracyContext& context) {
  ChoiceReport report;
  report.name = choice.name;
  report.question = choice.question;
  report.kind = choice.kind;
  report.left_out = choice.left_out(context.scene);
  if (report.left_out.empty() && context.seconds <= 0 && !context.at_least_one)
    report.left_out = "no time of the budget is left";
  if (!report.left_out.empty()) return report;
  const Budget budget(context.seconds);
  const Result<ChoiceSettings> made = choice.settings(context);
  if (!made) {
    report.left_out = made.error().front().message;
    return report;
  }
  report.reference_seconds = budget.used();
  static_cast<ChoiceFacts&>(report) = *made;
  Rounds rounds = first_round(*made, budget, context.at_least_one, report);
  if (report.points.empty() && report.missing.empty())
    report.left_out = "its reference took all of its part of the budget";
  more_rounds(rounds, budget, report);
  if (report.one_question) mark_best(report.points);
  report.orders = fit_orders(*made, report.points);
  report.seconds = budget.used();
  return report;
}

std::vector<ChoiceReport> measure_choices(std::span<const Choice* const> choices,
                                          const AccuracyContext& context) {
  const double start = processor_seconds();
  std::vector<ChoiceReport> reports(choices.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    AccuracyContext part = context;
    const double left = context.seconds - (processor_seconds() - start);
    part.seconds = std::max(left, 0.0) / static_cast<double>(i + 1);
    part.at_least_one = std::ranges::all_of(
        reports, [](const ChoiceReport& report) { return report.points.empty(); });
    reports[i] = measure_choice(*choices[i], part);
  }
  return reports;
}

const AccuracyPoint* best_within(const ChoiceReport& report, double seconds) {
  const AccuracyPoint* best = nullptr;
  for (const AccuracyPoint& point : report.points)
    if (point.best && point.seconds < seconds &&
        (best == nullptr || point.outcome.error < best->outcome.error))
      best = &point;
  if (best == nullptr) return nullptr;
  const bool known = best->outcome.half <= std::max(best->outcome.error, kSmallError);
  return known ? best : nullptr;
}

const AccuracyPoint* cheapest_below(const ChoiceReport& report, double error) {
  const AccuracyPoint* best = nullptr;
  for (const AccuracyPoint& point : report.points)
    if (point.best && point.outcome.error + point.outcome.half < error &&
        (best == nullptr || point.seconds < best->seconds))
      best = &point;
  return best;
}

std::string advice(const ChoiceReport& report, const AccuracyPoint& point) {
  std::string words;
  if (&point == best_within(report, kShortSeconds))
    words = fmt::format("best under {} s", kShortSeconds);
  if (&point == cheapest_below(report, kSmallError))
    words += fmt::format("{}cheapest under {}", words.empty() ? "" : " and ", kSmallError);
  return words;
}

ErrorParts error_parts(const ChoiceReport& report, const AccuracyPoint& point) {
  ErrorParts parts = point.outcome.parts;
  if (std::ranges::none_of(parts, [](const auto& part) { return part.has_value(); }))
    parts[static_cast<std::size_t>(report.kind)] = point.outcome.error;
  return parts;
}

}  // namespace flatray
