// needs: mpfr shapes/cell shapes/mushroom shapes/penrose shapes/tokarsky
// Orbits of every room of scenes/chamber, as `orbit` prints them, against a moving point in GMP that shares
// no formula with them: a bounce that is called certain is on that point's wall, in its order, and where
// it is said to be. Ten orbits a room; 200 at full counts (docs/measured/rooms.md).
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "anim/rays.h"
#include "base/philox.h"
#include "base/portable_math.h"
#include "base/processor_time.h"
#include "full_counts.h"
#include "oracle/long_orbit.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "scene/load.h"
#include "scene/material.h"
#include "study/rooms/room.h"
#include "support/paths.h"

namespace flatray {
namespace {

constexpr std::uint64_t kBouncesFollowed = 60;
constexpr unsigned kOracleBits = 1024;

// Rooms where the oracle looks for 256 roots a wall.
std::uint64_t bounces_in(const Room& room) {
  return room.walls().beziers.empty() ? kBouncesFollowed : 20;
}

class RoomRays {
 public:
  RoomRays(const Room& room, std::uint64_t number) : room_(room), number_(number) {
    // What is met, not how far lone walls go on.
    for (std::uint32_t i = 0; i < room.walls().size(); ++i)
      if (room.scene().chambers.empty() || room.materials()[i] != Material::absorb)
        box_.add(room.walls().visit(i, [](const auto& wall) { return bounds_of(wall); }));
  }

  Ray draw() const {
    if (number_ % 8 == 0) {  // those of the scene, and near them
      const std::vector<RayState> rays = ray_states(room_.scene(), room_.state());
      Ray ray = rays[number_ / 8 % rays.size()].start;
      ray.origin += std::ldexp(static_cast<double>(number_ / 8 / rays.size()), -40) * Vec2(1, 1);
      return ray;
    }
    if (number_ % 8 < 3) return room_.draw_start(1, number_).ray;
    for (std::uint32_t attempt = 0; attempt < 4000; attempt += 4) {
      const Ray ray = drawn(attempt);
      if (ray.direction != Vec2(0, 0) && room_.has_start(ray.origin)) return ray;
    }
    return room_.draw_start(1, number_).ray;
  }

 private:
  double unit(std::uint32_t draw) const {
    return unit_double(random_bits(1, Stream::test, 7, number_, draw));
  }
  std::uint32_t one_of(std::size_t count, std::uint32_t draw) const {
    return static_cast<std::uint32_t>(unit(draw) * static_cast<double>(count));
  }
  Vec2 within(std::uint32_t draw) const {
    return box_.low + Vec2(unit(draw), unit(draw + 1)).cwiseProduct(box_.size());
  }
  // A place of few bits, from which much is met exactly.
  static Vec2 on_grid(const Vec2& v) {
    return {std::round(v.x() * 64) / 64, std::round(v.y() * 64) / 64};
  }

  Ray drawn(std::uint32_t attempt) const {
    const Vec2 place = within(attempt), plain = on_grid(place);
    const std::uint32_t wall = one_of(room_.walls().size(), attempt + 2);
    const double angle = 0x1.921fb54442d18p+2 * unit(attempt + 3);
    switch (number_ % 8) {
      case 3:
        return {place, {portable::cos(angle), portable::sin(angle)}};
      case 4: {  // from the neighbourhood of one wall to another
        const std::uint32_t other = one_of(room_.walls().size(), attempt + 3);
        const Vec2 from = room_.walls().visit(wall, [](const auto& one) { return mark(one); });
        const Vec2 to = room_.walls().visit(other, [](const auto& one) { return mark(one); });
        const Vec2 near = from + (0.15 + 0.4 * unit(attempt)) * (to - from);
        return {near, to - from + 0.02 * (place - near)};
      }
      case 5: {  // into a corner, or at the middle of a curve
        const Vec2 corner = room_.walls().visit(wall, [](const auto& one) { return mark(one); });
        return {plain, corner - plain};
      }
      case 6: {  // periodic ones between parallel walls, from point to point of a grid
        const Vec2 ways[] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 1}, {-1, -3}};
        return {plain, ways[one_of(6, attempt + 3)]};
      }
      default:
        return room_.walls().visit(wall, [&](const auto& one) { return beside(one, plain); });
    }
  }

