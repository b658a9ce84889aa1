#include "transport/fast_orbits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trace/curve_records.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

using flights::Record;

constexpr std::size_t kWave = 256;      // so many rays stay in the first cache
constexpr std::size_t kMostWalls = 96;  // of more the exact tracer's cells are as fast
constexpr double kUndecided = 0x1p-30;  // of the largest coordinate
// A room reaches beyond a line by no more than rounding; lines met at cosines of 2^-16 and more are then near.
constexpr double kStepRounding = 0x1p-48;
// Beyond it rounding may hide whether a curve is met: the room by the curve's width, that by its length.
constexpr double kMostSlender = 0x1p18;
constexpr double kLeastRoom = 0x1p-300, kLargestRoom = 0x1p300;  // squares stay among the doubles

flights::Fly kernel_of(Isa isa) {
  static constexpr const flights::Fly* kTiers[] = {
    &flights::portable::kFly,
#if defined(__x86_64__)
    &flights::baseline::kFly,
    &flights::avx2::kFly,
    &flights::avx512::kFly
#endif
  };
  return *of_tier(kTiers, isa);
}

double event_of(Material material) {
  return material == Material::mirror     ? flights::kBounced
         : material == Material::periodic ? flights::kCrossed
                                          : flights::kAbsorbed;
}

// What has the sign of a ray's side at an end of an arc, `size` the length of its vector.
void put_side(double* at, const Vec2& toward) {
  const double size = std::sqrt(toward.squaredNorm());
  at[0] = toward.x() / size;
  at[1] = toward.y() / size;
}

void put_extent(double* record, const Arc& arc) {
  record[Record::kExtent] = flights::kWhole;
  if (arc.extent == Arc::Extent::whole) return;
  record[Record::kExtent] = flights::kBoth;
  if (arc.extent == Arc::Extent::half) {
    put_side(record + Record::kFromX, arc.from);
    put_side(record + Record::kToX, arc.from);
    return;
  }
  const Vec2 from = arc.from - arc.curve.centre, to = arc.to - arc.curve.centre;
  put_side(record + Record::kFromX, Vec2(-from.y(), from.x()));
  put_side(record + Record::kToX, Vec2(to.y(), -to.x()));
  if (from.x() * to.y() - from.y() * to.x() < 0) record[Record::kExtent] = flights::kEither;
}

// The numbers by which w = a u + b v gives a and b.
void put_form(double* record, const Ellipse& curve) {
  const Vec2 &u = curve.u, &v = curve.v;
  const double area = u.x() * v.y() - u.y() * v.x();
  record[Record::kFormXx] = v.y() / area;
  record[Record::kFormXy] = -v.x() / area;
  record[Record::kFormYx] = -u.y() / area;
  record[Record::kFormYy] = u.x() / area;
}

// Arrays of lanes.
using Lanes = std::array<double, kWave>;
struct RayLanes {
  Lanes x{}, y{}, dx{}, dy{}, departed{};

  flights::Rays rays() { return {x.data(), y.data(), dx.data(), dy.data(), departed.data()}; }
  Vec2 point(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 direction(std::size_t i) const { return {dx[i], dy[i]}; }
  void set(std::size_t i, const Vec2& at, const Vec2& towards, double slot) {
    x[i] = at.x(), y[i] = at.y();
    dx[i] = towards.x(), dy[i] = towards.y();
    departed[i] = slot;
  }
  void move(std::size_t from, std::size_t to) {
    set(to, point(from), direction(from), departed[from]);
  }
};

// What a lane's orbit has done.
struct Progress {
  std::size_t number = 0;
  std::uint64_t bounces = 0;
  double length = 0;            // of the path to the last bounce
  double before = 0;            // of the flight since then, to the last crossing
  std::uint32_t crossings = 0;  // since then
  CellIndex cell{};
  bool exact = false;  // the next flight, whatever the lanes say
};

}  // namespace

class FastOrbits::Wave {
 public:
  Wave(const FastOrbits& orbits, std::span<const OrbitStart> starts, std::uint64_t bounces,
       OrbitSink& sink)
      : orbits_(orbits), starts_(starts), limit_(bounces), sink_(sink) {}

