#include "study/pixel_map.h"

#include "base/portable_math.h"
#include "study/blocks.h"
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

// Starts of the pixels of a film.
class PixelStarts {
 public:
  PixelStarts(const Room& room, PixelMap map)
      : film_(room.scene().film), window_(room.state().window), map_(map) {
    const std::vector<RayPath>& rays = room.scene().rays;
    const Vec2 at = rays.empty() ? window_.centre() : world_pose(room.state())(rays.front().at);
    ray_ = {at, unit(rays.empty() ? Vec2(1, 0) : rays.front().direction)};
  }
  std::uint64_t count() const {
    return static_cast<std::uint64_t>(film_.width) * static_cast<std::uint64_t>(film_.height);
  }
  Ray operator[](std::uint64_t pixel) const {
    const auto width = static_cast<std::uint64_t>(film_.width);
    const double x = (static_cast<double>(pixel % width) + 0.5) / film_.width;
    const double y = (static_cast<double>(pixel / width) + 0.5) / film_.height;
    const Vec2 size = window_.size(), &d = ray_.direction;
    if (map_ == PixelMap::position)
      return {{window_.low.x() + x * size.x(), window_.high.y() - y * size.y()}, d};
    const double angle = (0.5 - y) * kHalfTurn;
    const double c = portable::cos(angle), s = portable::sin(angle);
    return {ray_.origin + (x - 0.5) * size.x() * Vec2(d.y(), -d.x()),
            {c * d.x() - s * d.y(), c * d.y() + s * d.x()}};
  }

 private:
  const Film& film_;
  const Bounds& window_;
  PixelMap map_;
  Ray ray_;
};

}  // namespace

Result<std::vector<PixelOutcome>> trace_pixels(const ExperimentContext& context, const Room& room,
                                               std::uint64_t bounces, PixelMap usual) {
  const PixelStarts starts(room, context.map == PixelMap::usual ? usual : context.map);
  const Blocks blocks{starts.count(), 1024};
  auto found = run_blocks(context, blocks.count(), [&](std::size_t block) {
    Outcomes outcomes(room);
    for (std::uint64_t i = blocks.begin(block); i < blocks.end(block); ++i) outcomes.add(starts[i]);
    return outcomes.follow(bounces);
  });
  if (!found) return tl::unexpected(found.error());
  std::vector<PixelOutcome> pixels;
  for (const Numbers& block : *found)
    for (std::size_t i = 0; i < block.size(); i += kColumns)
      pixels.push_back(outcome(std::span(block).subspan(i, kColumns)));
  return pixels;
}

}  // namespace flatray
