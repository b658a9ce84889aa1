#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/counted.h"
#include "base/portable_math.h"
#include "study/rooms/flight_tail.h"
#include "study/rooms/followed.h"
#include "study/rooms/starts.h"
#include "study/rooms/tangent.h"
#include "study/rooms/wall_places.h"
#include "study/statistics/blocks.h"

namespace flatray::lyapunov_experiment {
namespace {

constexpr std::uint64_t kBounces = 1000;  // of one orbit
constexpr std::uint64_t kSettling = 20;   // bounces that turn any first difference to the fastest

// What is summed over orbits: growth over length, over hits, over hits of curved walls; that
// between a half and all bounces over that between a quarter and a half; the former alone; and how
// many orbits there grow no more than like a power.
constexpr std::size_t kSums = 6;
enum Sum : std::size_t { of_length, of_hits, of_curved, of_doubling, of_power, of_regular };

// Of an orbit, logarithm: differences have turned to the direction that grows, and growth is that
// of long times.
constexpr double kLeastGrowth = 10;

// What grows like t^3 from a half on; regular orbits grow like t. What parts exponentially is told
// from it where it grows so many times as much.
constexpr double kMostRegular = 3 * 0.6931471805599453, kTold = 5;

// What blocks of orbits add up.
struct GrowthSums {
  std::vector<StartSums> sums;
  FlightTail tail{};

  RatioSums of(Sum which) const { return sums[which].all(); }
  SumList list() { return sums_of(tail, sums); }
};

class Growth : public OrbitSink {
 public:
  Growth(const Room& room, std::uint64_t begin, std::uint64_t end, std::uint64_t bounces)
      : room_(room), begin_(begin), quarter_(bounces / 4), states_(end - begin) {}

  void bounce(std::size_t number, const Bounce& bounce) override {
    State& state = states_[number];
    const double bend = curvature(room_.walls(), bounce.surface, bounce.point, bounce.normal);
    if (field_ == 0) {
      state.tangent.fly(bounce.t / extent_);
      if (!bounce.is_refracted())
        state.tangent.reflect(bend == 0 ? 0 : 2 * bend * extent_ / cosine(bounce));
      else if (const auto met = refraction(room_.index_ratio(bounce), cosine(bounce)))
        state.tangent.refract(*met, bend * extent_);
    } else {
      state.tangent.fly(bounce.t / extent_, field_ * extent_);
      state.tangent.reflect(bend_in_field(bounce, bend, field_) * extent_);
    }
    const double grown = state.tangent.restore();
    state.longest = std::max(state.longest, bounce.t);
    ++state.bounces;
    if (state.bounces > quarter_ && state.bounces <= 2 * quarter_) state.second_quarter += grown;
    if (state.bounces > 2 * quarter_ && state.bounces <= 4 * quarter_) state.half += grown;
    if (state.bounces <= kSettling) return;
    state.grown += grown;
    state.length += bounce.t;
    state.curved += bend != 0 ? 1 : 0;
  }

  // Once all are followed.
  void add_to(GrowthSums& all) const {
    auto& [sums, tail] = all;
    std::vector<double> longest;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State& state = states_[i];
      longest.push_back(state.longest);
      if (state.bounces <= kSettling) continue;
      sums[of_length].add(begin_ + i, state.grown, state.length);
      sums[of_hits].add(begin_ + i, state.grown, static_cast<double>(state.bounces - kSettling));
      sums[of_curved].add(begin_ + i, state.grown, state.curved);
      if (state.bounces < 4 * quarter_) continue;
      sums[of_doubling].add(begin_ + i, state.half, state.second_quarter);
      sums[of_power].add(begin_ + i, state.half, 1);
      sums[of_regular].add(begin_ + i, state.half < kMostRegular ? 1 : 0, 1);
    }
    tail.add(longest, 4 * quarter_);
  }

