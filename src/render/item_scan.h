#pragma once
#include <cstdint>
#include <vector>

#include "render/bands.h"
#include "render/coverage_arcs.h"
#include "render/coverage_monotone.h"

namespace flatray {

/// Scans items of one list whatever their region is; its room is kept from item to item.
class ItemScan {
 public:
  /// `stop` is FrameOptions::stop.
  ItemScan(const DrawList& list, bool (*stop)());

  /// Adds the runs of an item in a band.
  void scan(const Band& band, const BandItem& band_item, const PixelBox& box, RunList& out);
  /// Calls of it so far.
  std::uint64_t scans() const { return scans_; }

 private:
  const DrawList& list_;
  MonotoneScan monotone_scan_;
  AreaScan area_scan_;
  CentreScan centre_scan_;
  ArcScan arc_scan_;
  std::vector<std::uint32_t> chosen_;
  std::uint64_t scans_ = 0;
};

/// Whether the runs of a region cover every pixel of the box.
bool covers_all(std::span<const Run> runs, const PixelBox& box);

}  // namespace flatray
