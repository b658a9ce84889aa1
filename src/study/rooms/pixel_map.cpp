#include "study/rooms/pixel_map.h"

#include "anim/rays.h"
#include "base/philox.h"
#include "base/portable_math.h"
#include "study/statistics/blocks.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

using Kind = PixelOutcome::Kind;
constexpr std::size_t kColumns = 6;
constexpr double kHalfTurn = 0x1.921fb54442d18p+1;

// Pixels of one block. Solid ones start no orbit.
class Outcomes : public OrbitSink {
 public:
  explicit Outcomes(const Room& room) : room_(room) {}

  void add(const Ray& start) {
    const Solids& solids = room_.solids();
    const bool free = !solids.holder(start.origin) && solids.in_chamber(start.origin);
    pixels_.emplace_back();
    if (!free) return;
    starts_.push_back({start});
    numbers_.push_back(pixels_.size() - 1);
  }
  Numbers follow(std::uint64_t bounces) {
    room_.orbits().follow(starts_, bounces, *this);
    Numbers all;
    for (const PixelOutcome& pixel : pixels_)
      all.insert(all.end(),
                 {static_cast<double>(pixel.kind), static_cast<double>(pixel.bounces),
                  static_cast<double>(pixel.surface), pixel.length, pixel.out.x(), pixel.out.y()});
    return all;
  }

  void bounce(std::size_t number, const Bounce& bounce) override {
    PixelOutcome& pixel = pixels_[numbers_[number]];
    ++pixel.bounces;
    pixel.surface = bounce.surface;
    pixel.length = bounce.path_length;
  }
  void end(std::size_t number, const OrbitStop& stop) override {
    PixelOutcome& pixel = pixels_[numbers_[number]];
    pixel.out = stop.out;
    pixel.kind = stop.end == OrbitEnd::limit    ? Kind::limit
                 : stop.end == OrbitEnd::escape ? Kind::escape
                                                : Kind::absorbed;
    if (pixel.kind == Kind::absorbed) pixel.surface = stop.surfaces.front();
  }

 private:
  const Room& room_;
  std::vector<PixelOutcome> pixels_;
  std::vector<OrbitStart> starts_;
  std::vector<std::size_t> numbers_;  // pixel of each start
};

PixelOutcome outcome(std::span<const double> six) {
  return {static_cast<Kind>(six[0]),
          static_cast<std::uint32_t>(six[1]),
          static_cast<std::uint32_t>(six[2]),
          six[3],
          {six[4], six[5]}};
}

// Starts of the places of a picture.
class PlaceStarts {
 public:
  PlaceStarts(const Room& room, PixelMap map) : window_(room.state().window), map_(map) {
    const std::vector<RayState> rays = ray_states(room.scene(), room.state());
    ray_ = rays.empty() ? Ray{window_.centre(), {1, 0}} : rays.front().start;
    ray_.direction = unit(ray_.direction);
  }
  Ray operator[](const UnitPoint& place) const {
    const auto [x, y] = place;
    const Vec2 size = window_.size(), &d = ray_.direction;
    if (map_ == PixelMap::position)
      return {{window_.low.x() + x * size.x(), window_.high.y() - y * size.y()}, d};
    const double angle = (0.5 - y) * kHalfTurn;
    const double c = portable::cos(angle), s = portable::sin(angle);
    return {ray_.origin + (x - 0.5) * size.x() * Vec2(d.y(), -d.x()),
            {c * d.x() - s * d.y(), c * d.y() + s * d.x()}};
  }

 private:
  const Bounds& window_;
  PixelMap map_;
  Ray ray_;
};

// The place of a pixel that is so far across and down in it.
UnitPoint in_pixel(const Film& film, std::uint64_t pixel, double across, double down) {
  const auto width = static_cast<std::uint64_t>(film.width);
  return {(static_cast<double>(pixel % width) + across) / film.width,
          (static_cast<double>(pixel / width) + down) / film.height};
}

}  // namespace

std::uint64_t pixel_count(const Film& film) {
  return static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
}

UnitPoint pixel_centre(const Film& film, std::uint64_t pixel) {
  return in_pixel(film, pixel, 0.5, 0.5);
}

UnitPoint drawn_in_pixel(const Film& film, std::uint64_t pixel, std::uint64_t seed) {
  const UnitPoint in = drawn_place(seed, pixel);
  return in_pixel(film, pixel, in.x, in.y);
}

UnitPoint drawn_place(std::uint64_t seed, std::uint64_t number) {
  const auto draw = [&](std::uint32_t which) {
    return unit_double(random_bits(seed, Stream::experiment, number >> 32, number, which));
  };
  return {draw(0), draw(1)};
}

Result<std::vector<PixelOutcome>> trace_places(
    const ExperimentContext& context, const Room& room, std::uint64_t bounces, PixelMap usual,
    std::uint64_t count, const std::function<UnitPoint(std::uint64_t)>& place) {
  const PlaceStarts starts(room, context.map == PixelMap::usual ? usual : context.map);
  const Blocks blocks{count, 1024};
  auto found = run_blocks(context, blocks.count(), [&](std::size_t block) {
    Outcomes outcomes(room);
    for (std::uint64_t i = blocks.begin(block); i < blocks.end(block); ++i)
      outcomes.add(starts[place(i)]);
    return outcomes.follow(bounces);
  });
  if (!found) return tl::unexpected(found.error());
  std::vector<PixelOutcome> outcomes;
  for (const Numbers& block : *found)
    for (std::size_t i = 0; i < block.size(); i += kColumns)
      outcomes.push_back(outcome(std::span(block).subspan(i, kColumns)));
  return outcomes;
}

Plot pixel_plot(const ExperimentContext& context, const Room& room, PixelMap usual,
                const std::function<Light(std::size_t)>& colour) {
  const bool by_angle = (context.map == PixelMap::usual ? usual : context.map) == PixelMap::angle;
  const Film& film = context.scene.film;
  const Bounds& window = room.state().window;
  const double half = 0.5 * window.size().x();
  Plot plot{"", "x of the start, world units", "y of the start, world units", {}};
  if (by_angle) {
    plot.x_label = "start on the line across the ray, world units from it";
    plot.y_label = "angle to the ray, degrees";
    plot.y_step = 30;
  }
  plot.map.emplace(Plot::Map{image_of(film.width, film.height, colour),
                             by_angle ? Bounds{{-half, -90}, {half, 90}} : window});
  return plot;
}

std::string bounces_text(const PixelOutcome& pixel) {
  return pixel.kind == Kind::solid ? "" : std::to_string(pixel.bounces);
}

Result<std::vector<PixelOutcome>> trace_pixels(const ExperimentContext& context, const Room& room,
                                               std::uint64_t bounces, PixelMap usual) {
  const Film& film = context.scene.film;
  return trace_places(context, room, bounces, usual, pixel_count(film),
                      [&](std::uint64_t pixel) { return pixel_centre(film, pixel); });
}

}  // namespace flatray
