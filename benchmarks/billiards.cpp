// Nanoseconds a bounce on one thread of a textbook's loops in plain doubles, of fast orbits and of exact ones: the
// same starts, turns taken round by round. The sum of path lengths is what all give.
//   billiards [ORBITS BOUNCES [ROOM]]
#include <fmt/core.h>

#include <cstdlib>
#include <cstring>

#include "base/philox.h"
#include "measure.h"
#include "textbook_billiards.h"
#include "transport/fast_orbits.h"

namespace {

using flatray::Material;
using flatray::Vec2;

class Lengths : public flatray::OrbitSink {
 public:
  void bounce(std::size_t, const flatray::Bounce& bounce) override {
    length += bounce.t;
    ++bounces;
  }
  void end(std::size_t, const flatray::OrbitStop&) override {}
  double length = 0, bounces = 0;
};

struct Room {
  const char* name;
  flatray::Surfaces walls;
  std::vector<Material> materials;
  bool closed;

  Room(const char* name_, flatray::Surfaces walls_, bool closed_, std::size_t periodic = 0)
      : name(name_),
        walls(std::move(walls_)),
        materials(walls.size(), Material::mirror),
        closed(closed_) {
    std::fill_n(materials.begin(), periodic, Material::periodic);
  }
};

flatray::Surfaces ring(const std::vector<Vec2>& vertices) {
  flatray::Surfaces walls;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    walls.add(flatray::Segment{vertices[i], vertices[(i + 1) % vertices.size()]});
  return walls;
}

flatray::Surfaces box() { return ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

flatray::Surfaces with_disc(flatray::Surfaces walls) {
  walls.add(flatray::Circle{{0.5, 0.5}, 0.25});
  return walls;
}

flatray::Surfaces stadium() {
  flatray::Surfaces walls;
  walls.add(flatray::Segment{{-1, -1}, {1, -1}});
  walls.add(flatray::Arc{flatray::Circle{{1, 0}, 1}, flatray::Arc::Extent::half, {1, 0}, {0, 0}});
  walls.add(flatray::Segment{{1, 1}, {-1, 1}});
  walls.add(flatray::Arc{flatray::Circle{{-1, 0}, 1}, flatray::Arc::Extent::half, {-1, 0}, {0, 0}});
  return walls;
}

flatray::Surfaces ellipse() {
  flatray::Surfaces walls;
  walls.add(flatray::Arc{flatray::Ellipse({0, 0}, {3, 0}, {0, 2}), flatray::Arc::Extent::whole});
  return walls;
}

flatray::Surfaces three_discs() {
  flatray::Surfaces walls;
  for (const auto& centre : bench::textbook::ThreeDiscs::kCentres)
    walls.add(flatray::Circle{{centre[0], centre[1]}, 1});
  return walls;
}

double draw(std::uint64_t number, std::uint32_t which) {
  return flatray::unit_double(
      flatray::random_bits(1, flatray::Stream::experiment, 0, number, which));
}

// Places that lie in every room, in any direction.
std::vector<flatray::OrbitStart> starts(std::size_t count) {
  std::vector<flatray::OrbitStart> all;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * draw(i, 1);
    all.push_back({{{0.05 + 0.15 * draw(i, 0), 0.1}, {std::cos(angle), std::sin(angle)}}});
  }
  return all;
}

struct Size {
  std::size_t orbits = 512;
  std::uint64_t bounces = 1000;
  const char* room = nullptr;  // the one to run; all without
};

template <class Textbook>
void compare(const Room& room, const Size& size) {
  if (size.room != nullptr && std::strcmp(size.room, room.name) != 0) return;
  const auto& [orbits, bounces, only] = size;
  const flatray::OrbitTracer exact(room.walls, room.materials);
  const flatray::FastOrbits fast(exact, room.closed);
  const std::vector<flatray::OrbitStart> from = starts(orbits);
  Lengths textbook, by_lanes, exactly;
  flatray::FlightCounts counts;
  const std::vector<double> seconds = bench::compare(
      {{"textbook",
        [&] {
          textbook = {};
          for (const flatray::OrbitStart& start : from) {
            const flatray::Ray& ray = start.ray;
            bench::textbook::Particle p{ray.origin.x(), ray.origin.y(), ray.direction.x(),
                                        ray.direction.y()};
            for (std::uint64_t k = 0; k < bounces; ++k) {
              const double flown = Textbook().bounce(p);
              if (flown == 0) break;
              textbook.length += flown;
              ++textbook.bounces;
            }
          }
        }},
       {"fast", [&] { by_lanes = {}, counts = fast.follow(from, bounces, by_lanes); }},
       {"exact", [&] { exactly = {}, exact.follow(from, bounces, exactly); }}},
      7, 0.02);
  const auto ns = [&](std::size_t which, const Lengths& sum) {
    return 1e9 * seconds[which] / sum.bounces;
  };
  const double plain = ns(0, textbook);
  fmt::print(
      "| {:11} | {:6.2f} | {:6.2f} | {:5.2f} | {:7.1f} | {:6.1f} | {:8.2g} | {:.6f} / {:.6f} / "
      "{:.6f} |\n",
      room.name, plain, ns(1, by_lanes), ns(1, by_lanes) / plain, ns(2, exactly),
      ns(2, exactly) / plain,
      static_cast<double>(counts.exact) / static_cast<double>(counts.flights),
      textbook.length / textbook.bounces, by_lanes.length / by_lanes.bounces,
      exactly.length / exactly.bounces);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  Size size;
  if (count >= 3)
    size = {std::strtoull(arguments[1], nullptr, 10), std::strtoull(arguments[2], nullptr, 10)};
  if (count == 4) size.room = arguments[3];
  fmt::print(
      "\nNanoseconds a bounce on one thread, medians of rounds in turn; {} orbits of {} bounces.\n"
      "| room | textbook | fast | x | exact | x | flights asked exactly | mean flight, each |\n"
      "|---|---|---|---|---|---|---|---|\n",
      size.orbits, size.bounces);
  using namespace bench;
  compare<textbook::Square>({"square", box(), true}, size);
  compare<textbook::Sinai>({"Sinai", with_disc(box()), true}, size);
  compare<textbook::Stadium>({"stadium", stadium(), true}, size);
  compare<textbook::Lorentz>({"Lorentz", with_disc(box()), true, 4}, size);
  compare<textbook::Ellipse>({"ellipse", ellipse(), true}, size);
  size.orbits *= 64;  // that soon leave
  compare<textbook::ThreeDiscs>({"three discs", three_discs(), false}, size);
}
