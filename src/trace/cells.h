#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/bounds.h"
#include "trace/cell_raster.h"
#include "trace/curve_records.h"
#include "trace/kernels/walk.h"
#include "trace/surfaces.h"

namespace flatray {

/// The segments of a scene, or its curves, by the cells of a grid they come near to: what the kernels walk
/// through (kernels/walk.h).
///
/// Gives   lists that hold every wall within lanes::kMargin units of a cell; a wall in several
///         cells has a record in each. Of segments with the same two ends only the first is in them.
///         The slot of a curve is its place in Surfaces::curve_numbers.
/// Cost    O(n) to build; some 40 bytes a segment at one cell each, 64 at four.
class CellGrid {
 public:
  /// Nothing where the coordinates leave no room for sound arithmetic: over 2^900 or all within
  /// 2^-900 of each other; or where there are no segments.
  /// The same bits for any number of threads.
  static std::optional<CellGrid> build(const Surfaces& walls, unsigned threads = 1);
  /// The same with one list of all segments, by slot, in place of cells.
  static std::optional<CellGrid> build_list(const Surfaces& walls);
  /// The same of the curves; one list of few.
  static std::optional<CellGrid> build_of_curves(const Surfaces& walls, unsigned threads = 1);

  lanes::Grid view() const;
  /// A point in cells, the middle of the grid being 0.
  Vec2 place(const Vec2& point) const { return (point - centre_).cwiseProduct(scale_); }
  const Vec2& scale() const { return scale_; }
  /// Half the sides of the box that holds all segments with room to spare.
  Vec2 half() const;
  /// u M of the bounds: what a coordinate may be off by.
  double unit() const { return unit_; }

  bool has_cells() const { return !words_.empty(); }
  bool of_curves() const { return of_curves_; }
  /// Whether lanes can be certain of one of the walls.
  bool is_for_lanes() const { return !of_curves_ || sure_curves_ > 0; }
  /// The disc about a curve, and how large coordinates of such are.
  const BoundingDisc& disc(std::size_t slot) const { return discs_[slot]; }
  double disc_magnitude() const { return magnitude_; }
  /// How many walls there are.
  std::size_t slots(const Surfaces& walls) const {
    return of_curves_ ? walls.curve_numbers.size() : walls.segments.size();
  }
  /// Slot of the wall of a record.
  std::uint32_t slot(std::size_t record) const { return slots_[record]; }
  /// Whether it is the last of its cell.
  bool last(std::size_t record) const;

  /// What tells a segment's records from others', as the kernels compare it.
  struct Mark {
    float ax, ay, bx;
    bool operator==(const Mark&) const = default;
  };
  Mark mark(const Segment& segment) const;
  /// Whether another segment has the mark of this one.
  bool is_twin(std::size_t slot) const { return !twins_.empty() && twins_[slot]; }
  /// Whether lanes cannot tell this segment from another, or from its next copy.
  bool is_ambiguous(std::size_t slot) const { return is_twin(slot) || next_copy(slot) != kNoSlot; }

  static constexpr std::uint32_t kNoSlot = 0xffffffffU;
  /// The next segment with the same ends, by number.
  std::uint32_t next_copy(std::size_t slot) const {
    return next_copy_.empty() ? kNoSlot : next_copy_[slot];
  }
  /// Whether one of a lower number has the same ends: such are in no list.
  bool is_copy(std::size_t slot) const { return !copies_.empty() && copies_[slot]; }

  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }
  /// Cells that are divided.
  std::size_t divided() const { return divided_; }
  std::size_t bytes() const;
  /// Whether every word and record has the same bits.
  bool operator==(const CellGrid&) const = default;

 private:
  static std::optional<CellGrid> build(const Surfaces& walls, bool of_curves, bool in_cells,
                                       unsigned threads);
  bool measure(const Surfaces& walls);
  void divide(const Surfaces& walls);
  void set_cells(std::int32_t columns, std::int32_t rows);
  // Walls in cells.
  Segment placed(const Segment& segment) const;
  Arc placed(const Arc& wall) const;
  Bezier placed(const Bezier& wall) const;
  // Calls use(wall in cells), as the primitive that it is.
  template <class Use>
  decltype(auto) visit(const Surfaces& walls, std::size_t slot, const Use& use) const {
    if (!of_curves_) return use(placed(walls.segments[slot]));
    return walls.visit(walls.curve_numbers[slot],
                       [&](const auto& wall) { return use(placed(wall)); });
  }
  class Part;
  void fill(const Surfaces& walls, unsigned threads);
  void join(std::span<const Part> parts, std::span<const RowRange> rows, unsigned threads);
  void write_record(const Surfaces& walls, std::size_t slot, bool is_last, float* record) const;
  void find_forms(const Surfaces& walls);
  void fill_list(const Surfaces& walls);
  Vec2 extent_of(const Surfaces& walls, std::size_t slot) const;
  template <class Visit>
  void visit_near(const Surfaces& walls, std::size_t slot, const Raster& raster,
                  const RowRange& rows, const Frame& frame, const Visit& visit) const;
  void find_twins(const Surfaces& walls, unsigned threads);
  void find_copies(const Surfaces& walls, unsigned threads);

  static constexpr std::size_t kBeyond = 15;  // records read beyond the last

  Vec2 centre_, size_, scale_;
  std::int32_t columns_ = 0, rows_ = 0;  // without the ring
  double stride_ = 0, first_ = 0, unit_ = 0;
  std::size_t divided_ = 0;
  std::vector<std::uint32_t> words_, slots_;
  std::vector<float> records_;
  std::size_t kept_ = 0;  // segments that are no copies
  bool of_curves_ = false;
  std::vector<lanes::Curve> curves_;  // by slot
  std::size_t sure_curves_ = 0;       // those that have a form in the lanes
  std::vector<BoundingDisc> discs_;   // as given
  double magnitude_ = 0;              // of coordinates of the discs
  std::vector<double> circles_;       // four by slot: centre, radius, which is 0 of what is none
  std::vector<bool> twins_, copies_;
  std::vector<std::uint32_t> next_copy_;
};

}  // namespace flatray
