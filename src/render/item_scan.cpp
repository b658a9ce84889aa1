#include "render/item_scan.h"

#include <algorithm>

#include "render/select_kernels.h"

namespace flatray {

ItemScan::ItemScan(const DrawList& list, bool (*stop)())
    : list_(list),
      monotone_scan_(span_kernels(active_isa())),
      area_scan_(span_kernels(active_isa()), stop),
      centre_scan_(span_kernels(active_isa())) {}

void ItemScan::scan(const Band& band, const BandItem& band_item, const PixelBox& box,
                    RunList& out) {
  using Part = BandItem::Part;
  ++scans_;
  if (band_item.part == Part::ring &&
      monotone_scan_.scan(band.ring(band_item), list_.coverage, box, out))
    return;
  const DrawItem& item = list_.items[band_item.item];
  if (const FillPath* path = std::get_if<FillPath>(&item.region)) {
    const bool some = band_item.part == Part::edges;
    chosen_.clear();
    if (some)
      for (const std::uint32_t edge : band.edges(band_item))
        chosen_.push_back(edge - band_item.first);
    const auto* const chosen = some ? &chosen_ : nullptr;
    if (list_.coverage == Coverage::area)
      area_scan_.scan(*path, chosen, box, out);
    else
      centre_scan_.scan(*path, chosen, box, out);
  } else if (const FillArcs* arcs = std::get_if<FillArcs>(&item.region)) {
    arc_scan_.scan(*arcs, list_.coverage, box, out);
  } else {
    CoverageStats stats;
    scan_ring(std::get<FillRing>(item.region), list_.coverage, box, out, stats);
  }
}

// Full ones are joined: a covered row is one run.
bool covers_all(std::span<const Run> runs, const PixelBox& box) {
  return runs.size() == static_cast<std::size_t>(box.height) &&
         std::all_of(runs.begin(), runs.end(), [&](const Run& run) {
           return run.steps == kFullCoverage && run.x_begin == box.x &&
                  run.x_end == box.x + box.width;
         });
}

}  // namespace flatray
