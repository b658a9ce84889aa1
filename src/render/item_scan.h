#pragma once
#include "render/bands.h"
#include "render/coverage_arcs.h"
#include "render/coverage_scan.h"

namespace flatray {

/// Scans items of one list whatever their region is; its room is kept from item to item.
class ItemScan {
 public:
  explicit ItemScan(const DrawList& list);

  /// Adds the runs of an item in a band.
  void scan(const BandItem& band_item, const PixelBox& box, RunList& out);

 private:
  const DrawList& list_;
  AreaScan area_scan_;
  CentreScan centre_scan_;
  ArcScan arc_scan_;
};

}  // namespace flatray