 private:
  // Of the angle between a ray and the normal.
  static double cosine(const Bounce& bounce) {
    return std::fabs(bounce.in.dot(bounce.normal)) / std::sqrt(bounce.in.squaredNorm());
  }
  struct State {
    Tangent tangent;
    std::uint64_t bounces = 0;
    double grown = 0, length = 0, curved = 0, longest = 0;
    double second_quarter = 0, half = 0;  // growth in that quarter, in the second half
  };
  const Room& room_;
  double field_ = room_.scene().field(), extent_ = bounds_of(room_.walls()).size().maxCoeff();
  std::uint64_t begin_;    // the number of the first
  std::uint64_t quarter_;  // of the bounces
  std::vector<State> states_;
};

// How neighbours part.
enum class Law { straight, exponential, power, undecided };

// What grows like e^(rate t) grows twice as much from a half on as between a quarter and a half,
// what grows like a power as much: where the quotient lies, by more than chance, is the law. Nearer
// to 2 and not 2 is neither yet. Where orbits of both kinds are mixed those that part exponentially
// win.
Law law_of(const Room& room, const RatioSums& doubling) {
  if (room.walls().curve_numbers.empty() && room.scene().field() == 0) return Law::straight;
  if (doubling.samples < 3) return Law::undecided;
  const double quotient = doubling.ratio();
  const double chance = kAllowedErrors / student_95(kInfinity) * student_95(doubling.samples - 1) *
                        doubling.standard_error();
  if (quotient + chance < 1.5) return Law::power;
  return quotient - chance > 1.5 && std::fabs(quotient - 2) <= chance ? Law::exponential
                                                                      : Law::undecided;
}

std::string words(Law law, double power) {
  if (law == Law::exponential) return "neighbours part exponentially";
  const std::string finite = "what is told is of finite time, without an error";
  if (law == Law::straight)
    return "exactly 0, as all walls are straight" +
           (std::isfinite(power) ? fmt::format("; neighbours part like t^{:.1f}", power) : "");
  if (law == Law::power)
    return fmt::format("no exponential growth found: grows like t^{:.1f}; {}", power, finite);
  return "undecided whether neighbours part exponentially; " + finite;
}

// The exponents of the other directions of phase space, largest first.
void add_spectrum(std::vector<Measure>& measures, double largest) {
  const std::pair<double, const char*> others[] = {
      {0, "by theory: along the flight"},
      {0, "by theory: of the speed, which is kept"},
      {-largest, "by theory: minus the first, as volumes of phase space are kept"}};
  for (std::size_t i = 0; i < std::size(others); ++i)
    measures.push_back(
        remarked(fmt::format("spectrum_{}", i + 2), others[i].first, others[i].second));
}

std::vector<Measure> exponents(const Room& room, const GrowthSums& grown, Law law, double power) {
  const std::array names = {"per_length", "per_hit", "per_curved_hit"};
  std::vector<Measure> measures;
  if (law == Law::straight)
    for (const char* name : {"per_length", "per_hit"})
      measures.push_back(remarked(name, 0, "all walls are straight"));
  const RatioSums hits = grown.of(of_hits);
  for (const Sum which : {of_length, of_hits, of_curved}) {
    const RatioSums sums = grown.of(which);
    if (!(sums.y > 0)) continue;
    Measure one = sums.measure(names[which]);
    if (law != Law::exponential) {
      one.name.insert(0, "finite_time_");
      one.remark = law == Law::undecided ? "no error: may have no limit but 0"
                                         : "no error: falls to 0 with time";
    } else if (which == of_length) {
      withhold_error_of_flights(one, room, grown.tail);
    }
    if (law == Law::exponential && hits.x < kLeastGrowth * hits.samples)
      one.remark =
          "no error: neighbours part less than e^10 times along an orbit; say more --bounces";
    if (!one.remark.empty()) one.standard_error.reset();
    measures.push_back(std::move(one));
  }
  if (law != Law::exponential) {
    measures.push_back(remarked("power_of_growth", power, "of time, in the later half"));
    return measures;
  }
  const RatioSums by_length = grown.of(of_length), regular = grown.of(of_regular);
  if (by_length.y > 0) add_spectrum(measures, by_length.ratio());
  if (!(regular.x > 0 && grown.of(of_power).ratio() > kTold * kMostRegular)) return measures;
  for (Measure& one : measures)
    one.remark += (one.remark.empty() ? "" : "; ") + std::string("mean over both kinds of orbits");
  measures.push_back(regular.share("part_like_a_power", "share of the orbits"));
  return measures;
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  FLATRAY_TRY(plan, plan_orbits(context, kBounces + kSettling));
  if (plan->bounces < 2 * kSettling)
    return refused_option(
        "--bounces", "too few for an exponent: " + counted(plan->bounces, "bounce") + " an orbit",
        fmt::format("say --bounces {} or more, of which the first {} do not count, and "
                    "--count of several times as many",
                    2 * kSettling, kSettling));
  GrowthSums all{std::vector<StartSums>(kSums, StartSums(context.starts))};
  FLATRAY_TRY(ran, sum_blocks(context, Blocks::of(plan->orbits), all,
                              [&](std::uint64_t begin, std::uint64_t end, GrowthSums& some) {
                                Growth growth(room, begin, end, plan->bounces);
                                follow_drawn(context, room, begin, end, plan->bounces, growth);
                                growth.add_to(some);
                              }));
  const Law law = law_of(room, all.of(of_doubling));
  const double power = all.of(of_power).ratio() / portable::log(2);
  return measured(context, "lyapunov",
                  fmt::format("Lyapunov exponent, {:.0f} bounces of {} orbits: {}",
                              all.of(of_hits).y, plan->orbits, words(law, power)),
                  exponents(room, all, law, power), audit(context, room, *plan));
}

}  // namespace

extern const Experiment entry = {"lyapunov",
                                 "How fast do two orbits part that start next to each other?", &run,
                                 kUsesOfOrbitMeans};

}  // namespace flatray::lyapunov_experiment