  FlightCounts run() {
    while (used_ < kWave && next_ < starts_.size()) set_off(rays_[0], used_++);
    for (std::size_t turn = 0; used_ > 0; turn = 1 - turn) fly(rays_[turn], rays_[1 - turn]);
    return counts_;
  }

 private:
  void set_off(RayLanes& rays, std::size_t lane) {
    const auto& [ray, departed, chance] = starts_[next_];
    const bool on_wall = departed.surface != kNoSurface;
    rays.set(lane, ray.origin, unit(ray.direction),
             on_wall ? orbits_.slots_[departed.surface] + (enters(departed.root) ? 0.5 : 0) : -1);
    progress_[lane] = {next_++};
    progress_[lane].exact = on_wall ? departed.root == Root::both : orbits_.is_at_wall(ray.origin);
  }

  // All rays to their next walls; from the last to the first, so that one behind can take the place of
  // an orbit that ends.
  void fly(RayLanes& from, RayLanes& to) {
    constexpr std::size_t kGroup = flights::kWidest;
    const auto count = static_cast<int>((used_ + kGroup - 1) / kGroup * kGroup);
    orbits_.fly_(orbits_.walls_, {from.rays(), to.rays(), t_.data(), wall_.data(), event_.data(),
                                  nx_.data(), ny_.data(), count});
    counts_.flights += used_;
    for (std::size_t i = used_; i-- > 0;) {
      if (goes_on(from, to, i)) continue;
      if (next_ < starts_.size()) {
        set_off(to, i);
      } else {
        to.move(--used_, i);
        progress_[i] = progress_[used_];
      }
    }
  }

  bool goes_on(const RayLanes& from, RayLanes& to, std::size_t i) {
    Progress& orbit = progress_[i];
    const double event = event_[i];
    const bool unsure =
        event == flights::kUnsure || (event == flights::kNothing && orbits_.closed_);
    if (unsure || orbit.exact) return fly_exactly(from, to, i, unsure);
    if (event == flights::kBounced) {
      const double t = orbit.before + t_[i];
      return bounce(orbit, {orbits_.surfaces_[static_cast<std::size_t>(wall_[i])], to.point(i), t,
                            orbit.length + t, Vec2(nx_[i], ny_[i]), from.direction(i),
                            to.direction(i), orbit.cell});
    }
    if (event == flights::kCrossed && orbits_.exact_.periodic().in_disc_across(to.point(i)))
      return fly_exactly(from, to, i, true);
    if (event == flights::kCrossed) return cross(orbit, to, i);
    const auto wall = static_cast<std::size_t>(wall_[i]);
    if (event == flights::kAbsorbed)
      return stop(orbit,
                  {OrbitEnd::absorbed, from.direction(i), to.point(i), {orbits_.surfaces_[wall]}});
    return stop(orbit, {OrbitEnd::escape, from.direction(i), from.point(i)});
  }

  bool bounce(Progress& orbit, const Bounce& bounce) {
    orbit.length = bounce.path_length;
    orbit.before = 0;
    orbit.crossings = 0;
    sink_.bounce(orbit.number, bounce);
    return ++orbit.bounces < limit_ || stop(orbit, {OrbitEnd::limit, bounce.out, bounce.point});
  }

  bool cross(Progress& orbit, const RayLanes& to, std::size_t i) {
    const double* wall =
        orbits_.records_.data() + static_cast<std::size_t>(wall_[i]) * Record::kRecord;
    const Vec2 entry = to.point(i), shift(wall[Record::kShiftX], wall[Record::kShiftY]);
    const CellIndex& step = orbits_.steps_[static_cast<std::size_t>(wall_[i])];
    sink_.cross(orbit.number, entry - shift, entry, step);
    orbit.cell += step;
    orbit.before += t_[i];
    return ++orbit.crossings < kMostCrossings ||
           stop(orbit, {OrbitEnd::escape, to.direction(i), entry});
  }

