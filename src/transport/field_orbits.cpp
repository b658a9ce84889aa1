#include "transport/field_orbits.h"

#include <cmath>

#include "base/portable_math.h"
#include "transport/orbit.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

class FieldOrbit {
 public:
  FieldOrbit(const FieldRoom& room, const OrbitStart& start, std::size_t number, OrbitSink& sink)
      : room_(room),
        sink_(sink),
        number_(number),
        speed_(start.ray.direction),
        flight_{start.ray, 0.5 * room.field * speed_.length()},
        left_(start.left) {}

  void follow(std::uint64_t bounces) {
    if (!set_off()) return;
    for (std::uint64_t i = 0; i < bounces; ++i)
      if (!fly()) return;
    stop(OrbitEnd::limit, {});
  }

 private:
  bool set_off() {
    const Vec2& origin = flight_.ray.origin;
    if (left_.surface == kNoSurface) {
      const std::vector<std::uint32_t> stood_on = room_.origins.walls_at(origin);
      if (stood_on.size() > 1 ||
          (stood_on.size() == 1 && is_end(room_.walls, stood_on.front(), origin)))
        return stop(OrbitEnd::corner, stood_on);
      if (!stood_on.empty()) left_.surface = stood_on.front();
    }
    return left_.surface == kNoSurface || !runs_along(room_.walls, left_, flight_.ray.direction) ||
           stop(OrbitEnd::along, {left_.surface});
  }

  // To the next wall; whether it goes on from there.
  bool fly() {
    const auto hit = first_in_field(room_.walls, flight_);
    if (!hit) return stop(OrbitEnd::cyclotron, {});
    const double t = hit->meeting.time();
    const Vec2 in = hit->meeting.direction();
    ExactOrigin origin = room_.origins.after(flight_, *hit);
    add_to(time_, t);
    flight_.ray = {origin.point, in};
    if (origin.corner.empty() && room_.materials[hit->surface] != Material::mirror)
      origin.corner = {hit->surface};
    if (std::vector<std::uint32_t> takers = taken_by(room_.materials, origin.corner);
        !takers.empty())
      return stop(OrbitEnd::absorbed, std::move(takers));
    if (!origin.corner.empty()) return stop(OrbitEnd::corner, std::move(origin.corner));
    const auto out =
        reflect_in_field(room_.walls, hit->surface, hit->meeting.from(), in, origin, speed_);
    if (!out) return stop(OrbitEnd::along, {hit->surface});
    sink_.bounce(number_, {hit->surface, origin.point, t, (time_.hi + time_.lo) * speed_.length(),
                           out->normal, in, out->direction});
    flight_.ray.direction = out->direction;
    return true;
  }

  bool stop(OrbitEnd end, std::vector<std::uint32_t> surfaces) {
    sink_.end(number_, {end, unit(flight_.ray.direction), flight_.ray.origin, std::move(surfaces)});
    return false;
  }

  const FieldRoom& room_;
  OrbitSink& sink_;
  std::size_t number_;
  Speed speed_;
  FieldFlight flight_;
  Left left_;
  DoubleDouble time_{0, 0};
};

}  // namespace

void follow_in_field(const FieldRoom& room, const OrbitStart& start, std::uint64_t bounces,
                     std::size_t number, OrbitSink& sink) {
  FieldOrbit(room, start, number, sink).follow(bounces);
}

// By half the angle flown, whose tangent is that between the direction and the chord.
std::vector<Vec2> points_between(double field, const Ray& flight, const Vec2& to) {
  constexpr double kPi = 0x1.921fb54442d18p+1, kParts = 256;
  const Vec2 d = unit(flight.direction), left = (field < 0 ? -1 : 1) * Vec2(-d.y(), d.x());
  const Vec2 way = to - flight.origin;
  const double half = way == Vec2(0, 0) ? kPi : portable::atan2(way.dot(left), way.dot(d));
  const double whole = half < 0 ? half + kPi : half;  // just below 0 by rounding
  const int parts = static_cast<int>(std::ceil(kParts * whole / kPi));
  std::vector<Vec2> points;
  for (int i = 1; i < parts; ++i) {
    const double part = whole * i / parts, sine = portable::sin(part);
    points.push_back(flight.origin +
                     2 * sine / std::fabs(field) * (portable::cos(part) * d + sine * left));
  }
  return points;
}

}  // namespace flatray
