#pragma once
#include <span>
#include <vector>

#include "trace/cells.h"
#include "trace/hits.h"
#include "trace/ray_block.h"

namespace flatray {

/// Some rays of a batch on their way through the kernels.
class LaneBlock {
 public:
  /// Needs   all that it is given to outlive it. Takes at most `most` rays at a time.
  LaneBlock(const Surfaces& walls, const CellGrid& cells, const lanes::Grid& grid,
            const lanes::WalkKernels& kernels, std::size_t most);

  void load(const RayBatch& rays, std::size_t begin, std::size_t count);
  /// By ray the slot of a wall that may be its first, of rays that end one they may meet, or what is
  /// not certain. `up_to` by ray of the batch, or empty.
  std::span<const int> walk(std::span<const double> up_to = {});
  /// Writes the answers, of segments by slot, and gives the rays that have none yet.
  std::span<const int> finish(NearestHit* hits);

 private:
  bool some_have_left() const;
  bool find_left();

  const Surfaces& walls_;
  const CellGrid& cells_;
  const lanes::Grid& grid_;
  const lanes::WalkKernels& kernels_;
  const std::size_t room_;
  std::vector<float> numbers_, columns_;
  std::vector<unsigned> departed_;
  std::vector<int> fate_, found_, open_;
  std::vector<double> ends_;
  const RayBatch* rays_ = nullptr;
  std::size_t begin_ = 0, count_ = 0;
  lanes::Rays given_{};
  RayBlock whole_;
};

}  // namespace flatray
