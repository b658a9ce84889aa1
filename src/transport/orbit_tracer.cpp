#include "transport/orbit_tracer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/philox.h"
#include "geom/clip.h"
#include "geom/error_free.h"
#include "geom/predicates.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

// So few rays are faster asked one by one than in the lanes of a batch.
constexpr std::size_t kFewFlights = 12;

}  // namespace

// A ray under way.
struct OrbitTracer::Flight {
  Ray ray;
  DepartedSurface departed;
  Speed speed;
  std::size_t number;
  DoubleDouble time{0, 0};  // sum of all t
  double moment = 0;        // about the circle left, as it was when it was first met in a row
  double before = 0;        // part of the next t that was flown before ray.origin
  std::uint64_t bounces = 0;
  CellIndex cell{};
  std::uint32_t crossings = 0;  // since the last bounce
  Vec2 entry{0, 0};             // to which the first of them led
  bool circles = false;         // came back there: it does so for ever

  double path_length() const {  // a t beyond the largest double is that
    const double t = time.hi + time.lo;
    return t < std::numeric_limits<double>::max() ? t * speed.length() : kInfinity;
  }
};

class OrbitTracer::Wave {
 public:
  Wave(const OrbitTracer& orbits, std::uint64_t bounces, OrbitSink& sink)
      : walls_(orbits.walls_), orbits_(orbits), limit_(bounces), sink_(sink) {}

  void set_off(std::span<const OrbitStart> starts) {
    if (orbits_.glass_ != nullptr) splits_.resize(starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
      Flight flight{starts[i].ray, starts[i].departed, Speed(starts[i].ray.direction), i};
      if (!start(flight)) continue;
      if (orbits_.glass_ != nullptr)
        splits_[i] = {orbits_.glass_->media_at(flight.ray, flight.departed), starts[i].chance};
      flights_.push_back(flight);
    }
  }

  void run() {
    if (orbits_.field_ != 0)
      for (Flight& flight : std::exchange(flights_, {}))
        while (advance_in_field(flight)) {
        }
    while (flights_.size() > kFewFlights) run_together();
    for (Flight& flight : flights_)
      while (advance(flight, orbits_.tracer_->nearest_of_one(flight.ray, flight.departed, false))) {
      }
  }

