#pragma once
#include <cstdint>
#include <vector>

#include "render/coverage.h"
#include "render/monotone_ring.h"

namespace flatray {

/// What of an item lies in a band of rows.
struct BandItem {
  enum class Part : std::uint32_t { whole, edges, ring };

  std::uint32_t item = 0;
  Part part = Part::whole;
  std::uint32_t first = 0, count = 0;  ///< of the band's lists of edges, or of its corners
  LinearColour colour;
  bool may_cover = false;  ///< the whole band, by the box around the item
};

/// The items of a band, and beside each other what most of them are drawn from.
struct Band {
  std::vector<BandItem> items;
  std::vector<std::vector<std::uint32_t>> edges;  ///< of long paths, those that meet the band
  std::vector<Corner> corners;                    ///< of monotone rings
  std::size_t flat_from = 0;    ///< from here up no item has a gradient or is on a layer
  std::size_t opaque_from = 0;  ///< from here up all colours are

  MonotoneRing ring(const BandItem& item) const {
    return MonotoneRing(corners).subspan(item.first, item.count);
  }
};

/// Rows of a crop of the film, cut into bands by its width alone, and what lies in each.
class Bands {
 public:
  Bands() = default;
  Bands(const DrawList& list, const PixelBox& crop);

  std::size_t count() const { return bands_.size(); }
  const Band& operator[](std::size_t band) const { return bands_[band]; }
  /// Pixels of a band, in film coordinates.
  PixelBox box(std::size_t band) const;

 private:
  void add(std::size_t index, const DrawItem& item, std::vector<Corner>& room);
  void sort_edges(const FillPath& path);
  std::size_t band_of(double y) const;

  PixelBox crop_;
  int rows_ = 1;
  std::vector<Band> bands_;
};

/// What of a band is as it was before.
struct BandChange {
  bool unchanged = false;  ///< all: its pixels may be kept
  std::size_t still = 0;   ///< how many of its items, from the lowest up, and no layer in part
};

/// By band of `now`.
/// Needs   bands of the same crop.
std::vector<BandChange> compare_bands(const DrawList& now, const Bands& now_bands,
                                      const DrawList& before, const Bands& before_bands);

}  // namespace flatray
