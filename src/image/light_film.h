#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/isa.h"
#include "image/light_cut.h"

namespace flatray {

/// Sums of three channels a pixel, of one whose channels are alike.
std::vector<std::int64_t> in_three_channels(std::vector<std::int64_t> sums, int channels);

/// What light has fallen on each pixel: the sum of weight times length of path inside it, as whole
/// numbers, so that sums have no order. Any order, batches and threads, and any instruction-set
/// tier, give the same sums; films of parts of the lines merge to the film of all.
///
/// Units   2^-16 of (weight 1) x (1 pixel of length).
/// Error   of one line of weight 1: a pixel has the length in it of a line moved by less than 2^-15
///         pixels, within 2 units; all pixels together its length inside the film within 2^-23 of
///         that and 2 units for each tile it crosses. A line along the border of two pixels is in
///         the right or the lower one.
/// Cost    about a nanosecond for each column, or row, that a line crosses, and 20 for each line;
///         the film of a place is allocated when light falls on it.
class LightFilm {
 public:
  /// So many lines can be added before a sum of 64 bits could overflow: each adds less than 2^17 to
  /// a pixel.
  static constexpr std::uint64_t kMostLines = std::uint64_t{1} << 46;

  /// Needs   1 to 2^16 pixels along each axis; 1 channel (the first weight of each line) or 3.
  LightFilm(int width, int height, int channels, Isa isa = active_isa());
  /// Memory of films that have light everywhere and share the room in which lines are cut.
  static std::uint64_t bytes(int width, int height, int channels, unsigned threads,
                             unsigned films = 1);

  /// Needs   finite coordinates of any size, weights in [0, 1]; kMostLines in all.
  void add(std::span<const LightLine> lines, unsigned threads = 1);
  /// Adds the light of another film of the same size and channels.
  void merge(const LightFilm& other);
  /// Takes the room in which another film of the same size cut its lines.
  void take_room(LightFilm& other) {
    if (&other != this && bins_.empty()) bins_.swap(other.bins_);
  }
  /// Adds sums as `sums()` gave them, of so many lines.
  /// Needs   none of more than 2^17 for each line.
  void add_sums(std::span<const std::int64_t> sums, std::uint64_t lines);

  /// Row by row from the top, `channels` numbers a pixel.
  std::vector<std::int64_t> sums() const;
  std::uint64_t lines() const { return lines_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }

 private:
  // What falls on one tile; lines with major axis x and those with y have sums of their own, in
  // which the minor axis is contiguous.
  struct Tile {
    std::vector<std::uint32_t> layer[2];
    std::uint32_t pieces[2] = {0, 0};   // since the layer was spilled
    std::vector<std::int64_t> spilled;  // row by row
  };
  using Pieces = std::span<const kernels::LightPiece>;

  void draw(std::size_t tile);
  void draw(std::size_t tile, std::size_t axis, bool backwards, Pieces pieces);
  void spill(std::size_t tile, std::size_t axis);
  void count_lines(std::uint64_t lines);
  int columns_of(std::size_t tile) const;
  int rows_of(std::size_t tile) const;
  std::size_t place_in_layer(std::size_t axis, int column, int row, int channel) const;
  std::size_t place_in_tile(int column, int row, int channel) const;
  std::size_t place_in_film(std::size_t tile, int column, int row, int channel) const;

  int width_, height_, channels_, tiles_x_;
  kernels::LightKernels::Deposit deposit_;
  std::uint64_t lines_ = 0;
  std::vector<Tile> tiles_;
  std::vector<LightBins> bins_;  // of each thread
};

}  // namespace flatray
