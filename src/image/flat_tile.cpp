#include "image/flat_tile.h"

#include <cstring>

#include "image/develop_pixel.h"

namespace flatray {
namespace {

using Shown = std::array<std::uint8_t, 4>;

constexpr int kGroup = 16;  // pixels of a run taken together

// The end of the pixels from `i` on that share a name. The compiler does not widen this at -O2.
int run_end(const std::uint32_t* names, int i, int count) {
  typedef std::uint32_t Four __attribute__((vector_size(16)));
  const std::uint32_t name = names[i];
  const Four same = {name, name, name, name};
  for (; i + kGroup <= count; i += kGroup) {
    Four v[kGroup / 4];
    std::memcpy(v, names + i, sizeof v);
    const Four other = (v[0] ^ same) | (v[1] ^ same) | (v[2] ^ same) | (v[3] ^ same);
    std::uint64_t halves[2];
    std::memcpy(halves, &other, sizeof halves);
    if ((halves[0] | halves[1]) != 0) break;
  }
  while (i < count && names[i] == name) ++i;
  return i;
}

template <int kChannels>
std::uint8_t* put_run(const Shown& shown, int count, std::uint8_t* out) {
  std::uint8_t group[kGroup * kChannels];
  for (int i = 0; i < kGroup; ++i) std::memcpy(group + kChannels * i, shown.data(), kChannels);
  for (; count >= kGroup; count -= kGroup, out += sizeof group)
    std::memcpy(out, group, sizeof group);
  for (; count > 0; --count, out += kChannels) std::memcpy(out, shown.data(), kChannels);
  return out;
}

// A pixel that is not the last of its row may be written with four bytes: the next one follows.
template <int kChannels>
void show_row(const Shown* shown, const std::uint32_t* names, int count, std::uint8_t* out) {
  int i = 0;
  while (i + 1 < count) {
    if (names[i] != names[i + 1]) {
      std::memcpy(out, &shown[names[i]], 4);
      out += kChannels;
      ++i;
      continue;
    }
    const int end = run_end(names, i, count);
    out = put_run<kChannels>(shown[names[i]], end - i, out);
    i = end;
  }
  if (i < count) std::memcpy(out, &shown[names[i]], kChannels);
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
