#include "render/item_scan.h"

#include "render/select_kernels.h"

namespace flatray {

ItemScan::ItemScan(const DrawList& list)
    : list_(list),
      area_scan_(span_kernels(active_isa())),
      centre_scan_(span_kernels(active_isa())) {}

void ItemScan::scan(const BandItem& band_item, const PixelBox& box, RunList& out) {
  const DrawItem& item = list_.items[band_item.item];
  if (const FillPath* path = std::get_if<FillPath>(&item.region)) {
    const auto* chosen = Bands::lists_edges(*path) ? &band_item.edges : nullptr;
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

}  // namespace flatray
