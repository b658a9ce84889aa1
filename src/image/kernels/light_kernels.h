#pragma once
#include <stddef.h>
#include <stdint.h>

/// Kernels of the film of light, one table for each instruction-set tier. Plain types only: what a
/// tier compiles must not leave its file. All tiers give the same sums: a lane is one column of one
/// piece, and products, sums and roundings are done one by one.
namespace flatray::kernels {

/// Pixels of a tile along each axis.
constexpr int kLightTile = 128;
/// Places of a column of a layer: row r is place r + 1. More than the rows, as columns a power of
/// two apart would share the sets of a cache.
constexpr int kLightColumn = 132;

/// Part of a line in one tile. Its major axis u counts columns from the tile's edge where u is
/// smallest, its minor axis v counts rows; v rises by `slope` in [0, 1] a column.
struct LightPiece {
  float from, to;  ///< u, 0 <= from < to <= kLightTile
  float minor;     ///< v at u = 0
  float slope;     ///< dv / du
  float run;       ///< du / dv, a finite number where slope is 0
  float units[3];  ///< of each channel, a column
};

/// Sums of one tile and one choice of axes: (column * kLightColumn + row + 1) * channels + channel.
struct LightLayer {
  uint32_t* sums;
  int32_t first, step;  ///< column c of a piece is column first + step * c here, step 1 or -1
  float last_row;       ///< rows - 2: the last row that has one after it
};

/// Adds each piece's length in every pixel to the pixel's sums.
///
/// Gives   in each column, where `total(u)` is units * u rounded to a whole number: total(m) -
///         total(u0) to the row that the piece is in at u0, total(u1) - total(m) to the next, u0 and
///         u1 its ends in the column, m where it passes from row to row. So all columns together
///         have total(to) - total(from), whatever the slope.
struct LightKernels {
  using Deposit = void (*)(const LightPiece* pieces, size_t count, const LightLayer& layer);
  Deposit one_channel, three_channels;
};

extern const LightKernels portable_light, baseline_light, avx2_light, avx512_light;

}  // namespace flatray::kernels
