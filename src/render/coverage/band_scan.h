#pragma once
#include <cstdint>
#include <vector>

#include "render/coverage/bands.h"
#include "render/coverage/bit_runs.h"
#include "render/coverage/pixel_area.h"
#include "render/coverage/pixel_rest.h"
#include "render/coverage/row_pieces.h"

namespace flatray {

/// Takes what a scan finds: each pixel of the box once, in any order.
class PixelSink {
 public:
  virtual ~PixelSink() = default;
  /// Pixels [begin, end) of one light.
  virtual void run(int y, int begin, int end, const Light& light) = 0;
  virtual void pixel(int y, int x, const Light& light) = 0;
};

/// Bands of pixels from the items that lie in them. Items are taken from the uppermost down: along
/// a row of pixels, which is a ray, each covers runs of whole pixels and a part of those at its
/// edges. What an opaque item of one colour covers is drawn and settled at once, with the parts of
/// those above it, and nothing below is looked at there; what shines through others waits until all
/// items are known.
///
/// Gives   Coverage::area: the mean of the light over each pixel, jointly over all items (PixelArea).
///         Coverage::rows: the mean along n rays of each row of pixels, exact along each.
///         Coverage::centre: the light at the pixel's centre; a centre on an outline belongs to the
///         region right of or below it. Whether a centre is inside is exact for straight edges; curved
///         ones are cut into pieces at doubles first.
///         A gradient or light film has in all of a pixel its colour there. The same light whatever
///         the box.
/// Cost    O(edges in the rows + pixels with an edge that is seen), each as PixelArea says, and a run
///         of pixels between them at once.
class BandScan {
 public:
  /// `hide`: what opaque items cover is not looked at.
  /// `stop`: FrameOptions::stop; what is drawn when it says so is no picture.
  BandScan(const DrawList& list, bool hide, bool (*stop)());

  void scan(const PixelBox& box, const Band& band, PixelSink& sink);
  /// Items the last call left out, as those above hide all of the box.
  std::size_t hidden() const { return hidden_; }
  /// Items cut by rows so far.
  std::uint64_t scans() const { return scans_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  /// A winding number of some rays; of the others it is 0.
  struct Wound {
    int winding;
    std::uint64_t rays;
  };
  /// What an item covers of a pixel.
  struct Part {
    std::uint32_t item;
    std::uint32_t above;         ///< the part of the next item above in the pixel
    Wound wound;                 ///< just inside its upper left corner, or at the left of its rays
    std::uint32_t first, count;  ///< its pieces; of rays from ray to ray, and along each
  };
  /// That an item covers whole pixels from a column on, or no longer, as far as some rays go.
  struct Cover {
    std::int32_t column;
    bool begins;  ///< of one item after what ends there
    std::uint32_t item;
    std::uint64_t rays;
    auto operator<=>(const Cover&) const = default;
  };
  /// A bit for each of 64 columns.
  struct Words {
    std::uint64_t settled = 0;  ///< nothing below is seen; or it lies right of the box
    std::uint64_t waits = 0;    ///< has parts
    std::uint64_t shines = 0;   ///< has covers through which one sees
  };
  /// An item of which a pixel has a part, or that covers it along some rays.
  struct Shown {
    std::uint32_t seen;
    const Part* part;    ///< none where it covers rays alone
    std::uint64_t rays;  ///< that begin inside it, where not all do
  };
  struct RayChange {
    int ray;
    double x;
    std::uint32_t seen;
    int direction;
  };

  // Items are taken: band_scan.cpp.
  void fetch(const Band& band, std::size_t i) const;
  std::size_t take_items(const Band& band);
  bool is_settled(const PixelBox& box) const;
  void cut_item(const Band& band, std::size_t i, const PixelBox& rows);
  void begin_row(int row);
  void take_row(int row);
  void take_columns(const std::vector<RowCut>& cuts);
  int pass(const RowCut& cut, int winding);
  void add_part(int column, const Wound& wound, std::span<const RowCut* const> cuts);
  std::size_t place(int column) const { return static_cast<std::size_t>(column - box_.x); }
  Wound wound() const;
  void add_windings(const Wound& wound);
  void cover(int begin, int end);
  void cover_all(int begin, int end);
  void cover_rays(int begin, int end, std::uint64_t rays, bool shining);

  // What waits is drawn: band_draw.cpp.
  void draw_row(int row);
  void draw_shining(int begin, int end);
  void draw_run(int begin, int end);
  void draw_part(int at, const ItemLook* below);
  Light light_of(const Part& part, const Light& below) const;
  Light joint_light(int column, std::uint32_t part, const ItemLook* below);
  void see(int column, std::uint32_t part, const ItemLook* below);
  Light part_covered(const Shown& one);
  std::optional<Light> light_of_rest();
  Light mean_of_rays();

  const DrawList& list_;
  const bool hide_;
  bool (*const stop_)();
  const int rays_;
  const std::uint64_t all_rays_;
  const Light background_;
  PixelBox box_;  ///< of the rows that are taken
  PixelSink* sink_ = nullptr;
  std::size_t hidden_ = 0;
  std::uint64_t scans_ = 0;
  ScanEdges edges_;
  RowCutter cutter_;
  std::vector<ItemLook> looks_;             ///< by item of the band
  std::size_t stride_ = 0;                  ///< words a row
  std::vector<Words> words_;                ///< of the rows, one after another
  std::vector<std::uint32_t> lowest_;       ///< part by pixel that waits
  std::vector<std::vector<Cover>> covers_;  ///< by row
  std::vector<Part> parts_;
  std::vector<Piece> pieces_;

  int row_ = 0;  ///< that is taken or drawn, and what is of it
  Words* row_words_ = nullptr;
  std::uint32_t* row_lowest_ = nullptr;
  std::vector<Cover>* row_covers_ = nullptr;

  std::uint32_t item_ = 0;  ///< that is taken
  /// Of it, along the row's upper border or each ray, from column to column; else 0.
  std::vector<int> windings_;
  std::vector<std::uint64_t> entries_;  ///< a column's number, then a cut's, as one number
  std::vector<const RowCut*> here_;

  std::vector<Cover> active_;  ///< at the pixel that is drawn, from the lowest up
  std::vector<Shown> shown_;   ///< in it, from the lowest up
  SeenItems seen_;
  bool varies_ = false;  ///< one of them, from pixel to pixel
  std::vector<RayChange> changes_;
  std::vector<PieceOf> pieces_of_;
  PixelArea area_;
  PixelRest rest_;
};

}  // namespace flatray
