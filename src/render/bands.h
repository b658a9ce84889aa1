#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/coverage.h"
#include "render/monotone_ring.h"
#include "render/row_lists.h"

namespace flatray {

/// What is drawn of an item, once for all bands it lies in.
struct BandItem {
  enum class Part : std::uint8_t { whole, edges, ring };

  std::uint32_t item = 0;
  Part part = Part::whole;
  bool blended = false;                ///< has a gradient or is on a layer
  std::uint32_t first = 0, count = 0;  ///< edges of a long path among those of all; or corners
  LinearColour colour;
  Bounds bounds;  ///< nothing of it lies outside

  /// Whether by these the item may hold the centres of all pixels of a box.
  bool may_cover(const PixelBox& box) const;
};

/// The items of a band from the lowest up: a list made when it is asked for, in room that is kept
/// from band to band. Needs its Bands to stay where they are.
class Band {
 public:
  std::size_t size() const { return items_.size(); }
  const BandItem& operator[](std::size_t i) const { return all_[items_[i]]; }
  std::size_t flat_from() const { return flat_from_; }  ///< from here up no gradients, no layers
  std::size_t opaque_from() const { return opaque_from_; }  ///< from here up all colours are

  /// Of an item that is a ring.
  MonotoneRing ring(const BandItem& item) const { return corners_.subspan(item.first, item.count); }
  /// Of an item that is a long path, those of its edges that meet the band: `item.first` is its
  /// first.
  std::span<const std::uint32_t> edges(const BandItem& item) const;

 private:
  friend class Bands;
  const BandItem* all_ = nullptr;
  MonotoneRing corners_;
  std::vector<std::uint32_t> items_, edges_;
  std::size_t flat_from_ = 0, opaque_from_ = 0;
};

/// Rows of a crop of the film, cut into bands by its width alone, and what lies in each.
///
/// Cost    64 bytes an item, 16 a corner of a short ring, and for every item and every edge of a
///         long path at most 8 log2(bands), 4 where it lies in one band or in all.
class Bands {
 public:
  Bands() = default;
  Bands(const DrawList& list, const PixelBox& crop);

  std::size_t count() const { return count_; }
  /// Pixels of a band, in film coordinates.
  PixelBox box(std::size_t band) const;
  void list(std::size_t band, Band& out) const;

 private:
  void add(std::size_t index, const DrawItem& item);
  void add_edges(const FillPath& path);
  std::size_t band_of(double y) const;

  PixelBox crop_;
  int rows_ = 1;
  std::size_t count_ = 0;
  std::vector<BandItem> items_;
  std::vector<Corner> corners_;
  std::uint32_t edges_ = 0;  ///< of long paths
  RowLists items_of_, edges_of_;
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