 private:
  // All of them to their next wall.
  void run_together() {
    rays_.tangents = false;
    rays_.resize(flights_.size());
    hits_.resize(flights_.size());
    for (std::size_t i = 0; i < flights_.size(); ++i)
      rays_.set(i, flights_[i].ray, flights_[i].departed);
    orbits_.tracer_->nearest(rays_, hits_);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < flights_.size(); ++i)
      if (advance(flights_[i], hits_[i])) flights_[kept++] = flights_[i];
    flights_.erase(flights_.begin() + static_cast<std::ptrdiff_t>(kept), flights_.end());
  }

  // Whether the ray can set off.
  bool start(Flight& flight) {
    if (flight.departed.surface == kNoSurface) {
      const Vec2& origin = flight.ray.origin;
      const std::vector<std::uint32_t> stood_on = orbits_.origins_.walls_at(origin);
      const bool corner =
          stood_on.size() > 1 || (stood_on.size() == 1 && is_end(walls_, stood_on.front(), origin));
      if (corner) return stop(flight, OrbitEnd::corner, stood_on);
      if (!stood_on.empty())
        flight.departed = {stood_on.front(), root_stood_on(walls_, stood_on.front(), flight.ray)};
      cross(flight, origin, stood_on, 0);
    }
    if (flight.departed.surface != kNoSurface &&
        runs_along(walls_, flight.departed, flight.ray.direction))
      return stop(flight, OrbitEnd::along, {flight.departed.surface});
    return limit_ > 0 || stop(flight, OrbitEnd::limit, {});
  }

  // Takes the ray to its next wall; whether it goes on from there.
  bool advance(Flight& flight, const NearestHit& hit) {
    if (!hit) return stop(flight, OrbitEnd::escape, {});
    return arrive(flight, enters_by(flight, hit.surface) ? next_inside(flight) : hit);
  }

  // The same along an arc of a circle.
  bool advance_in_field(Flight& flight) {
    const FieldFlight arc{flight.ray, 0.5 * orbits_.field_ * flight.speed.length()};
    const auto hit = first_in_field(walls_, arc);
    if (!hit) return stop(flight, OrbitEnd::cyclotron, {});
    const double t = hit->meeting.time();
    flight.ray.direction = hit->meeting.direction();
    flight.time = plus(flight.time, t);
    ExactOrigin origin = orbits_.origins_.after(arc, *hit);
    if (origin.corner.empty() && is(hit->surface, Material::mirror))
      return bounce(flight, {hit->surface}, origin.point, t,
                    reflect_in_field(walls_, hit->surface, hit->meeting.from(),
                                     flight.ray.direction, origin, flight.speed));
    if (origin.corner.empty()) origin.corner = {hit->surface};
    return ends_at(flight, std::move(origin));
  }

  // From a corner of periodic walls, where only one of the two is the wall just left.
  bool enters_by(const Flight& flight, std::uint32_t surface) const {
    return orbits_.periodic_.has(surface) &&
           !orbits_.periodic_.leads_out(surface, flight.ray.direction);
  }
  NearestHit next_inside(const Flight& flight) const {
    for (const NearestHit& hit : orbits_.tracer_->all_of_one(flight.ray, flight.departed, false))
      if (!enters_by(flight, hit.surface)) return hit;
    return {};
  }

  // An inexact tracer may name a wall that the ray runs along, or misses: no origin is beside it.
  bool is_crossed(const Ray& ray, const NearestHit& hit) const {
    return walls_.visit(hit.surface,
                        [&](const auto& wall) { return flatray::is_crossed(wall, ray); });
  }

  // The centre of the circle that a wall is on.
  std::optional<Vec2> circle_at(std::uint32_t surface) const {
    const auto circle = walls_.visit(surface, [](const auto& wall) { return circle_along(wall); });
    return circle ? std::optional(circle->centre) : std::nullopt;
  }

  bool arrive(Flight& flight, const NearestHit& hit) {
    if (!hit) return stop(flight, OrbitEnd::escape, {});
    if (!orbits_.choice_.tracer->exact && !is_crossed(flight.ray, hit))
      return stop(flight, OrbitEnd::corner, {hit.surface});
    ExactOrigin origin = orbits_.origins_.after(flight.ray, hit);
    flight.time = plus(flight.time, hit.t);
    if (origin.corner.empty()) {
      if (is(hit.surface, Material::mirror)) {
        auto reflection = reflect_off(walls_, flight.ray, hit, origin, flight.speed);
        const DepartedSurface wall{hit.surface, root_departed_by(hit.root)};
        if (reflection && circle_at(wall.surface))
          keep_moment(flight, wall, origin.point, reflection->direction);
        return bounce(flight, wall, origin.point, hit.t, reflection);
      }
      if (orbits_.glass_ != nullptr && is(hit.surface, Material::glass))
        return split(flight, hit, origin);
      origin.corner = {hit.surface};
    }
    if (is_all(origin.corner, Material::periodic) &&
        cross(flight, origin.point, origin.corner, hit.t))
      return !(flight.circles || flight.crossings == kMostCrossings) ||
             stop(flight, OrbitEnd::escape, {});
    if (orbits_.corners_ == CornerRule::back && !orbits_.periodic_.any() &&
        orbits_.glass_ == nullptr && taken_by(orbits_.materials_, origin.corner).empty())
      return turn_back(flight, origin, hit.t);
    return ends_at(flight, std::move(origin));
  }

  bool ends_at(Flight& flight, ExactOrigin origin) {
    flight.ray.origin = origin.point;
    std::vector<std::uint32_t> takers = taken_by(orbits_.materials_, origin.corner);
    if (takers.empty()) return stop(flight, OrbitEnd::corner, std::move(origin.corner));
    return stop(flight, OrbitEnd::absorbed, std::move(takers));
  }

  // Goes on from the opposite walls; false where none of these leads out.
  bool cross(Flight& flight, const Vec2& point, std::span<const std::uint32_t> surfaces, double t) {
    const auto entry = orbits_.periodic_.cross(point, flight.ray.direction, surfaces);
    if (!entry) return false;
    sink_.cross(flight.number, point, entry->point, entry->step);
    flight.cell += entry->step;
    flight.ray.origin = entry->point;
    flight.departed = {entry->surface, Root::none};
    flight.before += t;
    flight.circles = flight.crossings > 0 && entry->point == flight.entry;
    if (flight.crossings++ == 0) flight.entry = entry->point;
    return true;
  }

  // From one bounce inside a circle to the next the moment stays, without drift.
  void keep_moment(Flight& flight, const DepartedSurface& wall, const Vec2& point,
                   Vec2& direction) const {
    if (flight.bounces == 0 || flight.departed.surface != wall.surface)
      flight.moment = moment_about(*circle_at(wall.surface), flight.ray);
    direction = with_moment(walls_, wall, point, direction, flight.moment);
  }

  bool bounce(Flight& flight, const DepartedSurface& wall, const Vec2& point, double t,
              const std::optional<Reflection>& reflection) {
    flight.ray.origin = point;
    if (!reflection) return stop(flight, OrbitEnd::along, {wall.surface});
    report(flight, {wall.surface, point, flight.before + t, flight.path_length(),
                    reflection->normal, flight.ray.direction, reflection->direction, flight.cell});
    flight.before = 0;
    flight.crossings = 0;
    flight.ray.direction = reflection->direction;
    flight.departed = wall;
    return flight.bounces < limit_ || stop(flight, OrbitEnd::limit, {});
  }

  // At glass the ray is reflected or refracted, by chance.
  bool split(Flight& flight, const NearestHit& hit, const ExactOrigin& origin) {
    const Sign side = inner_side(walls_, flight.ray, hit);
    Split& own = splits_[flight.number];
    const double chance =
        unit_double(random_bits(own.chance, Stream::split, flight.bounces >> 32, flight.bounces));
    const auto refracted =
        orbits_.glass_->refracted({hit.surface, side, unit(flight.ray.direction),
                                   static_cast<double>(side) * unit(origin.normal)},
                                  own.media, chance);
    if (!refracted)
      return bounce(flight, {hit.surface, root_departed_by(hit.root)}, origin.point, hit.t,
                    told(reflect_off(walls_, flight.ray, hit, origin, flight.speed), true));
    ExactOrigin beyond = orbits_.origins_.after(flight.ray, hit, GoesOn::through);
    if (!beyond.corner.empty()) {
      flight.ray.origin = beyond.point;
      return stop(flight, OrbitEnd::corner, std::move(beyond.corner));
    }
    const Root left =
        walls_.visit(hit.surface, [&](const auto& wall) { return root_departed(wall, -side); });
    const bool goes_on = bounce(
        flight, {hit.surface, left}, beyond.point, hit.t,
        told(refract_through(walls_, hit.surface, side, *refracted, beyond, flight.speed), false));
    if (own.media.forgets()) own.media = orbits_.glass_->media_at(flight.ray, flight.departed);
    return goes_on;
  }

  // Where it grazes so that its rounded normal does not tell which it was, it runs along the wall.
  static std::optional<Reflection> told(std::optional<Reflection> out, bool is_back) {
    if (out && (out->direction.dot(out->normal) < 0) == is_back) return std::nullopt;
    return out;
  }

  // From a corner the ray flies back to where it last was: a wall, off which it goes again, or its
  // start.
  bool turn_back(Flight& flight, const ExactOrigin& corner, double t) {
    const Vec2 back = -flight.ray.direction;
    report(flight, {corner.corner.front(), corner.point, flight.before + t, flight.path_length(),
                    unit(back), -back, back});
    flight.before = 0;
    flight.ray.direction = back;
    flight.moment = -flight.moment;
    if (flight.bounces == limit_) {
      flight.ray.origin = corner.point;
      return stop(flight, OrbitEnd::limit, {});
    }
    flight.time = plus(flight.time, t);
    if (flight.departed.surface == kNoSurface) {
      flight.before = t;
      return true;
    }
    if (!is(flight.departed.surface, Material::mirror))
      return stop(flight, OrbitEnd::absorbed, {flight.departed.surface});
    return bounce(flight, flight.departed, flight.ray.origin, t,
                  reflect_again(walls_, flight.departed, flight.ray.origin, back, flight.speed));
  }

  void report(Flight& flight, const Bounce& bounce) {
    ++flight.bounces;
    sink_.bounce(flight.number, bounce);
  }

  bool stop(const Flight& flight, OrbitEnd end, std::vector<std::uint32_t> surfaces) {
    sink_.end(flight.number,
              {end, unit(flight.ray.direction), flight.ray.origin, std::move(surfaces)});
    return false;
  }

  bool is_all(std::span<const std::uint32_t> surfaces, Material material) const {
    return std::ranges::all_of(surfaces, [&](std::uint32_t i) { return is(i, material); });
  }
  bool is(std::uint32_t surface, Material material) const {
    return orbits_.materials_[surface] == material;
  }

  // Of an orbit where there is glass.
  struct Split {
    Media media;  // it is in
    std::uint64_t chance;
  };

  const Surfaces& walls_;
  const OrbitTracer& orbits_;
  std::uint64_t limit_;
  OrbitSink& sink_;
  std::vector<Split> splits_;    // by number
  std::vector<Flight> flights_;  // still under way, in the order they were given
  RayBatch rays_;
  std::vector<NearestHit> hits_;
};

OrbitTracer::OrbitTracer(const Surfaces& walls, std::span<const Material> materials,
                         const OrbitRules& rules)
    : walls_(walls),
      materials_(materials),
      corners_(rules.corners),
      field_(rules.field),
      glass_(rules.glass != nullptr && rules.glass->any() ? rules.glass : nullptr),
      choice_(choose_tracer(walls, rules.tracer)),
      origins_(walls),
      tracer_(choice_.tracer->build(walls)),
      periodic_(walls, materials) {}

void OrbitTracer::follow(std::span<const OrbitStart> starts, std::uint64_t bounces,
                         OrbitSink& sink) const {
  Wave wave(*this, bounces, sink);
  wave.set_off(starts);
  wave.run();
}

}  // namespace flatray
