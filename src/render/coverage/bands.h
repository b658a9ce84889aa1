#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/coverage/row_lists.h"
#include "render/draw_list.h"
#include "render/pixel_box.h"

namespace flatray {

/// What is drawn of an item, once for all bands it lies in.
struct BandItem {
  std::uint32_t item = 0;
  std::uint32_t first = 0, edges = 0;  ///< of a long path, among those of all
  Bounds bounds;                       ///< nothing of it lies outside
};

/// The items of a band from the lowest up: a list made when it is asked for, in memory that is kept
/// from band to band. Needs its Bands to stay where they are.
class Band {
 public:
  std::size_t size() const { return items_.size(); }
  const BandItem& operator[](std::size_t i) const { return all_[items_[i]]; }

  /// Of an item that is a long path, those of its edges that meet the band: `item.first` is its
  /// first.
  std::span<const std::uint32_t> edges(const BandItem& item) const;

 private:
  friend class Bands;
  const BandItem* all_ = nullptr;
  std::vector<std::uint32_t> items_, edges_;
};

/// Rows of a crop of the film, cut into bands by its width alone, and what lies in each.
///
/// Cost    48 bytes an item, and for every item and every edge of a
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
  std::uint32_t edges_ = 0;  ///< of long paths
  RowLists items_of_, edges_of_;
};

/// What of a band is not as it was before: nothing outside of these columns.
struct BandChange {
  int x_begin = 0, x_end = 0;
  bool unchanged() const { return x_begin >= x_end; }
};

/// As of bands that were not drawn before.
std::vector<BandChange> whole_bands(const Bands& bands);

/// By band of `now`.
/// Needs   bands of the same crop.
std::vector<BandChange> compare_bands(const DrawList& now, const Bands& now_bands,
                                      const DrawList& before, const Bands& before_bands);

}  // namespace flatray
