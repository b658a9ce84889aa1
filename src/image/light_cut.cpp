#include "image/light_cut.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace flatray {
namespace {

constexpr int kTile = kernels::kLightTile;
constexpr double kUnitsOfPixel = 65536;
// Stands for the slope of a line that never leaves its row: the quotient stays a float.
constexpr double kLeastSlope = 0x1p-100;

int tiles_along(int pixels) { return (pixels + kTile - 1) / kTile; }

// Pieces of one line, at most: two in each tile along its major axis.
std::size_t most_pieces(int width, int height) {
  return 2 * static_cast<std::size_t>(tiles_along(std::max(width, height)) + 1);
}

bool in_range(const LightLine& line) {
  const bool finite = std::isfinite(line.from_x) && std::isfinite(line.from_y) &&
                      std::isfinite(line.to_x) && std::isfinite(line.to_y);
  return finite && std::all_of(line.weight.begin(), line.weight.end(),
                               [](float weight) { return weight >= 0 && weight <= 1; });
}

}  // namespace

// A line as a function of its major axis: v = v_at + slope * (u - u_at), 0 <= slope <= 1, for u in
// [from, to]. Where it falls as u rises, u counts backwards from the film's first pixel: tile -1 - t
// for tile t.
struct LightBins::Walk {
  bool steep, backwards;
  double u_at, v_at, slope, from, to;
  int tiles_v;
  kernels::LightPiece piece;  // slope, run, units

  double v(double u) const { return v_at + slope * (u - u_at); }
  double u(double v) const { return u_at + (v - v_at) / slope; }
};

LightBins::LightBins(int width, int height, std::size_t capacity)
    : width_(width),
      height_(height),
      tiles_x_(tiles_along(width)),
      tiles_y_(tiles_along(height)),
      chunks_(chunks(width, height, capacity)),
      pool_(std::make_unique_for_overwrite<kernels::LightPiece[]>(chunks_ * kChunk)),
      before_(chunks_),
      ends_(kBinsOfTile * static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>(tiles_y_)) {
}

// Every bin may have a chunk begun, and a line is cut only if each of its pieces could begin one.
std::size_t LightBins::chunks(int width, int height, std::size_t capacity) {
  const std::size_t bins = kBinsOfTile * static_cast<std::size_t>(tiles_along(width)) *
                           static_cast<std::size_t>(tiles_along(height));
  return capacity / kChunk + bins + most_pieces(width, height);
}

std::uint64_t LightBins::bytes(int width, int height, std::size_t capacity) {
  const std::uint64_t all = chunks(width, height, capacity);
  return all * (kChunk * sizeof(kernels::LightPiece) + 2 * sizeof(std::uint32_t));
}

void LightBins::clear() {
  std::fill(ends_.begin(), ends_.end(), 0);
  used_ = 0;
}

std::size_t LightBins::cut(std::span<const LightLine> lines) {
  const std::size_t last = chunks_ - most_pieces(width_, height_);
  std::size_t done = 0;
  for (; done < lines.size() && used_ <= last; ++done) cut(lines[done]);
  return done;
}

void LightBins::cut(const LightLine& line) {
  FLATRAY_CHECK(in_range(line));
  // Of halves, as the difference of the largest doubles is none.
  const double dx = std::fabs(line.to_x / 2 - line.from_x / 2);
  const double dy = std::fabs(line.to_y / 2 - line.from_y / 2);
  Walk walk;
  walk.steep = dy > dx;
  double u0 = line.from_x, v0 = line.from_y, u1 = line.to_x, v1 = line.to_y;
  if (walk.steep) std::swap(u0, v0), std::swap(u1, v1);
  if (v1 < v0 || (v1 == v0 && u1 < u0)) std::swap(u0, u1), std::swap(v0, v1);
  walk.backwards = u1 < u0;
  if (walk.backwards) u0 = -u0, u1 = -u1;
  const double du = std::max(dx, dy);
  if (du == 0) return;
  walk.slope = std::min(dx, dy) / du;

  // The end nearer to the film tells best where the line is.
  const bool first =
      std::max(std::fabs(u0), std::fabs(v0)) <= std::max(std::fabs(u1), std::fabs(v1));
  walk.u_at = first ? u0 : u1;
  walk.v_at = first ? v0 : v1;
  const double film_u = walk.steep ? height_ : width_, film_v = walk.steep ? width_ : height_;
  walk.tiles_v = walk.steep ? tiles_x_ : tiles_y_;
  walk.from = std::max(u0, walk.backwards ? -film_u : 0.0);
  walk.to = std::min(u1, walk.backwards ? 0.0 : film_u);
  if (!(walk.from < walk.to)) return;
  if (walk.v(walk.from) < 0) walk.from = walk.slope > 0 ? std::max(walk.from, walk.u(0)) : walk.to;
  if (walk.v(walk.to) >= film_v)
    walk.to = walk.slope > 0 ? std::min(walk.to, walk.u(film_v)) : walk.from;
  if (!(walk.from < walk.to)) return;

  const double units = kUnitsOfPixel * std::sqrt(1 + walk.slope * walk.slope);
  for (std::size_t c = 0; c < 3; ++c)
    walk.piece.units[c] = static_cast<float>(static_cast<double>(line.weight[c]) * units);
  walk.piece.slope = static_cast<float>(walk.slope);
  walk.piece.run = static_cast<float>(1 / std::max(walk.slope, kLeastSlope));
  cut_at_tiles(walk);
}

void LightBins::cut_at_tiles(const Walk& walk) {
  int tile_u = static_cast<int>(std::floor(walk.from / kTile));
  for (double from = walk.from; from < walk.to; ++tile_u) {
    const double to = std::min(walk.to, double{kTile} * (tile_u + 1));
    const double row = std::floor(walk.v(from) / kTile);
    const int tile_v = static_cast<int>(std::clamp(row, 0.0, walk.tiles_v - 1.0));
    const double border = double{kTile} * (tile_v + 1);
    double middle = to;
    if (tile_v + 1 < walk.tiles_v && walk.v(to) > border)
      middle = std::clamp(walk.u(border), from, to);
    add(walk, tile_u, tile_v, from, middle);
    add(walk, tile_u, tile_v + 1, middle, to);
    from = to;
  }
}

void LightBins::add(const Walk& walk, int tile_u, int tile_v, double from, double to) {
  const double corner_u = double{kTile} * tile_u, corner_v = double{kTile} * tile_v;
  kernels::LightPiece piece = walk.piece;
  piece.from = static_cast<float>(from - corner_u);
  piece.to = static_cast<float>(to - corner_u);
  if (!(piece.from < piece.to)) return;
  // Beyond these no row of the tile is met; a line of huge coordinates can be off by more.
  piece.minor = static_cast<float>(
      std::clamp(walk.v(corner_u) - corner_v, -double{kTile}, 2 * double{kTile}));

  const int along = walk.backwards ? -1 - tile_u : tile_u;
  const int tile = walk.steep ? along * tiles_x_ + tile_v : tile_v * tiles_x_ + along;
  const std::size_t bin = kBinsOfTile * static_cast<std::size_t>(tile) + (walk.steep ? 2 : 0) +
                          (walk.backwards ? 1 : 0);
  std::uint32_t& end = ends_[bin];
  if (end % kChunk == 0) {
    before_[used_] = end;
    end = static_cast<std::uint32_t>(used_++) * kChunk;
  }
  pool_[end++] = piece;
}

}  // namespace flatray
