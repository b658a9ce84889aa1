#pragma once
#include <cstdint>
#include <vector>

#include "render/coverage/bands.h"
#include "render/coverage/pixel_area.h"
#include "render/coverage/row_pieces.h"

namespace flatray {

/// Takes what a scan finds: each pixel of a row once, from left to right.
class PixelSink {
 public:
  virtual ~PixelSink() = default;
  /// Pixels [begin, end) of one light.
  virtual void run(int y, int begin, int end, const Light& light) = 0;
  virtual void pixel(int y, int x, const Light& light) = 0;
};

/// Bands of pixels from the items that lie in them, all at once: a row of pixels is a ray, which
/// passes from edge to edge of all items in turn; between edges one light goes on.
///
/// Gives   Coverage::area: the mean of the light over each pixel, jointly over all items (PixelArea).
///         Coverage::rows: the mean along n rays of each row of pixels, exact along each.
///         Coverage::centre: the light at the pixel's centre; a centre on an outline belongs to the
///         region right of or below it. Whether a centre is inside is exact for straight edges; curved
///         ones are cut into pieces at doubles first.
///         A gradient or light film has in all of a pixel its colour there. The same light whatever
///         the box.
/// Cost    O(edges in the rows + pixels with an edge), each as PixelArea says, and a run of pixels
///         between them at once.
class BandScan {
 public:
  /// `hide`: what an opaque item covers is not looked at.
  /// `stop`: FrameOptions::stop; what is drawn when it says so is no picture.
  BandScan(const DrawList& list, bool hide, bool (*stop)());

  void scan(const PixelBox& box, const Band& band, PixelSink& sink);
  /// Items the last call left out, as one above hides them.
  std::size_t hidden() const { return hidden_; }
  /// Items cut by rows so far.
  std::uint64_t scans() const { return scans_; }

 private:
  /// Items with a winding number other than 0.
  class Stack {
   public:
    struct Entry {
      std::uint32_t item;
      int winding;
    };
    void clear() { entries_.clear(), shown_from_ = 0; }
    /// Of items from the uppermost down, each as often as it changes.
    void change(std::span<const Entry> changes, std::span<const ItemLook> looks);
    std::span<const Entry> entries() const { return entries_; }
    /// Items below this one are hidden: it is opaque, and covers.
    std::uint32_t shown_from() const { return shown_from_; }

   private:
    void change(std::uint32_t item, int by);
    void merge(std::span<const Entry> changes);

    std::vector<Entry> entries_, merged_;
    std::uint32_t shown_from_ = 0;
  };

  /// Gives the number of the items that are hidden by one above in all of the box.
  std::size_t cut(const Band& band);
  void cut_item(const Band& band, std::size_t i);
  bool hides_all(std::uint32_t item);
  void scan_row(int row);
  void gather_columns(std::span<const Piece> pieces);
  void take_column(std::vector<const Piece*>& pieces, int row);
  void enter(std::span<const Piece* const> pieces);
  void put_run(int row, int end);
  Light area_of(std::span<const Piece* const> pieces, int row);
  std::optional<Light> plain_area_of(std::span<const Piece* const> pieces) const;
  Light part_covered(std::size_t at, double wound);
  Light mean_of_rays(std::span<const Piece*> pieces, int row);
  Light light_of_stacks(int row, int column, bool& varies);
  Light light_of(const Stack& stack, int row, int column, bool& varies);
  void see(const Stack& stack, int row, int column);

  const DrawList& list_;
  const bool hide_;
  bool (*const stop_)();
  const int rays_;
  const Light background_;
  PixelBox box_;  ///< of the rows that are cut
  PixelSink* sink_ = nullptr;
  int run_ = 0;  ///< column from which the row is still to be drawn
  std::size_t hidden_ = 0;
  std::uint64_t scans_ = 0;
  ScanEdges edges_;
  RowCutter cutter_;
  std::vector<ItemLook> looks_;  ///< by item of the band
  std::vector<Stack> stacks_;    ///< of the row's upper border, or of each ray
  SeenItems seen_;
  std::vector<std::uint32_t> cut_items_;  ///< of the pieces in a pixel, from the uppermost down
  std::vector<std::uint32_t> slots_;      ///< by item: its place in `seen_`
  std::vector<std::uint64_t> touched_;    ///< a bit for each column with pieces
  std::vector<std::uint32_t> first_of_, next_;  ///< lists of pieces by column
  std::vector<const Piece*> of_column_;
  std::vector<Stack::Entry> changes_;
  std::vector<PieceOf> pieces_;
  PixelArea area_;
};

}  // namespace flatray
