#pragma once
#include <cstdint>
#include <vector>

#include "render/coverage.h"

namespace flatray {

/// What of an item lies in a band of rows: all edges, or those listed.
struct BandItem {
  std::size_t item;
  std::vector<std::uint32_t> edges;
};

/// Rows of a crop of the film, cut into bands by its width alone, and what lies in each.
class Bands {
 public:
  Bands() = default;
  Bands(const DrawList& list, const PixelBox& crop);

  std::size_t count() const { return items_.size(); }
  const std::vector<BandItem>& items(std::size_t band) const { return items_[band]; }
  /// Pixels of a band, in film coordinates.
  PixelBox box(std::size_t band) const;
  /// Whether the items list the edges of `path` that meet them.
  static bool lists_edges(const FillPath& path);

 private:
  void add(std::size_t index, const DrawItem& item);
  void sort_edges(const FillPath& path);
  std::size_t band_of(double y) const;

  PixelBox crop_;
  int rows_ = 1;
  std::vector<std::vector<BandItem>> items_;
};

/// By band of `now`: whether it shows what it showed before, so that its pixels may be kept.
/// Needs   bands of the same crop.
std::vector<bool> unchanged_bands(const DrawList& now, const Bands& now_bands,
                                  const DrawList& before, const Bands& before_bands);

}  // namespace flatray
