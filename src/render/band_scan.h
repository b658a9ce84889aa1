#pragma once
#include <cstdint>
#include <vector>

#include "render/bands.h"
#include "render/column_lists.h"
#include "render/pixel_area.h"
#include "render/row_pieces.h"

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
/// edges. What an opaque item covers is settled at once, and nothing below is looked at there; parts
/// of items, and what shines through others, wait until all items are known and are then composed
/// jointly.
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
  /// `hide`: what an opaque item covers is not looked at.
  /// `stop`: FrameOptions::stop; what is drawn when it says so is no picture.
  BandScan(const DrawList& list, bool hide, bool (*stop)());

  void scan(const PixelBox& box, const Band& band, PixelSink& sink);
  /// Items the last call left out, as those above hide all of the box.
  std::size_t hidden() const { return hidden_; }
  /// Items cut by rows so far.
  std::uint64_t scans() const { return scans_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  enum class EventKind : std::uint8_t { begin, end, part };
  /// What waits in a row: that an item covers whole pixels from a column on, or no longer, or what it
  /// covers of the pixel there.
  struct Event {
    std::int32_t column;
    std::uint32_t item;
    EventKind kind;
    std::int32_t winding;        ///< of a part, just inside the pixel's upper left corner
    std::uint32_t first, count;  ///< its pieces
  };
  struct Row {
    std::vector<Event> events;  ///< of items from the uppermost down
    std::vector<Piece> pieces;
    bool shines = false;  ///< as Words::shines of any

    // In place: copied from fields just written it would wait for them.
    void add(EventKind kind, int column, std::uint32_t item, int winding = 1) {
      Event& event = events.emplace_back();
      event.column = column;
      event.item = item;
      event.kind = kind;
      event.winding = winding;
    }
    void add_part(int column, std::uint32_t item, int winding, std::size_t first_piece) {
      add(EventKind::part, column, item, winding);
      events.back().first = static_cast<std::uint32_t>(first_piece);
      events.back().count = static_cast<std::uint32_t>(pieces.size() - first_piece);
    }
    void clear() { events.clear(), pieces.clear(), shines = false; }
  };
  struct Words {
    std::uint64_t settled = 0;  ///< a bit for each column: nothing below is seen there
    std::uint64_t waits = 0;    ///< something of items waits there
    std::uint64_t shines = 0;   ///< of these, below whole items that do not hide what lies below
  };

  std::size_t take_items(const Band& band);
  void fetch(const Band& band, std::size_t i) const;
  bool is_settled(const PixelBox& box) const;
  void cut_item(const Band& band, std::size_t i);
  void take_row(std::uint32_t item, int row);
  void take_cuts(std::uint32_t item, int row);
  int pass(std::uint32_t item, int row, const RowCut& cut);
  void wind(const RowCut& cut);
  void add_part(std::uint32_t item, int row, int column);
  void cover(std::uint32_t item, int row, int begin, int end);
  void cover_all(std::uint32_t item, int row, int begin, int end);
  void draw_row(int row);
  void draw_run(int row, int begin, int end);
  void activate(const Event& event);
  void see(int row, int column);
  Light light_of_parts(int row);

  Row& row_of(int row) { return rows_[static_cast<std::size_t>(row - box_.y)]; }
  std::uint32_t* bases_of(int row) {
    return bases_.data() +
           static_cast<std::size_t>(row - box_.y) * static_cast<std::size_t>(box_.width);
  }
  std::size_t first_word(int row) const { return static_cast<std::size_t>(row - box_.y) * stride_; }
  Words* words_of(int row) {
    return words_.data() + static_cast<std::size_t>(row - box_.y) * stride_;
  }

  const DrawList& list_;
  const bool hide_;
  bool (*const stop_)();
  const int rays_;
  const Light background_;
  PixelBox box_;  ///< of the rows that are cut
  PixelSink* sink_ = nullptr;
  std::size_t hidden_ = 0;
  std::uint64_t scans_ = 0;
  ScanEdges edges_;
  RowCutter cutter_;
  std::vector<ItemLook> looks_;  ///< by item of the band
  std::vector<Row> rows_;
  std::size_t stride_ = 0;            ///< words a row
  std::vector<Words> words_;          ///< of the rows, one after another
  std::vector<std::uint32_t> bases_;  ///< by pixel that is settled and waits, but does not shine
  int open_ = 0;                      ///< pixels that are not settled
  std::vector<int> windings_;         ///< of one item, along the row's upper border or each ray
  std::vector<const RowCut*> order_;  ///< of its cuts in a row
  std::vector<const RowCut*> here_;   ///< those in the column
  ColumnLists columns_;
  std::vector<std::uint32_t> active_;  ///< items that cover the pixel and wait, uppermost first
  std::uint32_t base_ = kNone;         ///< the item that settles the pixel, if it is not among them
  std::vector<const Event*> parts_;    ///< in the pixel, uppermost first
  SeenItems seen_;
  std::vector<PieceOf> pieces_;
  PixelArea area_;
};

}  // namespace flatray