  static Vec2 mark(const Segment& wall) { return wall.a; }
  static Vec2 mark(const Arc& wall) {
    return wall.extent == Arc::Extent::between ? wall.from : wall.curve.centre;
  }
  static Vec2 mark(const Bezier& wall) { return wall.start(); }

  // Along a wall, or across it; along the tangent of a curve.
  Ray beside(const Segment& wall, const Vec2& plain) const {
    const Vec2 along = wall.b - wall.a, middle = 0.5 * (wall.a + wall.b);
    if (number_ % 16 < 8) return {number_ % 32 < 16 ? middle : plain, along};
    return {middle, unit(9999) < 0.5 ? Vec2(along.y(), -along.x()) : Vec2(-along.y(), along.x())};
  }
  Ray beside(const Arc& wall, const Vec2& plain) const {
    const Ellipse& curve = wall.curve;
    const Vec2 top = curve.centre + curve.v;
    if (number_ % 16 < 8) return {Vec2(plain.x(), top.y()), {curve.centre.x() - plain.x(), 0}};
    return {curve.centre + 0.25 * curve.u, curve.v};
  }
  Ray beside(const Bezier& wall, const Vec2& plain) const {
    return {plain, wall.end() - wall.start()};
  }

  const Room& room_;
  std::uint64_t number_;
  Bounds box_;
};

// What `orbit` says of a room, and how much of it is wrong.
struct Tally {
  std::uint64_t orbits = 0, bounces = 0, plain = 0, overclaimed = 0, ends = 0, undecided = 0;
  double seconds = 0, longest = 0;
};

// Whether a double is the nearest to the point of a bounce, or as near as another.
bool is_there(const Vec2& told, const oracle::LongOrbit::Bounce& truth) {
  const auto is_near = [](double a, double b, double beyond) {
    const double apart = a - b;
    return a == b || std::fabs(apart) < 0x1p-200 ||
           std::fabs(apart - beyond) <= 0.5 * std::fabs(apart) * (1 + 0x1p-50);
  };
  return is_near(told.x(), truth.point.x(), truth.beyond.x()) &&
         is_near(told.y(), truth.point.y(), truth.beyond.y());
}

// Bounces of the oracle before the first corner.
std::size_t plain_bounces(const oracle::LongOrbit& truth) {
  const auto corner = std::find_if(truth.bounces.begin(), truth.bounces.end(),
                                   [](const auto& bounce) { return bounce.corner; });
  const bool absorbed =
      truth.end == oracle::LongOrbit::End::absorbed && corner == truth.bounces.end();
  return static_cast<std::size_t>(corner - truth.bounces.begin()) - (absorbed ? 1 : 0);
}

bool ends_so(const CertifiedOrbit& orbit, const oracle::LongOrbit& truth, std::uint64_t most) {
  const std::size_t count = orbit.bounces.size(), plain = plain_bounces(truth);
  if (orbit.end == OrbitEnd::limit) return count == most && plain == count;
  if (orbit.end == OrbitEnd::along) return count == 0;
  if (plain != count) return false;
  if (orbit.end == OrbitEnd::escape)
    return truth.bounces.size() == count && truth.end == oracle::LongOrbit::End::escape;
  const bool corner = truth.bounces.size() > count && truth.bounces[count].corner;
  const bool absorbed = truth.end == oracle::LongOrbit::End::absorbed;
  if (orbit.end == OrbitEnd::corner && !corner) return false;
  if (orbit.end == OrbitEnd::absorbed && !absorbed) return false;
  return is_there(orbit.end_point, truth.bounces[count]);
}

