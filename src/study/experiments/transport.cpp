#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "study/plots/plot.h"
#include "study/rooms/flight_tail.h"
#include "study/rooms/lags.h"
#include "study/statistics/blocks.h"
#include "study/statistics/estimate.h"
#include "study/statistics/line_fit.h"
#include "study/statistics/streaming_histogram.h"

namespace flatray::transport_experiment {
namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;
constexpr std::uint64_t kBounces = 256;  // of one orbit
// So that few orbits are much shorter than the mean, and the Green-Kubo integral is cut after ten
// flights: after five, as 64 bounces have it, a gap of 0.3 still lacks 6 % of its coefficient.
constexpr std::uint64_t kFewestBounces = 128;

// What is asked of the lags of an orbit, each a mean over orbits.
enum Asked : std::size_t {
  einstein,
  einstein_x,
  einstein_y,
  green_kubo,
  unsettled,
  logarithm,
  kAsked
};

// The slope of D(t), the Green-Kubo integral up to t, over log t from 1/8 of the lags on.
double slope_over_log(const Numbers& kubo, const LagTimes& times) {
  LineFit fit;
  for (std::size_t i = (times.lags - 1) / 8; i < times.lags; ++i)
    fit.add(portable::log(times.lag(i)), 0.5 * kubo[i], 1 / times.lag(i));
  return fit.slope();
}

std::array<double, kAsked> asked_of(const Lags& lags, const LagTimes& times) {
  const std::size_t last = times.lags - 1, half = last / 2;
  const double time = times.lag(last) - times.lag(half);
  const double x = (lags.x[last] - lags.x[half]) / (2 * time);
  const double y = (lags.y[last] - lags.y[half]) / (2 * time);
  return {0.5 * (x + y),
          x,
          y,
          0.5 * lags.kubo[half],
          0.5 * (lags.kubo[last] - lags.kubo[half]),
          slope_over_log(lags.kubo, times)};
}

// The lags of many orbits: sums, and of squares, so that each has an error.
constexpr double kMostLeftOut = 0.02;  // of the orbits

class LagSums {
 public:
  explicit LagSums(std::size_t lags) : lags_(lags), sums_(1 + 6 * lags, 0.0) {}
  void add(const Lags& orbit) {
    ++sums_[0];
    for (std::size_t i = 0; i < lags_; ++i) {
      const double values[] = {orbit.x[i] + orbit.y[i], orbit.velocity[i], 0.5 * orbit.kubo[i]};
      for (std::size_t k = 0; k < 3; ++k) {
        sums_[1 + 6 * i + 2 * k] += values[k];
        sums_[2 + 6 * i + 2 * k] += values[k] * values[k];
      }
    }
  }
  void append_to(SumList& list) { append(list, sums_); }
  /// The mean square displacement, the correlation of velocities, the Green-Kubo integral.
  Plot::Point point(std::size_t which, std::size_t lag, double time) const {
    const double n = sums_[0], mean = sums_[1 + 6 * lag + 2 * which] / n;
    const double square = sums_[2 + 6 * lag + 2 * which] / n - mean * mean;
    return {time, mean, student_95(n - 1) * std::sqrt(std::max(square, 0.0) / (n - 1))};
  }

 private:
  std::size_t lags_;
  Numbers sums_;
};

// What blocks of orbits add up.
struct Transport {
  LagTimes times;
  double mean_flight, left_out = 0;
  FlightTail tail{};
  std::array<RatioSums, kAsked> asked{};
  LagSums lags{times.lags};
  StreamingHistogram flights{0, 16 * mean_flight, 256}, sines{0, 1, 64};

  SumList list() { return sums_of(left_out, tail, asked, lags, flights, sines); }
};

// Orbits as they are made: where they are at the times, in the plane.
class Walks : public OrbitSink {
 public:
  Walks(const Room& room, std::span<const OrbitStart> starts, Transport& all)
      : periodic_(room.orbits().periodic()), times_(all.times), all_(all) {
    for (const OrbitStart& start : starts) walks_.push_back({start.ray.origin, {}, {}});
  }
  void bounce(std::size_t number, const Bounce& bounce) override {
    Walk& walk = walks_[number];
    const Vec2 here = periodic_.shifted(bounce.point, bounce.cell);
    const double end = times_.lag(times_.samples - 1);
    for (; walk.places.size() < times_.samples; walk.ways.push_back(bounce.in)) {
      const double time = times_.lag(walk.places.size());
      if (time > bounce.path_length) break;
      walk.places.push_back(walk.last + (time - walk.length) * bounce.in);
    }
    // Bounces up to a time that does not depend on them, and the flights that set off from these.
    if (bounce.path_length <= end) all_.sines.add(portable::sin(bounce.incidence()));
    if (walk.length > 0 && walk.length <= end) all_.flights.add(bounce.path_length - walk.length);
    if (walk.length > 0) walk.longest = std::max(walk.longest, bounce.path_length - walk.length);
    walk.last = here;
    walk.length = bounce.path_length;
  }

