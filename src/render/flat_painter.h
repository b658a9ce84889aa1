#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "image/pixel_runs.h"
#include "render/item_scan.h"
#include "render/still_layer.h"

namespace flatray {

/// Draws bands of items that have one colour each. Where none is covered in part, items are written
/// into the rows of the picture in order. Else from the uppermost down: a pixel an opaque item
/// covers is settled and written at once, and nothing below it is touched; what covers a pixel in
/// part waits until all are settled and is then blended from the bottom up, by the sums of
/// `SpanKernels::blend_runs`, so that the pixels are those of drawing everything in order as light.
class FlatPainter {
 public:
  /// `stop`: FrameOptions::stop; what is painted when it says so is no picture.
  FlatPainter(const DrawList& list, bool (*stop)());

  /// Draws the items of a band, those above `still` where there is one, into the rows of `out`, as
  /// wide as the band, from `y` on. Gives how many of its items others hide; nothing where so many
  /// lie over one another in part that blending them in order costs less: the pixels of the band
  /// are then still to be drawn.
  std::optional<std::size_t> paint(const PixelBox& box, const Band& band, const StillBand* still,
                                   int y, Image& out);
  std::uint64_t scans() const { return scan_.scans(); }

 private:
  /// A share of a pixel in the colour of an item.
  struct Fragment {
    std::uint32_t pixel, name, steps;
  };
  /// Of 64 neighbouring pixels of a row, a bit each.
  struct Word {
    std::uint64_t settled = 0;
    std::uint64_t in_part = 0;  ///< has fragments
  };

  std::size_t write_in_order(const Band& band);
  std::size_t first_seen(const Band& band);
  std::optional<std::size_t> settle_from_above(const Band& band);
  void begin();
  void lay(bool opaque, std::uint32_t name);
  void settle(int row, int x_begin, int x_end, std::uint32_t name, const ShownColour& colour);
  void settle_background();
  void settle_still();
  void blend_fragments();
  std::uint32_t add_colour(const LinearColour& colour);
  Word* words(int row) { return words_.data() + static_cast<std::size_t>(row) * row_words_; }
  std::uint32_t pixel(int row, int x) const {
    return static_cast<std::uint32_t>(row * box_.width + x);
  }

  const DrawList& list_;
  const StillBand* still_ = nullptr;
  std::size_t lowest_ = 0;  ///< item above it
  ItemScan scan_;
  RunList runs_;
  PixelBox box_;
  int channels_ = 3;
  std::uint8_t* first_ = nullptr;           ///< of the band's pixels
  std::size_t pixels_ = 0, row_words_ = 0;  ///< of the band; of a row
  std::size_t open_ = 0;                    ///< pixels not settled
  std::vector<Word> words_;
  std::vector<Fragment> fragments_;  ///< and room for more
  std::size_t fragment_count_ = 0;
  std::vector<Light> colours_;  ///< of the names; after those, of pixels with fragments
  /// Of settled pixels with fragments; room for all.
  std::unique_ptr<std::uint32_t[]> names_;
  std::size_t names_room_ = 0;
  std::uint32_t shared_ = 0;            ///< names of items, and of the background
  std::vector<std::uint32_t> blended_;  ///< pixels with a colour of their own
};

}  // namespace flatray
