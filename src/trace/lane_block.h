#pragma once
#include <span>
#include <vector>

#include "trace/cells.h"
#include "trace/hits.h"
#include "trace/ray_block.h"

namespace flatray {

/// Cells of segments, or of curves, as kernels walk them.
struct LaneCells {
  const CellGrid& cells;
  const lanes::Grid& grid;
};

/// Some rays of a batch on their way through the kernels.
class LaneBlock {
 public:
  /// Needs   all that it is given to outlive it. Takes at most `most` rays at a time.
  LaneBlock(const Surfaces& walls, const lanes::WalkKernels& kernels, std::size_t most);

  void load(const RayBatch& rays, std::size_t begin, std::size_t count);
  /// Where rays end, by ray: to be written before they walk as rays that end.
  std::span<double> ends() { return {ends_.data(), count_}; }
  /// What is asked of rays.
  enum class Asked { first, first_before_end, any_before_end };
  /// By ray the slot of a wall that surely is what is asked, none, or that this is not certain
  /// (kernels/walk.h).
  std::span<const int> walk(const LaneCells& cells, Asked asked);
  /// Writes the answers of rays that have walked among segments, by slot, and gives those that have none
  /// yet.
  std::span<const int> finish(const LaneCells& cells, NearestHit* hits);
  /// Writes the answers of rays that have found a curve; t is NaN where it is not certain.
  void finish_curves(const LaneCells& cells, NearestHit* hits);

  /// The slot of a curve just left, kNone of what is none, and the roots (kernels/walk.h).
  static unsigned curve_slot(const Surfaces& walls, const DepartedSurface& departed);
  static unsigned roots_of(const DepartedSurface& departed);

 private:
  bool some_have_left() const;
  bool find_left(const CellGrid& cells);

  const Surfaces& walls_;
  const lanes::WalkKernels& kernels_;
  const std::size_t room_;
  std::vector<float> numbers_, columns_;
  std::vector<unsigned> departed_, roots_;
  std::vector<int> fate_, found_, open_;
  std::vector<double> ends_, times_;
  const RayBatch* rays_ = nullptr;
  std::size_t begin_ = 0, count_ = 0;
  lanes::Rays given_{};
  RayBlock whole_;
};

}  // namespace flatray
