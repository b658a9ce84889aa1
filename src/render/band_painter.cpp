#include "render/band_painter.h"

#include <algorithm>

#include "render/gradient.h"
#include "render/select_kernels.h"

namespace flatray {

BandPainter::BandPainter(const DrawList& list, bool hide, bool (*stop)())
    : list_(list), hide_(hide), kernels_(span_kernels(active_isa())), item_scan_(list, stop) {}

const Tile& BandPainter::paint(const PixelBox& box, const Band& band, std::size_t items,
                               const StillBand* still, int y) {
  tile_.x = 0;
  tile_.y = y;
  tile_.width = box.width;
  tile_.height = box.height;
  const std::size_t pixels =
      static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  tile_.rgba.resize(4 * pixels);
  const std::size_t lowest = still == nullptr ? 0 : still->items();
  const std::optional<std::size_t> hiding = hiding_item(box, band, lowest, items);
  hidden_ = hiding.value_or(0);
  if (!hiding) {
    if (still == nullptr)
      kernels_.fill(tile_.rgba.data(), pixels, premultiplied(list_.background).data());
    else
      still->copy_light(tile_.rgba.data());
  }
  blend_all(box, band, hiding.value_or(lowest), items);
  return tile_;
}

// The uppermost item that hides all below it.
std::optional<std::size_t> BandPainter::hiding_item(const PixelBox& box, const Band& band,
                                                    std::size_t first, std::size_t last) {
  if (!hide_) return std::nullopt;
  for (std::size_t i = last; i-- > first;) {
    if (band[i].colour.a != 1 || list_.items[band[i].item].opacity != 1 || !band[i].may_cover(box))
      continue;
    scan(box, band, i);
    if (covers_all(runs_.runs(), box)) return i;
  }
  return std::nullopt;
}

void BandPainter::scan(const PixelBox& box, const Band& band, std::size_t i) {
  runs_.clear();
  item_scan_.scan(band, band[i], box, runs_);
}

void BandPainter::blend_all(const PixelBox& box, const Band& band, std::size_t first,
                            std::size_t last) {
  const kernels::Target target{tile_.rgba.data(), box.x, box.y, box.width};
  const auto item = [&](std::size_t i) -> const DrawItem& { return list_.items[band[i].item]; };
  for (std::size_t i = first; i < last;) {
    const std::uint32_t layer = item(i).layer;
    if (layer == 0) {
      scan(box, band, i);
      blend(item(i++), target);
      continue;
    }
    const std::size_t begin = i;
    Bounds around;
    for (; i < last && item(i).layer == layer; ++i) around.add(band[i].bounds);
    const PixelBox part = pixels_around(around, box);
    layer_.clear(target, part, box.height);
    for (std::size_t k = begin; k < i; ++k) {
      scan(box, band, k);
      blend(item(k), layer_.target());
    }
    layer_.lay_over(target, part, item(begin).opacity);
  }
}

void BandPainter::add_light(const LightPicture& light, const kernels::Target& target,
                            std::span<const Run> runs) const {
  for (const Run& run : runs) {
    const auto row = static_cast<std::size_t>(run.y) * static_cast<std::size_t>(list_.width);
    const float* from = light.rgb.data() + 3 * (row + static_cast<std::size_t>(run.x_begin));
    float* to = target.rgba +
                4 * ((run.y - target.y) * std::ptrdiff_t{target.width} + (run.x_begin - target.x));
    for (std::int32_t x = run.x_begin; x < run.x_end; ++x, from += 3, to += 4) {
      for (int channel = 0; channel < 3; ++channel) to[channel] += from[channel];
      // Over what is clear light is as opaque as it is bright.
      to[3] = std::max(to[3], std::min(std::max({from[0], from[1], from[2]}), 1.0F));
    }
  }
}

void BandPainter::blend(const DrawItem& item, const kernels::Target& target) {
  const std::span<const Run> runs = runs_.runs();
  if (item.light)
    add_light(*item.light, target, runs);
  else if (item.gradient)
    GradientPainter(*item.gradient).blend_runs(target, runs);
  else
    kernels_.blend_runs(target, runs.data(), runs.size(), premultiplied(item.colour).data());
}

}  // namespace flatray
