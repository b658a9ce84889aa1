#include "image/light_cut.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace flatray {
using kernels::kLightTile;
namespace {

constexpr double kUnitsOfPixel = 65536;
// Stands for the slope of a line that never leaves its row: the quotient stays a float.
constexpr double kLeastSlope = 0x1p-100;

// Pieces of one line, at most: two in each tile along its major axis.
std::size_t most_pieces(int width, int height) {
  return 2 * static_cast<std::size_t>(tiles_along(std::max(width, height)) + 1);
}

int floor_of(double value) {
  const int whole = static_cast<int>(value);
  return whole - (whole > value ? 1 : 0);
}

// No branches: they cost more than what they leave out.
bool in_range(const LightLine& line) {
  const double none = (line.from_x - line.from_x) + (line.from_y - line.from_y) +
                      (line.to_x - line.to_x) + (line.to_y - line.to_y);
  const auto& [red, green, blue] = line.weight;
  return (none == 0) & (red >= 0) & (green >= 0) & (blue >= 0) & (red <= 1) & (green <= 1) &
         (blue <= 1);
}

// A line as a function of its major axis: v = v_at + slope * (u - u_at), 0 <= slope <= 1, for u in
// [from, to]. Where v falls as u rises, u counts backwards from the film's first pixel: tile -1 - t
// for tile t.
struct Walk {
  std::size_t steep, backwards;
  double u_at, v_at, slope, from, to;

  double v(double u) const { return v_at + slope * (u - u_at); }
  double u(double v) const { return u_at + (v - v_at) / slope; }
};

// The part of a line on the film; none has from >= to.
inline Walk walk_on_film(const LightLine& line, const double (&size)[2]) {
  // Of halves, as the difference of the largest doubles is none.
  const double dx = std::fabs(line.to_x / 2 - line.from_x / 2);
  const double dy = std::fabs(line.to_y / 2 - line.from_y / 2);
  const double length = std::max(dx, dy);
  // Which way a line goes is anyone's guess: by index, as branches would be guessed wrong.
  const double ends[2][2] = {{line.from_x, line.from_y}, {line.to_x, line.to_y}};
  const std::size_t major = dy > dx ? 1 : 0, minor = 1 - major;
  const double rise = ends[1][minor] - ends[0][minor], along = ends[1][major] - ends[0][major];
  const std::size_t low = (rise < 0) | ((rise == 0) & (along < 0)) ? 1 : 0, high = 1 - low;
  const std::size_t backwards = ends[high][major] < ends[low][major] ? 1 : 0;
  constexpr double kSign[2] = {1, -1};
  const double u[2] = {kSign[backwards] * ends[low][major], kSign[backwards] * ends[high][major]};
  const double v[2] = {ends[low][minor], ends[high][minor]};
  // The end nearer to the film tells best where the line is.
  const auto far = [&](std::size_t end) { return std::max(std::fabs(u[end]), std::fabs(v[end])); };
  const std::size_t near = far(0) <= far(1) ? 0 : 1;
  const double shift = -static_cast<double>(backwards) * size[major];
  Walk walk = {major,
               backwards,
               u[near],
               v[near],
               std::min(dx, dy) / length,
               std::max(u[0], shift),
               std::min(u[1], size[major] + shift)};
  if (length == 0) walk.to = walk.from;  // shorter than the least double has no slope
  if (!(walk.from < walk.to)) return walk;
  if (walk.v(walk.from) < 0) walk.from = walk.slope > 0 ? std::max(walk.from, walk.u(0)) : walk.to;
  if (walk.v(walk.to) >= size[minor])
    walk.to = walk.slope > 0 ? std::min(walk.to, walk.u(size[minor])) : walk.from;
  return walk;
}

// Calls add(tile along u, tile along v, from, to) for the part of the walk in each tile.
template <class Add>
inline void each_tile(const Walk& walk, int tiles_v, const Add& add) {
  int tile_u = floor_of(walk.from / kLightTile);
  for (double from = walk.from; from < walk.to; ++tile_u) {
    const double to = std::min(walk.to, static_cast<double>(kLightTile * (tile_u + 1)));
    const int tile_v = static_cast<int>(std::clamp(walk.v(from) / kLightTile, 0.0, tiles_v - 1.0));
    const auto border = static_cast<double>(kLightTile * (tile_v + 1));
    if (tile_v + 1 < tiles_v && walk.v(to) > border) {
      const double middle = std::clamp(walk.u(border), from, to);
      add(tile_u, tile_v, from, middle);
      add(tile_u, tile_v + 1, middle, to);
    } else {
      add(tile_u, tile_v, from, to);
    }
    from = to;
  }
}

inline kernels::LightPiece whole_piece(const LightLine& line, double slope) {
  const double units = kUnitsOfPixel * std::sqrt(1 + slope * slope);
  kernels::LightPiece piece;
  for (std::size_t c = 0; c < 3; ++c)
    piece.units[c] = static_cast<float>(static_cast<double>(line.weight[c]) * units);
  piece.slope = static_cast<float>(slope);
  piece.run = static_cast<float>(1 / std::max(slope, kLeastSlope));
  return piece;
}

}  // namespace

LightBins::LightBins(int width, int height, std::size_t capacity)
    : size_{static_cast<double>(width), static_cast<double>(height)},
      tiles_{tiles_along(width), tiles_along(height)},
      chunks_(chunks(width, height, capacity)),
      most_pieces_(most_pieces(width, height)),
      pool_(std::make_unique_for_overwrite<kernels::LightPiece[]>(chunks_ * kChunk)),
      before_(chunks_),
      ends_(kBinsOfTile * static_cast<std::size_t>(tiles_[0]) *
            static_cast<std::size_t>(tiles_[1])) {}

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
  std::size_t done = 0;
  for (; done < lines.size() && used_ + most_pieces_ <= chunks_; ++done) cut(lines[done]);
  return done;
}

inline void LightBins::cut(const LightLine& line) {
  FLATRAY_CHECK(in_range(line));
  const Walk walk = walk_on_film(line, size_);
  if (!(walk.from < walk.to)) return;
  kernels::LightPiece piece = whole_piece(line, walk.slope);
  each_tile(walk, tiles_[1 - walk.steep], [&](int tile_u, int tile_v, double from, double to) {
    const auto corner_u = static_cast<double>(kLightTile * tile_u);
    const auto corner_v = static_cast<double>(kLightTile * tile_v);
    piece.from = static_cast<float>(from - corner_u);
    piece.to = static_cast<float>(to - corner_u);
    if (!(piece.from < piece.to)) return;
    // Beyond these no row of the tile is met; a line of huge coordinates can be off by more.
    piece.minor = static_cast<float>(
        std::clamp<double>(walk.v(corner_u) - corner_v, -kLightTile, 2 * kLightTile));
    const int along = walk.backwards != 0 ? -1 - tile_u : tile_u;
    const int tile = walk.steep != 0 ? along * tiles_[0] + tile_v : tile_v * tiles_[0] + along;
    add(kBinsOfTile * static_cast<std::size_t>(tile) + 2 * walk.steep + walk.backwards, piece);
  });
}

inline void LightBins::add(std::size_t bin, const kernels::LightPiece& piece) {
  std::uint32_t& end = ends_[bin];
  if (end % kChunk == 0) {
    FLATRAY_DCHECK(used_ < chunks_);
    before_[used_] = end;
    end = static_cast<std::uint32_t>(used_++) * kChunk;
  }
  pool_[end++] = piece;
}

}  // namespace flatray
