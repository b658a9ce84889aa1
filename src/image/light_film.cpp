#include "image/light_film.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"

namespace flatray {
using kernels::kLightTile;
namespace {

// A piece adds at most 2^16 sqrt(2) units to a pixel, and less than 4 that are rounding's: 92 686.
// So many pieces stay below 2^32 : 46 000 * 92 686 = 4 263 556 000 < 4 294 967 296.
constexpr std::uint32_t kMostPieces = 46000;
static_assert(std::uint64_t{kMostPieces} * 92686 < std::uint64_t{1} << 32);

// Pieces cut before they are drawn, by all threads together: 32 MB.
constexpr std::size_t kPiecesAtOnce = std::size_t{1} << 20;
constexpr unsigned kMostThreads = 64;
// Fewer lines are cut sooner than a thread is started.
constexpr std::size_t kLinesOfThread = 4096;

std::size_t tiles_of(int width, int height) {
  return static_cast<std::size_t>(tiles_along(width)) *
         static_cast<std::size_t>(tiles_along(height));
}
std::size_t numbers_of_layer(int channels) {
  return static_cast<std::size_t>(kLightTile * channels * kernels::kLightColumn);
}
std::size_t numbers_of_tile(int channels) {
  return static_cast<std::size_t>(kLightTile * kLightTile * channels);
}

const kernels::LightKernels& light_kernels(Isa isa) {
  static constexpr const kernels::LightKernels* kTiers[] = {
    &kernels::portable_light,
#if defined(__x86_64__)
    &kernels::baseline_light,
    &kernels::avx2_light,
    &kernels::avx512_light
#endif
  };
  return *of_tier(kTiers, isa);
}

}  // namespace

std::vector<std::int64_t> in_three_channels(std::vector<std::int64_t> sums, int channels) {
  if (channels == 3) return sums;
  std::vector<std::int64_t> all(3 * sums.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = sums[i / 3];
  return all;
}

LightFilm::LightFilm(int width, int height, int channels, Isa isa)
    : width_(width), height_(height), channels_(channels), tiles_x_(tiles_along(width)) {
  FLATRAY_CHECK(width >= 1 && width <= 65536 && height >= 1 && height <= 65536);
  FLATRAY_CHECK(channels == 1 || channels == 3);
  const kernels::LightKernels& kernels = light_kernels(isa);
  deposit_ = channels == 1 ? kernels.one_channel : kernels.three_channels;
  tiles_.resize(tiles_of(width, height));
}

std::uint64_t LightFilm::bytes(int width, int height, int channels, unsigned threads,
                               unsigned films) {
  const std::uint64_t of_tile = sizeof(Tile) +
                                2 * sizeof(std::uint32_t) * numbers_of_layer(channels) +
                                sizeof(std::int64_t) * numbers_of_tile(channels);
  const unsigned cutters = std::clamp(threads, 1U, kMostThreads);
  return films * tiles_of(width, height) * of_tile +
         cutters * LightBins::bytes(width, height, kPiecesAtOnce / cutters);
}

int LightFilm::columns_of(std::size_t tile) const {
  return std::min(kLightTile, width_ - kLightTile * static_cast<int>(
                                                        tile % static_cast<std::size_t>(tiles_x_)));
}

int LightFilm::rows_of(std::size_t tile) const {
  return std::min(
      kLightTile,
      height_ - kLightTile * static_cast<int>(tile / static_cast<std::size_t>(tiles_x_)));
}

std::size_t LightFilm::place_in_layer(std::size_t axis, int column, int row, int channel) const {
  const int major = axis == 0 ? column : row, minor = axis == 0 ? row : column;
  return static_cast<std::size_t>((major * kernels::kLightColumn + minor + 1) * channels_ +
                                  channel);
}

std::size_t LightFilm::place_in_tile(int column, int row, int channel) const {
  return static_cast<std::size_t>((row * kLightTile + column) * channels_ + channel);
}

std::size_t LightFilm::place_in_film(std::size_t tile, int column, int row, int channel) const {
  const auto across = static_cast<std::size_t>(tiles_x_),
             of_tile = static_cast<std::size_t>(kLightTile);
  const std::size_t x = tile % across * of_tile + static_cast<std::size_t>(column);
  const std::size_t y = tile / across * of_tile + static_cast<std::size_t>(row);
  return (y * static_cast<std::size_t>(width_) + x) * static_cast<std::size_t>(channels_) +
         static_cast<std::size_t>(channel);
}

void LightFilm::count_lines(std::uint64_t lines) {
  FLATRAY_CHECK(lines <= kMostLines - lines_);
  lines_ += lines;
}

void LightFilm::add(std::span<const LightLine> lines, unsigned threads) {
  count_lines(lines.size());
  const std::size_t worth = 1 + lines.size() / kLinesOfThread;
  const std::size_t cutters =
      std::clamp<std::size_t>(threads, 1, std::min<std::size_t>(worth, kMostThreads));
  if (bins_.size() < cutters) {
    bins_.clear();
    for (std::size_t i = 0; i < cutters; ++i)
      bins_.emplace_back(width_, height_, kPiecesAtOnce / cutters);
  }
  std::vector<std::span<const LightLine>> shares;
  for (std::size_t i = 0; i < cutters; ++i) {
    const std::size_t begin = lines.size() * i / cutters, end = lines.size() * (i + 1) / cutters;
    shares.push_back(lines.subspan(begin, end - begin));
  }
  const auto left = [](const auto& share) { return !share.empty(); };
  while (std::ranges::any_of(shares, left)) {
    for (LightBins& bins : bins_) bins.clear();
    parallel_for(cutters, threads,
                 [&](std::size_t i) { shares[i] = shares[i].subspan(bins_[i].cut(shares[i])); });
    parallel_for(tiles_.size(), static_cast<unsigned>(cutters),
                 [&](std::size_t tile) { draw(tile); });
  }
}

void LightFilm::draw(std::size_t tile) {
  for (const LightBins& bins : bins_)
    for (std::size_t bin = 0; bin < LightBins::kBinsOfTile; ++bin)
      bins.pieces(tile * LightBins::kBinsOfTile + bin,
                  [&](Pieces pieces) { draw(tile, bin / 2, bin % 2 != 0, pieces); });
}

void LightFilm::draw(std::size_t tile, std::size_t axis, bool backwards, Pieces pieces) {
  std::vector<std::uint32_t>& layer = tiles_[tile].layer[axis];
  if (layer.empty()) layer.resize(numbers_of_layer(channels_));
  std::uint32_t& waiting = tiles_[tile].pieces[axis];
  if (waiting + pieces.size() > kMostPieces) spill(tile, axis);
  waiting += static_cast<std::uint32_t>(pieces.size());
  const int rows = axis == 0 ? rows_of(tile) : columns_of(tile);
  deposit_(pieces.data(), pieces.size(),
           {layer.data(), backwards ? kLightTile - 1 : 0, backwards ? -1 : 1,
            static_cast<float>(rows - 2)});
}

void LightFilm::spill(std::size_t tile, std::size_t axis) {
  auto& [layer, pieces, spilled] = tiles_[tile];
  spilled.resize(numbers_of_tile(channels_));
  for (int row = 0; row < rows_of(tile); ++row)
    for (int column = 0; column < columns_of(tile); ++column)
      for (int c = 0; c < channels_; ++c)
        spilled[place_in_tile(column, row, c)] += layer[axis][place_in_layer(axis, column, row, c)];
  std::fill(layer[axis].begin(), layer[axis].end(), 0);
  pieces[axis] = 0;
}

std::vector<std::int64_t> LightFilm::sums() const {
  std::vector<std::int64_t> all(static_cast<std::size_t>(width_) *
                                static_cast<std::size_t>(height_) *
                                static_cast<std::size_t>(channels_));
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    for (int row = 0; row < rows_of(tile); ++row)
      for (int column = 0; column < columns_of(tile); ++column)
        for (int c = 0; c < channels_; ++c) {
          const auto& [layer, pieces, spilled] = tiles_[tile];
          std::int64_t& sum = all[place_in_film(tile, column, row, c)];
          if (!spilled.empty()) sum += spilled[place_in_tile(column, row, c)];
          for (const std::size_t axis : {0U, 1U})
            if (!layer[axis].empty()) sum += layer[axis][place_in_layer(axis, column, row, c)];
        }
  return all;
}

void LightFilm::merge(const LightFilm& other) {
  FLATRAY_CHECK(other.width_ == width_ && other.height_ == height_ && other.channels_ == channels_);
  add_sums(other.sums(), other.lines_);
}

void LightFilm::add_sums(std::span<const std::int64_t> sums, std::uint64_t lines) {
  FLATRAY_CHECK(sums.size() == static_cast<std::size_t>(width_) *
                                   static_cast<std::size_t>(height_) *
                                   static_cast<std::size_t>(channels_));
  count_lines(lines);
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    for (int row = 0; row < rows_of(tile); ++row)
      for (int column = 0; column < columns_of(tile); ++column)
        for (int c = 0; c < channels_; ++c) {
          const std::int64_t sum = sums[place_in_film(tile, column, row, c)];
          if (sum == 0) continue;
          FLATRAY_CHECK(sum > 0 && static_cast<std::uint64_t>(sum) < lines << 17);
          tiles_[tile].spilled.resize(numbers_of_tile(channels_));
          tiles_[tile].spilled[place_in_tile(column, row, c)] += sum;
        }
}

}  // namespace flatray