  // To the next bounce. What comes from near a wall of which lanes are not sure stays there a while.
  bool fly_exactly(const RayLanes& from, RayLanes& to, std::size_t i, bool unsure) {
    Progress& orbit = progress_[i];
    ++counts_.exact;
    const OrbitStart start{{from.point(i), from.direction(i)}, departed_of(from.departed[i])};
    Orbit done = std::move(trace_orbits(orbits_.exact_, std::span(&start, 1), 1).front());
    for (const Crossing& one : done.crossings) {
      sink_.cross(orbit.number, one.from, one.to, one.step);
      orbit.cell += one.step;
    }
    if (done.bounces.empty()) return stop(orbit, done);
    Bounce& met = done.bounces.front();
    met.t = orbit.before + met.path_length;
    met.path_length = orbit.length + met.t;
    met.in = from.direction(i);
    met.cell = orbit.cell;
    met.out = unit(met.out);
    to.set(i, met.point, met.out, slot_left(met));
    orbit.exact = unsure;
    return bounce(orbit, met);
  }

  // The wall that a number of lanes says, and back.
  DepartedSurface departed_of(double slot) const {
    if (slot < 0) return {};
    const auto whole = static_cast<std::size_t>(slot);
    if (whole < static_cast<std::size_t>(orbits_.walls_.segments))
      return {orbits_.surfaces_[whole], Root::none};
    return {orbits_.surfaces_[whole],
            slot > static_cast<double>(whole) ? Root::first : Root::second};
  }
  double slot_left(const Bounce& met) const {
    const double slot = orbits_.slots_[met.surface];
    if (slot < orbits_.walls_.segments) return slot;
    const Vec2& centre = orbits_.exact_.surfaces().arc(met.surface).curve.centre;
    return slot + ((met.point - centre).dot(met.normal) < 0 ? 0.5 : 0);
  }

  bool stop(const Progress& orbit, const OrbitStop& stop) {
    sink_.end(orbit.number, stop);
    return false;
  }

  const FastOrbits& orbits_;
  std::span<const OrbitStart> starts_;
  std::uint64_t limit_;
  OrbitSink& sink_;
  std::size_t next_ = 0, used_ = 0;  // start, lanes
  std::array<RayLanes, 2> rays_;
  Lanes t_{}, wall_{}, event_{}, nx_{}, ny_{};
  std::array<Progress, kWave> progress_;
  FlightCounts counts_;
};

FastOrbits::FastOrbits(const OrbitTracer& exact, bool closed, Isa isa)
    : exact_(exact), closed_(closed), obstacle_(look_for_obstacle()), fly_(kernel_of(isa)) {
  if (!obstacle_.empty()) return;
  const Bounds box = bounds_of(exact.surfaces());
  walls_.near =
      kUndecided * std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  slots_.resize(exact.surfaces().size());
  const auto added = [&] { return static_cast<int>(surfaces_.size()); };
  add_segments(true);
  walls_.hull = added();
  add_segments(false);
  walls_.segments = added();
  add_curves(true);
  walls_.circles = added() - walls_.segments;
  add_curves(false);
  walls_.ellipses = added() - walls_.segments - walls_.circles;
  join_periodic();
  walls_.records = records_.data();
}

std::string FastOrbits::look_for_obstacle() const {
  const Surfaces& walls = exact_.surfaces();
  if (exact_.field() != 0) return "a magnetic field bends their flights";
  if (exact_.has_glass()) return "glass splits them";
  if (walls.size() == 0) return "there are no walls";
  if (walls.size() > kMostWalls) return "there are more than 96 walls";
  if (!walls.beziers.empty()) return "Bezier curves are followed exactly alone";
  const double size = bounds_of(walls).size().maxCoeff();
  if (!(size > kLeastRoom && size < kLargestRoom)) return "the room is too small or too large";
  const auto slender = [&](const Arc& wall) {
    const double length = std::sqrt(wall.curve.u.squaredNorm() + wall.curve.v.squaredNorm());
    const double width = std::fabs(cross(wall.curve.u, wall.curve.v)) / length;
    return !(size / width * (length / width) <= kMostSlender);
  };
  if (std::ranges::any_of(walls.arcs, slender))
    return "a curve is too small or too thin for the room";
  return std::ranges::all_of(walls.arcs, ends_on_curve) ? "" : "an arc ends off its curve";
}

void FastOrbits::add(std::uint32_t surface, double (&record)[Record::kRecord]) {
  record[Record::kNextLeft] = slots_[surface] = static_cast<double>(surfaces_.size());
  record[Record::kEvent] = event_of(exact_.materials()[surface]);
  surfaces_.push_back(surface);
  records_.insert(records_.end(), std::begin(record), std::end(record));
}

