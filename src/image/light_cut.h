#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "image/kernels/light_kernels.h"

namespace flatray {

/// Tiles in a row or column of so many pixels.
inline int tiles_along(int pixels) {
  return (pixels + kernels::kLightTile - 1) / kernels::kLightTile;
}

/// A straight part of a light path on the film: in pixels, x to the right, y down, pixel (i, j)
/// covers [i, i + 1) x [j, j + 1).
struct LightLine {
  double from_x, from_y, to_x, to_y;
  std::array<float, 3> weight;  ///< of each channel, in units of the largest: [0, 1]
};

/// Lines cut at the film and at its tiles, the pieces binned by tile, major axis and direction.
///
/// Error   a piece is part of a line whose ends are moved by less than 2^-50 of the line's largest
///         coordinate; then all of it is moved along its minor axis by less than 2^-16 pixels, and its
///         ends along its major axis by less than 2^-17, as it is kept in floats.
class LightBins {
 public:
  /// Of a tile: major axis x or y, the direction in which it rises with the minor axis.
  static constexpr std::size_t kBinsOfTile = 4;

  /// Needs   a film of at least one pixel; room for `capacity` pieces is kept.
  LightBins(int width, int height, std::size_t capacity);
  static std::uint64_t bytes(int width, int height, std::size_t capacity);

  /// Cuts lines, the first first, until all are cut or the room is used.
  /// Needs   finite coordinates, weights in [0, 1].
  /// Gives   how many were cut, at least one if there are any and the bins were empty.
  std::size_t cut(std::span<const LightLine> lines);
  void clear();

  /// Calls `use(std::span<const kernels::LightPiece>)` for the pieces of one bin, a part at a time.
  template <class Use>
  void pieces(std::size_t bin, const Use& use) const {
    for (std::uint32_t end = ends_[bin]; end != 0;) {
      const std::uint32_t chunk = (end - 1) / kChunk;
      use(std::span<const kernels::LightPiece>(&pool_[chunk * kChunk], end - chunk * kChunk));
      end = before_[chunk];
    }
  }

 private:
  static constexpr std::uint32_t kChunk = 128;

  static std::size_t chunks(int width, int height, std::size_t capacity);
  void cut(const LightLine& line);
  void add(std::size_t bin, const kernels::LightPiece& piece);

  double size_[2];  // of the film: width, height
  int tiles_[2];
  std::size_t chunks_, most_pieces_, used_ = 0;
  std::unique_ptr<kernels::LightPiece[]> pool_;
  std::vector<std::uint32_t> before_;  // by chunk: the end of its bin's pieces before it, or 0
  std::vector<std::uint32_t> ends_;    // by bin: one past its last piece in the pool, or 0
};

}  // namespace flatray
