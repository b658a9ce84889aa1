#pragma once
#include <vector>

#include "image/image.h"
#include "image/pixel_runs.h"
#include "image/tile.h"
#include "render/bands.h"

namespace flatray {

/// A band as it looks with its lowest items alone, which lie still from frame to frame.
class StillBand {
 public:
  /// How many items, from the lowest up; 0 where nothing is kept.
  std::size_t items() const { return items_; }
  /// Needs   the tile at (0, 0); no `channels` where nobody asks what is shown.
  void keep(std::size_t items, const Tile& tile, int channels);
  void drop() { *this = StillBand(); }

  /// Developed, in as many channels as were asked for.
  const std::vector<std::uint8_t>& shown() const { return shown_; }
  const Light& light(std::size_t pixel) const { return lights_[names_[pixel]]; }
  /// Light of all pixels, four floats each.
  void copy_light(float* rgba) const;

 private:
  std::size_t items_ = 0;
  std::vector<std::uint8_t> shown_;
  std::vector<std::uint32_t> names_;  ///< by pixel, of its light
  std::vector<Light> lights_;         ///< neighbours share theirs
};

/// The still bands of a film, kept where that pays: drawn once, and the frames that follow begin
/// with them.
///
/// Cost    kPixelBytes for each pixel of the bands kept, 8 where neighbouring pixels are alike; bands
///         that would take more than kMostBytes together are not kept.
class StillLayer {
 public:
  static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 26;

  /// Room for a pixel whose light is not its neighbour's.
  static constexpr std::uint64_t kPixelBytes = 4 + sizeof(std::uint32_t) + sizeof(Light);

  /// Drops what no longer lies still; tells which bands are worth being kept from this frame on.
  /// Those were the same in two comparisons one after another, and something else is in the band.
  void follow(const Bands& bands, const std::vector<BandChange>& changes);
  /// How many items of a band are to be kept, before it is drawn; 0 for none.
  std::size_t wanted(std::size_t band) const { return wanted_[band]; }
  StillBand& operator[](std::size_t band) { return bands_[band]; }

 private:
  std::vector<StillBand> bands_;
  std::vector<std::size_t> wanted_, still_before_;
};

}  // namespace flatray