// Those whose line has all of the room on one side, or the others.
void FastOrbits::add_segments(bool hull) {
  const Surfaces& walls = exact_.surfaces();
  const double rounding = kStepRounding / kUndecided * walls_.near;
  for (std::size_t i = 0; i < walls.segments.size(); ++i) {
    const auto& [a, b] = walls.segments[i];
    const Vec2 way = b - a, middle = 0.5 * a + 0.5 * b;
    const double length = std::sqrt(way.squaredNorm());
    const Vec2 along = way / length;
    Vec2 normal(along.y(), -along.x());
    const auto reach_beyond = [&](const Vec2& out) { return reach(out) - out.dot(middle); };
    if (reach_beyond(normal) > rounding && reach_beyond(-normal) <= rounding) normal = -normal;
    if ((closed_ && reach_beyond(normal) <= rounding) != hull) continue;
    double record[Record::kRecord] = {};
    record[Record::kNormalX] = normal.x();
    record[Record::kNormalY] = normal.y();
    record[Record::kOffset] = normal.dot(middle);
    record[Record::kBend] = 2;
    record[Record::kAlongX] = along.x();
    record[Record::kAlongY] = along.y();
    record[Record::kMiddle] = along.dot(middle);
    record[Record::kHalf] = 0.5 * length;
    add(walls.segment_numbers[i], record);
  }
}

// How far the walls reach in a direction, or a little more.
double FastOrbits::reach(const Vec2& out) const {
  const Surfaces& walls = exact_.surfaces();
  double most = -kInfinity;
  for (const Segment& wall : walls.segments)
    most = std::max({most, out.dot(wall.a), out.dot(wall.b)});
  for (const Arc& wall : walls.arcs) {
    const Bounds box = bounds_of(wall);
    for (const double x : {box.low.x(), box.high.x()})
      for (const double y : {box.low.y(), box.high.y()}) most = std::max(most, out.dot(Vec2(x, y)));
  }
  return most;
}

// Or so near the line or curve of one that it may be.
bool FastOrbits::is_at_wall(const Vec2& point) const {
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const double* wall = records_.data() + i * Record::kRecord;
    if (static_cast<int>(i) < walls_.segments) {
      const Vec2 normal(wall[Record::kNormalX], wall[Record::kNormalY]);
      if (std::fabs(normal.dot(point) - wall[Record::kOffset]) < walls_.near) return true;
      continue;
    }
    const double x = point.x() - wall[Record::kCentreX], y = point.y() - wall[Record::kCentreY];
    const double a = wall[Record::kFormXx] * x + wall[Record::kFormXy] * y;
    const double b = wall[Record::kFormYx] * x + wall[Record::kFormYy] * y;
    if (std::fabs(a * a + b * b - 1) < 4 * kUndecided) return true;
  }
  return false;
}

void FastOrbits::join_periodic() {
  steps_.resize(surfaces_.size());
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    double* record = records_.data() + i * Record::kRecord;
    if (record[Record::kEvent] != flights::kCrossed) continue;
    const PeriodicWalls::Side& side = *exact_.periodic().find(surfaces_[i]);
    record[Record::kBend] = 0;
    record[Record::kShiftX] = side.to().x() - side.from().x();
    record[Record::kShiftY] = side.to().y() - side.from().y();
    record[Record::kNextLeft] = slots_[side.opposite];
    steps_[i] = side.step;
  }
}

void FastOrbits::add_curves(bool circles) {
  const Surfaces& walls = exact_.surfaces();
  for (const std::uint32_t surface : walls.curve_numbers) {
    const Arc& arc = walls.arc(surface);
    if (arc.curve.is_circle() != circles) continue;
    double record[Record::kRecord] = {};
    record[Record::kCentreX] = arc.curve.centre.x();
    record[Record::kCentreY] = arc.curve.centre.y();
    record[Record::kSquare] = arc.curve.u.x() * arc.curve.u.x();
    put_form(record, arc.curve);
    put_extent(record, arc);
    add(surface, record);
  }
}

FlightCounts FastOrbits::follow(std::span<const OrbitStart> starts, std::uint64_t bounces,
                                OrbitSink& sink) const {
  if (obstacle_.empty() && bounces > 0) return Wave(*this, starts, bounces, sink).run();
  exact_.follow(starts, bounces, sink);
  return {};
}

}  // namespace flatray
