#include "trace/cell_raster.h"

#include <array>

#include "base/parallel.h"

namespace flatray {
namespace {

constexpr std::uint8_t kLongestSide = 127;
constexpr std::int32_t kRowsATask = 64;

// The square that grows from an empty cell is one larger than the least that grow from its three
// neighbours that way; beyond the raster none grows. Row by row: sides of the row before are enough.
void grow(const std::uint32_t* words, std::size_t stride, const Raster& raster, int quadrant,
          std::uint8_t* sides) {
  const bool left = quadrant % 2 == 1, down = quadrant / 2 == 1;
  const auto columns = static_cast<std::size_t>(raster.columns);
  for (std::int32_t i = 0; i < raster.rows; ++i) {
    const auto row = static_cast<std::size_t>(down ? i : raster.rows - 1 - i);
    const std::uint32_t* cells = words + row * stride;
    std::uint8_t* here = sides + row * columns;
    const std::uint8_t* before = i == 0 ? nullptr : down ? here - columns : here + columns;
    std::uint8_t beside = 0, across = 0;  // of the cell looked at before, and beyond it
    for (std::size_t k = 0; k < columns; ++k) {
      const std::size_t column = left ? k : columns - 1 - k;
      const std::uint8_t beyond = before == nullptr ? std::uint8_t{0} : before[column];
      const std::uint8_t least = std::min({beside, across, beyond});
      const bool empty = (cells[column] & kEmptyCell) != 0;
      beside = static_cast<std::uint8_t>(empty ? std::min(least + 1, int{kLongestSide}) : 0);
      here[column] = beside;
      across = beyond;
    }
  }
}

}  // namespace

void mark_empty(std::uint32_t* words, std::size_t stride, const Raster& raster, unsigned threads) {
  const auto columns = static_cast<std::size_t>(raster.columns);
  std::array<std::vector<std::uint8_t>, 4> sides;
  parallel_for(4, threads, [&](std::size_t quadrant) {
    sides[quadrant].resize(columns * static_cast<std::size_t>(raster.rows));
    grow(words, stride, raster, static_cast<int>(quadrant), sides[quadrant].data());
  });
  const std::int32_t tasks = (raster.rows + kRowsATask - 1) / kRowsATask;
  parallel_for(static_cast<std::size_t>(tasks), threads, [&](std::size_t task) {
    const auto first = static_cast<std::int32_t>(task) * kRowsATask;
    for (std::int32_t row = first; row < std::min(first + kRowsATask, raster.rows); ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t at = static_cast<std::size_t>(row) * columns + column;
        std::uint32_t& word = words[static_cast<std::size_t>(row) * stride + column];
        if ((word & kEmptyCell) == 0) continue;
        for (std::size_t quadrant = 0; quadrant < 4; ++quadrant)
          word |= std::uint32_t{sides[quadrant][at]} << (7 * quadrant);
      }
  });
}

}  // namespace flatray
