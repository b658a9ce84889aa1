#include "render/still_layer.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace flatray {
namespace {

// About how many corners are scanned for the lowest items of a band.
std::size_t corners_of(const Band& band, std::size_t items) {
  constexpr std::size_t kOfOthers = 16;
  std::size_t corners = 0;
  for (std::size_t i = 0; i < items; ++i) {
    const BandItem& item = band[i];
    switch (item.part) {
      case BandItem::Part::ring:
        corners += item.count;
        break;
      case BandItem::Part::edges:
        corners += band.edges(item).size();
        break;
      case BandItem::Part::whole:
        corners += kOfOthers;
    }
  }
  return corners;
}

}  // namespace

void StillBand::keep(std::size_t items, const Tile& tile, int channels) {
  items_ = items;
  if (channels > 0) {
    Image shown(tile.width, tile.height, channels);
    develop(tile, shown);
    shown_ = std::move(shown.pixels);
  }
  const std::size_t pixels = tile.rgba.size() / 4;
  names_.resize(pixels);
  lights_.clear();
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* const rgba = tile.rgba.data() + 4 * i;
    if (i == 0 || std::memcmp(rgba, rgba - 4, sizeof(Light)) != 0)
      lights_.push_back({rgba[0], rgba[1], rgba[2], rgba[3]});
    names_[i] = static_cast<std::uint32_t>(lights_.size() - 1);
  }
  lights_.shrink_to_fit();
}

void StillBand::copy_light(float* rgba) const {
  for (std::size_t i = 0; i < names_.size(); ++i, rgba += 4) std::copy_n(light(i).data(), 4, rgba);
}

void StillLayer::follow(const Bands& bands, const std::vector<BandChange>& changes) {
  bands_.resize(bands.count());
  wanted_.assign(bands.count(), 0);
  still_before_.resize(bands.count());
  std::uint64_t room = kMostBytes;
  const auto size_of = [&](std::size_t band) {
    const PixelBox box = bands.box(band);
    return kPixelBytes * static_cast<std::uint64_t>(box.width) *
           static_cast<std::uint64_t>(box.height);
  };
  for (std::size_t i = 0; i < bands.count(); ++i) {
    if (bands_[i].items() > changes[i].still) bands_[i].drop();
    if (bands_[i].items() > 0) room -= std::min(room, size_of(i));
  }
  Band band;
  for (std::size_t i = 0; i < bands.count(); ++i) {
    const std::size_t still = changes[i].still, kept = bands_[i].items();
    const bool lasts = still <= std::exchange(still_before_[i], still);
    if (!lasts || changes[i].unchanged || still <= kept) continue;
    constexpr std::size_t kFewestCorners = 64;  // less is as soon drawn as looked up
    bands.list(i, band);
    const std::size_t corners = corners_of(band, still);
    if (corners < kFewestCorners || corners < 2 * corners_of(band, kept)) continue;
    const std::uint64_t more = kept > 0 ? 0 : size_of(i);
    if (more > room) continue;
    room -= more;
    wanted_[i] = still;
  }
}

}  // namespace flatray