void check(const Room& room, std::uint64_t number, const std::string& name, Tally& tally) {
  const Ray start = RoomRays(room, number).draw();
  const std::uint64_t bounces = bounces_in(room);
  const double begin = thread_seconds();
  const auto orbit = certified_orbit(room.walls(), start, bounces,
                                     {room.materials(), 4096, std::uint64_t{1} << 26});
  const Orbit plain = trace_orbit(room.walls(), room.materials(), start, bounces);
  const Proven proven = proven_bounces(room.walls(), plain, room.materials());
  const double seconds = thread_seconds() - begin;
  ASSERT_TRUE(orbit.has_value());
  ++tally.orbits;
  tally.seconds += seconds;
  tally.longest = std::max(tally.longest, seconds);
  tally.bounces += orbit->bounces.size();
  tally.plain += proven.bounces;
  if (!orbit->decided) ++tally.undecided;
  const bool stays = orbit->bounces.empty() && orbit->decided &&
                     trace_orbit(room.walls(), room.materials(), start, 0).end != OrbitEnd::limit;
  if (stays) return;  // starts in a corner, along a wall: nothing is followed
  const oracle::LongOrbit truth =
      oracle::long_orbit(room.walls(), start, bounces, kOracleBits, room.materials());
  const std::string told =
      fmt::format("{} orbit {}: from ({}, {}) by ({}, {})", name, number, start.origin.x(),
                  start.origin.y(), start.direction.x(), start.direction.y());
  const auto is_right = [&](std::size_t i, std::uint32_t surface) {
    return i < plain_bounces(truth) && truth.bounces[i].surface == surface;
  };
  for (std::size_t i = 0; i < orbit->bounces.size(); ++i) {
    const CertifiedOrbit::Bounce& bounce = orbit->bounces[i];
    if (is_right(i, bounce.surface) && is_there(bounce.point, truth.bounces[i])) continue;
    ++tally.overclaimed;
    ADD_FAILURE() << told << ", bounce " << i;
    break;
  }
  for (std::size_t i = 0; i < proven.bounces; ++i) {
    if (is_right(i, plain.bounces[i].surface)) continue;
    ++tally.overclaimed;
    ADD_FAILURE() << told << ", bounce " << i << " in doubles";
    break;
  }
  if (!orbit->decided) return;
  if (!ends_so(*orbit, truth, bounces)) {
    ++tally.overclaimed;
    ADD_FAILURE() << told << " ends as " << flatray::name(orbit->end) << " after "
                  << orbit->bounces.size() << ", not " << plain_bounces(truth) << " of "
                  << truth.bounces.size() << " with end " << static_cast<int>(truth.end);
  }
}

std::vector<std::filesystem::path> rooms() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("/scenes/chamber")))
    if (entry.path().extension() == ".toml") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

TEST(CertifiedRooms, EveryBounceCalledCertainIsThatOfAnIndependentProgram) {
  Tally all;
  std::printf("%-20s %6s %8s %10s %9s %11s %8s %8s\n", "room", "orbits", "certain", "in doubles",
              "undecided", "overclaimed", "seconds", "longest");
  const auto print = [](const std::string& name, const Tally& t) {
    fmt::print("{:<20} {:6} {:8} {:10} {:9} {:11} {:8.2f} {:8.2f}\n", name, t.orbits, t.bounces,
               t.plain, t.undecided, t.overclaimed, t.seconds, t.longest);
    std::fflush(stdout);
  };
  for (const auto& path : rooms()) {
    const auto loaded = load_scene(path.string());
    ASSERT_TRUE(loaded.has_value()) << path;
    if (loaded->scene.field() != 0 || place_of_glass(loaded->scene)) continue;  // it flies straight
    const Room room(loaded->scene);
    Tally tally;
    for (std::uint64_t number = 0; number < times(200, 10); ++number)
      check(room, number, path.stem().string(), tally);
    print(path.stem().string(), tally);
    all.orbits += tally.orbits;
    all.bounces += tally.bounces;
    all.plain += tally.plain;
    all.undecided += tally.undecided;
    all.overclaimed += tally.overclaimed;
    all.seconds += tally.seconds;
    all.longest = std::max(all.longest, tally.longest);
  }
  print("all", all);
  EXPECT_GT(all.bounces, 30 * all.orbits);
}

}  // namespace
}  // namespace flatray
