#include "render/band_painter.h"

#include <algorithm>

#include "render/gradient.h"
#include "render/select_kernels.h"

namespace flatray {

BandPainter::BandPainter(const DrawList& list, bool hide)
    : list_(list), hide_(hide), kernels_(span_kernels(active_isa())), item_scan_(list) {}

const Tile& BandPainter::paint(const PixelBox& box, const Band& band, std::size_t items,
                               const StillBand* still, int y) {
  tile_.x = 0;
  tile_.y = y;
  tile_.width = box.width;
  tile_.height = box.height;
  const std::size_t pixels =
      static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  tile_.rgba.resize(4 * pixels);
  const std::size_t first = still == nullptr ? 0 : still->items();
  if (!scan(box, band, first, items)) {
    if (still == nullptr)
      kernels_.fill(tile_.rgba.data(), pixels, premultiplied(list_.background).data());
    else
      still->copy_light(tile_.rgba.data());
  }
  blend_all({tile_.rgba.data(), box.x, box.y, box.width}, box.height);
  return tile_;
}

// From the uppermost item down, to the one that hides all below it; whether there is one.
bool BandPainter::scan(const PixelBox& box, const Band& band, std::size_t first, std::size_t last) {
  runs_.clear();
  scanned_.clear();
  hidden_ = 0;
  for (std::size_t i = last; i-- > first;) {
    const DrawItem& item = list_.items[band.items[i].item];
    const std::size_t begin = runs_.start();
    item_scan_.scan(band, band.items[i], box, runs_);
    scanned_.push_back({&item, begin, runs_.runs().size()});
    if (!hide_ || item.colour.a != 1 || item.opacity != 1 ||
        !covers_all(runs_.runs().subspan(begin), box))
      continue;
    hidden_ = i;
    return true;
  }
  return false;
}

void BandPainter::blend_all(const kernels::Target& target, int rows) {
  for (auto it = scanned_.rbegin(); it != scanned_.rend();) {
    const std::uint32_t layer = it->item->layer;
    if (layer == 0) {
      blend(*it++, target);
      continue;
    }
    const auto end = std::find_if(it, scanned_.rend(),
                                  [&](const Scanned& next) { return next.item->layer != layer; });
    const std::size_t begin = (end - 1)->begin;
    const PixelBox part = box_around(runs_.runs().subspan(begin, it->end - begin));
    layer_.clear(target, part, rows);
    const float opacity = it->item->opacity;
    for (; it != end; ++it) blend(*it, layer_.target());
    layer_.lay_over(target, part, opacity);
  }
}

void BandPainter::blend(const Scanned& scanned, const kernels::Target& target) {
  const std::span<const Run> runs =
      runs_.runs().subspan(scanned.begin, scanned.end - scanned.begin);
  if (scanned.item->gradient)
    GradientPainter(*scanned.item->gradient).blend_runs(target, runs);
  else
    kernels_.blend_runs(target, runs.data(), runs.size(),
                        premultiplied(scanned.item->colour).data());
}

}  // namespace flatray