  // Once all are followed.
  void add_orbits(std::uint64_t bounces) {
    std::vector<double> longest;
    for (const Walk& walk : walks_) {
      longest.push_back(walk.longest);
      if (walk.places.size() < times_.samples) {
        ++all_.left_out;
        continue;
      }
      const Lags lags = Lags::of(walk.places, walk.ways, times_.lags);
      all_.lags.add(lags);
      const auto found = asked_of(lags, times_);
      for (std::size_t i = 0; i < kAsked; ++i) all_.asked[i].add(found[i], 1);
    }
    all_.tail.add(longest, bounces);
  }

 private:
  struct Walk {
    Vec2 last;
    std::vector<Vec2> places, ways;
    double length = 0, longest = 0;
  };
  const PeriodicWalls& periodic_;
  const LagTimes& times_;
  Transport& all_;
  std::vector<Walk> walks_;
};

// Whether the Green-Kubo integral still changes from one half of the lags to all, by more than
// chance.
bool is_settled(const Transport& all) {
  const RatioSums& change = all.asked[unsettled];
  return std::fabs(change.ratio()) <= kAllowedErrors * change.standard_error();
}

// How the mean square displacement grows.
enum class Growth {
  linear,       // 4 D t
  undecided,    // that, or faster: of so few flights it cannot be told whether they have a variance
  logarithmic,  // t log t: flights of any length between curved walls
  unknown  // flights of any length between straight walls, which part neighbours no faster than a
           // power
};

// Of the mean square displacement from a half of the lags on, as if it grew like t^power.
Measure power_of_displacement(const Transport& all) {
  const std::size_t last = all.times.lags - 1, half = last / 2;
  const auto log_at = [&](std::size_t lag) { return portable::log(all.lags.point(0, lag, 0).y); };
  const double from = all.times.lag(half), to = all.times.lag(last);
  return remarked("power_of_displacement",
                  (log_at(last) - log_at(half)) / (portable::log(to) - portable::log(from)),
                  fmt::format("no error: walls are straight, and no law is known to fit; from t = "
                              "{:.4g} to {:.4g}",
                              from, to));
}

std::vector<Measure> measures_of(const Transport& all, Growth growth,
                                 const std::string& unbounded) {
  const std::size_t last = all.times.lags - 1;
  const double half = all.times.lag(last / 2), end = all.times.lag(last);
  std::vector<Measure> measures;
  if (growth == Growth::linear || growth == Growth::undecided) {
    const std::string why = growth == Growth::undecided ? unbounded
                            : is_settled(all)
                                ? ""
                                : "no error: velocities are still correlated; say more --bounces";
    const std::pair<Asked, const char*> names[] = {{einstein, "diffusion_einstein"},
                                                   {einstein_x, "diffusion_einstein_x"},
                                                   {einstein_y, "diffusion_einstein_y"},
                                                   {green_kubo, "diffusion_green_kubo"}};
    for (const auto& [which, name] : names) {
      Measure& one = measures.emplace_back(all.asked[which].measure(name));
      one.remark = !why.empty() ? why
                   : which == green_kubo
                       ? fmt::format("cut at t = {:.4g}", half)
                       : fmt::format("slope from t = {:.4g} to {:.4g}", half, end);
      if (!why.empty()) one.standard_error.reset();
    }
  } else if (growth == Growth::unknown) {
    measures.push_back(power_of_displacement(all));
  } else {
    Measure& slope = measures.emplace_back(all.asked[logarithm].measure("diffusion_per_log_time"));
    withhold_error(
        slope,
        fmt::format(
            "no error: D(t) grows like log t, of which this is the slope from t = {:.4g} to {:.4g}",
            all.times.lag(last / 8), end));
  }
  measures.push_back(
      remarked("sines_off_even", all.sines.chi_squared_of_even() / 63,
               "chi-squared a degree of freedom; bounces of an orbit are not independent"));
  measures.push_back(remarked("orbits_left_out", all.left_out,
                              "too short, as they met a corner or had short flights"));
  return measures;
}

std::string words(Growth growth, const std::string& unbounded) {
  if (growth == Growth::linear) return "the mean square displacement grows like 4 D t";
  if (growth == Growth::undecided)
    return "undecided whether the mean square displacement grows like 4 D t; say more --count";
  const std::string none = "there is no D (" + unbounded + ")";
  return growth == Growth::logarithmic ? "it grows like t log t, " + none : none;
}

// What LagSums::point() has.
struct Curve {
  const char *file, *title, *label;
};
constexpr Curve kCurves[] = {
    {"transport_displacement", "Mean square displacement",
     "<(r(t) - r(0))^2>, world units squared"},
    {"transport_velocity", "Velocity autocorrelation", "<v(0) v(t)>, at speed 1"},
    {"transport_green_kubo", "Green-Kubo integral of the velocity autocorrelation",
     "D(t), world units at speed 1"}};

void add_files(ExperimentResult& result, const Transport& all, const ExperimentContext& context) {
  Table table({"time", "mean_square_displacement", "its_half_interval", "velocity_correlation",
               "velocity_half_interval", "green_kubo", "green_kubo_half_interval"});
  for (std::size_t i = 0; i < all.times.lags; ++i) {
    Values row{all.times.lag(i)};
    for (std::size_t which = 0; which < 3; ++which) {
      const Plot::Point point = all.lags.point(which, i, all.times.lag(i));
      row.insert(row.end(), {point.y, point.half});
    }
    table.add(std::move(row));
  }
  result.files.push_back(csv_file("transport_lags", table));
  all.flights.add_files(result, "transport_flights", "lengths of flights, world units");
  all.sines.add_files(result, "transport_sines", "sines of the incidence");
  for (std::size_t which = 0; which < std::size(kCurves); ++which) {
    const auto& [file, title, label] = kCurves[which];
    Plot plot{title, "time, world units at speed 1", label, {{"mean over orbits and times"}}};
    for (std::size_t i = 0; i < all.times.lags; ++i)
      plot.series[0].points.push_back(all.lags.point(which, i, all.times.lag(i)));
    add_plot(result, file, plot, context.threads);
  }
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  const Place where = context.scene.chambers.front().where;
  if (!room.orbits().periodic().any())
    return fail(where, "nothing diffuses in a room with walls all round",
                "give the chamber material = \"periodic\"");
  const double area = room.solids().free_area();
  if (!(area > 0 && std::isfinite(area)))
    return fail(where, fmt::format("the chamber encloses an area of {:.6g}", area),
                "give it an outline larger than its pillars");
  FLATRAY_TRY(plan, plan_orbits(context, kBounces));
  if (plan->bounces < kFewestBounces)
    return refused_option(
        "--bounces", "too few to see how an orbit goes on",
        fmt::format("say --bounces {} or more, and --count of many times as many", kFewestBounces));
  const double mean_flight = kPi * area / room.perimeter();
  Transport all{LagTimes::of(mean_flight, plan->bounces), mean_flight};
  FLATRAY_TRY(ran, sum_blocks(context, Blocks::of(plan->orbits), all,
                              [&](std::uint64_t begin, std::uint64_t end, Transport& some) {
                                std::vector<OrbitStart> starts;
                                for (std::uint64_t i = begin; i < end; ++i)
                                  starts.push_back(room.draw_free_start(context.seed, i));
                                Walks walks(room, starts, some);
                                room.orbits().follow(starts, plan->bounces, walks);
                                walks.add_orbits(plan->bounces);
                              }));
  if (all.left_out > kMostLeftOut * static_cast<double>(plan->orbits))
    return fail(where,
                fmt::format("{:.0f} of {} orbits are too short, as they met a corner or had short "
                            "flights: the others tell nothing of all",
                            all.left_out, plan->orbits),
                "look at some of them with flatray orbit");
  const std::string unbounded = no_error_of_flights(room, all.tail);
  const Growth growth = unbounded.empty()                    ? Growth::linear
                        : all.tail.index() == 0              ? Growth::undecided
                        : room.walls().curve_numbers.empty() ? Growth::unknown
                                                             : Growth::logarithmic;
  ExperimentResult result = measured(
      context, "transport",
      fmt::format("Diffusion of {} orbits over t = {:.4g} at speed 1, mean flight {:.6g}: {}",
                  plan->orbits, all.times.lag(all.times.samples - 1), mean_flight,
                  words(growth, unbounded)),
      measures_of(all, growth, unbounded));
  add_files(result, all, context);
  return result;
}

}  // namespace

extern const Experiment entry = {
    "transport",
    "How fast does a ray spread between periodic walls, and how are its flights spread?",
    &run,
    {.count = true, .bounces = true, .seed = true, .resume = true}};

}  // namespace flatray::transport_experiment
