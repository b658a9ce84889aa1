#include "render/coverage/composer.h"

#include <algorithm>
#include <bit>

namespace flatray {
namespace {

// In place: where many clear items lie over one another, most of the time goes here.
void lay(const Light& above, Light& below) {
  const float keep = 1.0F - above[3];
  for (std::size_t i = 0; i < 4; ++i) below[i] = above[i] + below[i] * keep;
}

Light over(Light above, Light below, float opacity = 1) {
  for (float& part : above) part *= opacity;
  lay(above, below);
  return below;
}

// Over what is clear light is as opaque as it is bright.
Light lit(const Light& light, const Light& below) {
  return {below[0] + light[0], below[1] + light[1], below[2] + light[2],
          std::max(below[3], std::min(std::max({light[0], light[1], light[2]}), 1.0F))};
}

Light laid(const Seen& seen, const Light& below) {
  return seen.look->adds ? lit(seen.light, below) : over(seen.light, below);
}

}  // namespace

ItemLook::ItemLook(const DrawItem& of)
    : light(premultiplied(of.colour)),
      opaque(of.colour.a == 1 && of.layer == 0 && !of.light),
      adds(of.light != nullptr),
      varies(of.gradient.has_value() || of.light != nullptr),
      layer(static_cast<std::uint32_t>(of.layer)),
      item(&of) {
  if (of.gradient) gradient.emplace(*of.gradient);
  if (const FillPath* path = std::get_if<FillPath>(&of.region))
    simple = path->simple, rule = path->rule;
}

Light ItemLook::at(int x, int y, int film_width) const {
  if (gradient) return gradient->at({x + 0.5, y + 0.5});
  if (!item->light) return light;
  const float* rgb = item->light->rgb.data() +
                     3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film_width) +
                          static_cast<std::size_t>(x));
  return {rgb[0], rgb[1], rgb[2], 0};
}

std::uint32_t SeenItems::add_part(const ItemLook& look, const Light& light, int winding) {
  items.push_back({&look, winding, light});
  has_part_ = true, on_whole_ = false;
  return static_cast<std::uint32_t>(items.size() - 1);
}

void SeenItems::add_whole(const ItemLook& look, const Light& light) {
  if (look.opaque) {
    begin(light);
  } else if (items.empty() && look.layer == 0) {
    ground = laid({&look, 1, light}, ground);
  } else if (look.blends() && on_whole_) {
    items.back().light = over(light, items.back().light);
  } else {
    items.push_back({&look, 1, light});
    on_whole_ = look.blends() && has_part_;
  }
}

void SeenItems::place_all() {
  const std::size_t words = (items.size() + 63) / 64;
  inside_.resize(words), opaque_.resize(words), plain_.resize(words);
  for (std::size_t word = 0; word < words; ++word) {
    const std::size_t first = 64 * word, count = std::min<std::size_t>(items.size() - first, 64);
    std::uint64_t inside = 0, opaque = 0, plain = 0;
    for (std::size_t i = 0; i < count; ++i) {
      inside |= std::uint64_t{items[first + i].covered()} << i;
      opaque |= std::uint64_t{items[first + i].look->opaque} << i;
      plain |= std::uint64_t{items[first + i].look->blends()} << i;
    }
    inside_[word] = inside, opaque_[word] = opaque, plain_[word] = plain;
  }
}

std::size_t SeenItems::next_inside(std::size_t from) const {
  std::size_t word = from / 64;
  if (word >= inside_.size()) return kNone;
  std::uint64_t bits = inside_from(from);
  while (bits == 0 && ++word < inside_.size()) bits = inside_[word];
  return bits == 0 ? kNone : 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
}

std::size_t SeenItems::uppermost_opaque() const {
  for (std::size_t word = inside_.size(); word-- > 0;)
    if (const std::uint64_t bits = inside_[word] & opaque_[word]; bits != 0)
      return 64 * word + static_cast<std::size_t>(63 - std::countl_zero(bits));
  return kNone;
}

Light SeenItems::composed() {
  if (inside_.size() == 1) {  // most often the uppermost is opaque
    const std::uint64_t opaque = inside_[0] & opaque_[0];
    if (opaque > (inside_[0] & ~opaque)) {
      lowest_ = static_cast<std::size_t>(63 - std::countl_zero(opaque));
      return items[lowest_].light;
    }
  }
  const std::size_t lowest = uppermost_opaque();
  lowest_ = lowest == kNone ? 0 : lowest;
  Light light = lowest == kNone ? ground : items[lowest].light;
  std::size_t i = next_inside(lowest + 1);  // after none comes the first
  while (i != kNone) {
    const std::size_t word = i / 64;
    std::uint64_t bits = inside_from(i);
    if ((bits & ~plain_[word]) == 0) {  // all that is left of the word
      for (; bits != 0; bits &= bits - 1)
        lay(items[64 * word + static_cast<std::size_t>(std::countr_zero(bits))].light, light);
      i = next_inside(64 * (word + 1));
      continue;
    }
    const ItemLook& first = *items[i].look;
    if (first.layer == 0) {
      light = laid(items[i], light);
      i = next_inside(i + 1);
      continue;
    }
    Light layer{};
    for (; i != kNone && items[i].look->layer == first.layer; i = next_inside(i + 1))
      layer = laid(items[i], layer);
    light = over(layer, light, first.item->opacity);
  }
  return light;
}

}  // namespace flatray
