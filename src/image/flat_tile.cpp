#include "image/flat_tile.h"

#include <cstring>

#include "image/develop_pixel.h"

namespace flatray {
namespace {

using Shown = std::array<std::uint8_t, 4>;

constexpr int kGroup = 8;  // pixels looked at together

// Whether the next eight names are the same.
inline bool all_same(const std::uint32_t* names) {
  std::uint64_t pairs[kGroup / 2];
  std::memcpy(pairs, names, sizeof pairs);
  const std::uint64_t first = names[0] | std::uint64_t{names[0]} << 32;
  return ((pairs[0] ^ first) | (pairs[1] ^ first) | (pairs[2] ^ first) | (pairs[3] ^ first)) == 0;
}

// Writes a fourth byte beyond three channels: the next pixel's.
template <int kChannels>
void put_group(const Shown* shown, const std::uint32_t* names, std::uint8_t* out) {
  for (int i = 0; i < kGroup; ++i) std::memcpy(out + kChannels * i, &shown[names[i]], 4);
}

template <int kChannels>
void show_row(const Shown* shown, const std::uint32_t* names, int count, std::uint8_t* out) {
  int i = 0;
  while (i + kGroup < count) {
    if (!all_same(names + i)) {
      put_group<kChannels>(shown, names + i, out + kChannels * i);
      i += kGroup;
      continue;
    }
    std::uint64_t group[kGroup * kChannels / 8 + 1];
    put_group<kChannels>(shown, names + i, reinterpret_cast<std::uint8_t*>(group));
    const std::uint32_t name = names[i];
    bool same = true;
    while (same) {
      std::memcpy(out + kChannels * i, group, kGroup * kChannels);
      i += kGroup;
      same = i + kGroup < count && names[i] == name && all_same(names + i);
    }
  }
  for (; i < count; ++i) std::memcpy(out + kChannels * i, &shown[names[i]], kChannels);
}

template <class Kind>
void develop_as(FlatTile& tile, Image& out) {
  const SrgbEncoder& encode = SrgbEncoder::get();
  tile.shown.resize(tile.colours.size());
  for (std::size_t i = 0; i < tile.colours.size(); ++i)
    Kind::pixel(tile.colours[i].data(), encode, tile.shown[i].data());
  const std::uint32_t* names = tile.names.data();
  for (int y = 0; y < tile.height; ++y, names += tile.width)
    show_row<Kind::kChannels>(tile.shown.data(), names, tile.width, out.at(tile.x, tile.y + y));
}

}  // namespace

void develop(FlatTile& tile, Image& out) {
  if (tile.width == 0) return;
  if (out.channels == 3)
    develop_as<Opaque>(tile, out);
  else
    develop_as<Straight>(tile, out);
}

}  // namespace flatray
