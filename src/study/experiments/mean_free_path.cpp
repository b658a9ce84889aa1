#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/rooms/flight_tail.h"
#include "study/rooms/followed.h"
#include "study/rooms/free_circles.h"
#include "study/rooms/starts.h"
#include "study/statistics/blocks.h"
#include "study/statistics/streaming_histogram.h"

namespace flatray::mean_free_path_experiment {
namespace {

constexpr std::uint64_t kBounces =
    100;  // of one orbit: many orbits, so that their mean has an error
constexpr double kMostIntoCorners = 0.02;  // of the orbits
constexpr double kPi = 0x1.921fb54442d18p+1;
// How flights are spread: over so many mean ones, the longer ones together.
constexpr double kMostOfMean = 16;
constexpr std::size_t kBins = 256;

// What blocks of orbits add up.
struct FlightSums {
  StartSums flights;
  StreamingHistogram spread;
  double escaped = 0, corners = 0;
  FlightTail tail{};

  SumList list() { return sums_of(escaped, corners, tail, flights, spread); }
};

// By orbit: the way flown and the flights it is made of.
class Flights : public OrbitSink {
 public:
  Flights(std::uint64_t begin, std::uint64_t end, FlightSums& sums)
      : sums_(sums), begin_(begin), lengths_(end - begin) {}
  void bounce(std::size_t number, const Bounce& bounce) override {
    const double flight = bounce.path_length - lengths_[number];
    sums_.spread.add(flight);
    longest_[number] = std::max(longest_[number], flight);
    lengths_[number] = bounce.path_length;
    ++flights_[number];
  }
  void end(std::size_t, const OrbitStop& stop) override {
    if (stop.end == OrbitEnd::escape) ++sums_.escaped;
    if (stop.end == OrbitEnd::corner) ++sums_.corners;
  }
  // Once all are followed.
  void add_orbits(std::uint64_t bounces) {
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      if (flights_[i] > 0) sums_.flights.add(begin_ + i, lengths_[i], flights_[i]);
    sums_.tail.add(longest_, bounces);
  }

 private:
  FlightSums& sums_;
  std::uint64_t begin_;  // the number of the first
  std::vector<double> lengths_, flights_ = lengths_, longest_ = lengths_;
};

// In a field what circles freely meets no wall, and the mean is over all the rest of phase space,
// in which the way to the next wall has the area of the walls' own for its flow (Santalo's
// argument): a flight is a centre and a phase as well as a place and a direction.
Result<double> area_of_flights(const Room& room) {
  const Place& where = room.scene().chambers.front().where;
  const double enclosed = room.area(), field = room.scene().field();
  if (!(enclosed > 0 && std::isfinite(enclosed)))
    return fail(where, fmt::format("the chamber encloses an area of {:.6g}", enclosed),
                "give it an outline that is closed, larger than its pillars");
  if (field == 0) return enclosed;
  const double area = enclosed - area_of_free_centres(room, 1 / std::fabs(field));
  if (area < most_off_of_free_centres(room))
    return fail(where, "nearly all circles in so strong a field meet no wall",
                "weaken it: the closed form is known to 1e-4 of the box around the walls");
  return area;
}

// The area of free circles is a sum over rows: in a strong field, and of many flights, nothing is
// judged by it.
void withhold_what_is_too_coarse(Measure& path, double most_off) {
  if (most_off < *path.standard_error) return;
  path.remark = fmt::format("pi A / P is {:.6g} within {:.2g}, too coarse to judge by",
                            *path.expected, most_off);
  path.expected.reset();
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  if (auto closed = expect_closed(context); !closed) return fail(std::move(closed));
  const Room room(context.scene);
  FLATRAY_TRY(area, area_of_flights(room));
  FLATRAY_TRY(plan, plan_orbits(context, kBounces));
  const double expected = kPi * *area / room.perimeter();
  FlightSums all{StartSums(context.starts), StreamingHistogram(0, kMostOfMean * expected, kBins)};
  FLATRAY_TRY(ran, sum_blocks(context, Blocks::of(plan->orbits), all,
                              [&](std::uint64_t begin, std::uint64_t end, FlightSums& some) {
                                Flights flights(begin, end, some);
                                follow_drawn(context, room, begin, end, plan->bounces, flights);
                                flights.add_orbits(plan->bounces);
                              }));
  const RatioSums sums = all.flights.all();
  Measure path = sums.measure("mean_free_path", expected);
  withhold_error_of_flights(path, room, all.tail);
  if (room.scene().field() != 0 && path.standard_error)
    withhold_what_is_too_coarse(path, kPi * most_off_of_free_centres(room) / room.perimeter());
  if (all.corners > kMostIntoCorners * static_cast<double>(plan->orbits))
    withhold_error(path, fmt::format("no error: {:.0f} of {} orbits ended in corners, as where "
                                     "curved walls lie on one another: look at some of them",
                                     all.corners, plan->orbits));
  std::vector<Measure> measures{std::move(path),
                                expected_within("orbits_escaped", all.escaped, 0, 0),
                                {"orbits_into_corners", all.corners}};
  ExperimentResult result = measured(
      context, "mean_free_path",
      fmt::format("Mean free path of {:.0f} flights in {} orbits, beside pi A / P (Santalo), A = "
                  "{:.6g}{}, P = {:.6g}",
                  sums.y, plan->orbits, *area,
                  room.orbits().has_glass()   ? " with areas and walls of glass times its index"
                  : room.scene().field() == 0 ? ""
                                              : " less the centres of free circles",
                  room.perimeter()),
      std::move(measures), audit(context, room, *plan));
  all.spread.add_files(result, "mean_free_path_flights", "lengths of flights, world units");
  return result;
}

}  // namespace

extern const Experiment entry = {"mean-free-path",
                                 "How far does a ray fly between two walls, and is that pi A / P?",
                                 &run, kUsesOfOrbitMeans};

}  // namespace flatray::mean_free_path_experiment
