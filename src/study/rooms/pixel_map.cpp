#include "study/rooms/pixel_map.h"

#include <cmath>

#include "anim/rays.h"
#include "base/portable_math.h"
#include "study/rooms/followed.h"
#include "study/statistics/blocks.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

using Kind = PixelOutcome::Kind;
constexpr std::size_t kColumns = 9;
constexpr double kHalfTurn = 0x1.921fb54442d18p+1;

// Orbits of one block. Places that are solid start none.
class Outcomes : public OrbitSink {
 public:
  void add(const std::optional<OrbitStart>& start) {
    pixels_.emplace_back();
    if (!start) return;
    starts_.push_back(*start);
    numbers_.push_back(pixels_.size() - 1);
  }
  const std::vector<OrbitStart>& starts() const { return starts_; }
  // Once all are followed.
  void append_to(Numbers& all) const {
    for (const PixelOutcome& pixel : pixels_)
      all.insert(all.end(), {static_cast<double>(pixel.kind), static_cast<double>(pixel.bounces),
                             static_cast<double>(pixel.surface), pixel.length, pixel.out.x(),
                             pixel.out.y(), pixel.at.x(), pixel.at.y(), pixel.way});
  }

  void bounce(std::size_t number, const Bounce& bounce) override {
    PixelOutcome& pixel = pixels_[numbers_[number]];
    ++pixel.bounces;
    pixel.surface = bounce.surface;
    pixel.length = pixel.way = bounce.path_length;
    pixel.at = bounce.point;
  }
  void end(std::size_t number, const OrbitStop& stop) override {
    PixelOutcome& pixel = pixels_[numbers_[number]];
    pixel.out = stop.out;
    const Vec2 from = pixel.bounces > 0 ? pixel.at : starts_[number].ray.origin;
    pixel.kind = stop.end == OrbitEnd::limit      ? Kind::limit
                 : stop.end == OrbitEnd::escape   ? Kind::escape
                 : stop.end == OrbitEnd::absorbed ? Kind::absorbed
                                                  : Kind::corner;
    if (stop.end_surfaces.empty()) return;
    pixel.surface = stop.end_surfaces.front();
    pixel.at = stop.end_point;
    pixel.way += std::sqrt((pixel.at - from).squaredNorm());
  }

 private:
  std::vector<PixelOutcome> pixels_;
  std::vector<OrbitStart> starts_;
  std::vector<std::size_t> numbers_;  // pixel of each start
};

PixelOutcome outcome(std::span<const double> nine) {
  return {static_cast<Kind>(nine[0]),
          static_cast<std::uint32_t>(nine[1]),
          static_cast<std::uint32_t>(nine[2]),
          nine[3],
          {nine[4], nine[5]},
          {nine[6], nine[7]},
          nine[8]};
}

// Blocks of a pilot are not those of the run.
class OnlyStops : public RunMonitor {
 public:
  explicit OnlyStops(const ExperimentContext& of) : of_(of) {}
  bool stopped() override { return of_.stopped(); }

 private:
  const ExperimentContext& of_;
};

// The place of a pixel that is so far across and down in it.
UnitPoint in_pixel(const Film& film, std::uint64_t pixel, double across, double down) {
  const auto width = static_cast<std::uint64_t>(film.width);
  const std::uint64_t row = pixel / width, column = pixel % width;
  return {(static_cast<double>(column) + across) / film.width,
          (static_cast<double>(row) + down) / film.height};
}

}  // namespace

PlaceStarts::PlaceStarts(const ExperimentContext& context, const Room& room, PixelMap usual)
    : room_(room), map_(context.map == PixelMap::usual ? usual : context.map) {
  const std::vector<RayState> rays = ray_states(room.scene(), room.state());
  ray_ = rays.empty() ? Ray{window_.centre(), {1, 0}} : rays.front().start;
  ray_.direction = unit(ray_.direction);
}

std::optional<OrbitStart> PlaceStarts::operator[](const UnitPoint& place) const {
  const auto [x, y] = place;
  const Vec2 size = window_.size(), &d = ray_.direction;
  Ray start{{window_.low.x() + x * size.x(), window_.high.y() - y * size.y()}, d};
  if (map_ != PixelMap::position) {
    const double angle = (0.5 - y) * kHalfTurn;
    const double c = portable::cos(angle), s = portable::sin(angle);
    start = {ray_.origin + (x - 0.5) * size.x() * Vec2(d.y(), -d.x()),
             {c * d.x() - s * d.y(), c * d.y() + s * d.x()}};
  }
  if (!room_.is_free(start.origin)) return std::nullopt;
  return OrbitStart{start};
}

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
  return {drawn_unit(seed, number, 0), drawn_unit(seed, number, 1)};
}

Result<std::vector<PixelOutcome>> trace_outcomes(
    const ExperimentContext& context, const Room& room, std::uint64_t bounces, std::uint64_t count,
    std::uint64_t exact, const std::function<std::optional<OrbitStart>(std::uint64_t)>& start) {
  const Blocks blocks{count, 1024};
  auto found = run_blocks(context, blocks.count(), [&](std::size_t block) {
    Outcomes first, others;
    for (std::uint64_t i = blocks.begin(block); i < blocks.end(block); ++i) {
      auto one = start(i);
      if (one) one->chance = chance_of_orbit(context.seed, i);
      (i < exact ? first : others).add(one);
    }
    room.orbits().follow(first.starts(), bounces, first);
    follow_starts(context, room, others.starts(), bounces, others);
    Numbers all;
    for (const Outcomes* some : {&first, &others}) some->append_to(all);
    return all;
  });
  if (!found) return tl::unexpected(found.error());
  std::vector<PixelOutcome> outcomes;
  for (const Numbers& block : *found)
    for (std::size_t i = 0; i < block.size(); i += kColumns)
      outcomes.push_back(outcome(std::span(block).subspan(i, kColumns)));
  return outcomes;
}

Result<std::vector<PixelOutcome>> trace_pilot(const ExperimentContext& context, const Room& room,
                                              std::uint64_t bounces, std::uint64_t count) {
  constexpr std::uint64_t kPilotStarts = std::uint64_t{1} << 40;  // numbers that no run uses
  OnlyStops monitor(context);
  ExperimentContext pilot = context;
  pilot.monitor = &monitor;
  if (pilot.precision == OrbitPrecision::certified) pilot.precision = OrbitPrecision::exact;
  return trace_outcomes(pilot, room, bounces, count, 0, [&](std::uint64_t i) {
    return room.draw_start(context.seed, kPilotStarts + i);
  });
}

Plot pixel_plot(const ExperimentContext& context, const Room& room, PixelMap usual,
                const std::function<LinearRgb(std::size_t)>& colour) {
  const bool by_angle = (context.map == PixelMap::usual ? usual : context.map) == PixelMap::angle;
  const Film& film = context.scene.film;
  const Bounds& window = room.state().window;
  const double half = 0.5 * window.size().x();
  Plot plot{"", "x of the start, world units", "y of the start, world units"};
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
  const std::uint64_t count = pixel_count(film);
  const PlaceStarts starts(context, room, usual);
  return trace_outcomes(context, room, bounces, count, count,
                        [&](std::uint64_t pixel) { return starts[pixel_centre(film, pixel)]; });
}

}  // namespace flatray
