#include "trace/lane_tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/counted.h"
#include "trace/cell_search.h"
#include "trace/exact_nearest.h"
#include "trace/kernels/tiers.h"
#include "trace/lane_block.h"
#include "trace/many_rays.h"

namespace flatray {
namespace {

constexpr std::size_t kBlockOfCells = 4096, kBlockOfList = 512;
// Up to so many rays one after the other are faster than lanes (benchmarks/batch_size).
constexpr std::size_t kFewRays = kMostRaysOneByOne, kFewRaysOfList = 4;

class LaneTracer : public Accelerator {
 public:
  /// Without cells where coordinates leave no room for lanes.
  LaneTracer(const Surfaces& walls, std::optional<CellGrid> cells, Isa isa, unsigned threads)
      : Accelerator(walls),
        cells_(std::move(cells)),
        curve_cells_(CellGrid::build_of_curves(walls, threads)),
        view_(cells_ ? view_of(walls, *cells_) : lanes::Grid{}),
        curve_view_(curve_cells_ ? curve_cells_->view() : lanes::Grid{}),
        kernels_(lane_kernels(isa).walk),
        search_(walls, cells_ ? &*cells_ : nullptr, curve_cells_ ? &*curve_cells_ : nullptr,
                kernels_) {}

  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    if (are_few(rays)) return Accelerator::nearest(rays, hits);
    std::vector<int> open;
    in_blocks(rays, [&](LaneBlock& block, std::size_t begin, std::size_t count) {
      const std::span<NearestHit> some = hits.subspan(begin, count);
      for (const int i : find_in_lanes(block, some, open)) {
        const std::size_t ray = begin + static_cast<std::size_t>(i);
        const bool knows_segment = curve_cells_ && block.ends()[static_cast<std::size_t>(i)] >= 0;
        hits[ray] = knows_segment
                        ? search_.nearest_beside(hits[ray], rays.ray(ray), rays.departed[ray],
                                                 rays.tangents)
                        : search_.nearest(rays.ray(ray), rays.departed[ray], rays.tangents);
      }
      for (std::size_t i = 0; curve_cells_ && i < count; ++i)
        if (std::isnan(some[i].t))
          some[i] = crossing_hit(walls_, rays.ray(begin + i), some[i].surface, some[i].root);
    });
  }
  // No ray goes on beyond its end, nor asks which wall of those it meets is the first.
  void any(const RayBatch& rays, std::span<const double> up_to,
           std::span<std::uint8_t> met) const override {
    if (are_few(rays)) return Accelerator::any(rays, up_to, met);
    std::vector<int> found;
    in_blocks(rays, [&](LaneBlock& block, std::size_t begin, std::size_t count) {
      found.assign(count, lanes::kNoRecord);
      std::copy_n(&up_to[begin], count, block.ends().begin());
      const auto take = [&](const LaneCells& cells) {
        const auto of_these = block.walk(cells, LaneBlock::Asked::any_before_end);
        for (std::size_t i = 0; i < count; ++i) {
          if (of_these[i] != lanes::kNoRecord && found[i] < 0) found[i] = of_these[i];
          if (found[i] >= 0) block.ends()[i] = kNowhere;
        }
      };
      if (cells_) take({*cells_, view_});
      if (curve_cells_) take({*curve_cells_, curve_view_});
      for (std::size_t i = 0; i < count; ++i)
        met[begin + i] = found[i] == lanes::kDoubt
                             ? any_of_one(rays.ray(begin + i), up_to[begin + i],
                                          rays.departed[begin + i], rays.tangents)
                             : found[i] >= 0;
    });
  }
  std::size_t left_by_lanes(const RayBatch& rays) const override {
    if (!has_lanes()) return rays.size();
    std::size_t left = 0;
    std::vector<int> open;
    std::vector<NearestHit> hits(std::min(kBlockOfCells, rays.size()));
    in_blocks(rays, [&](LaneBlock& block, std::size_t, std::size_t count) {
      left += find_in_lanes(block, {hits.data(), count}, open).size();
      for (std::size_t i = 0; curve_cells_ && i < count; ++i) left += std::isnan(hits[i].t) ? 1 : 0;
    });
    return left;
  }
  NearestHit nearest_of_one(const Ray& ray, const DepartedSurface& departed,
                            bool tangents) const override {
    if (!has_lanes()) return search_.nearest(ray, departed, tangents);
    NearestHit hit;
    if (cells_) {
      const lanes::SingleHit found = segment_of_one(ray, walls_.segment_slot(departed.surface));
      if (found.found == lanes::kDoubt || std::isnan(found.t))
        return search_.nearest(ray, departed, tangents);
      if (found.found >= 0)
        hit = {walls_.segment_numbers[found.slot], HitClass::touch, Root::none, false, found.t};
    }
    return curve_cells_ ? nearest_beside(hit, ray, departed, tangents) : hit;
  }
  std::vector<NearestHit> all_of_one(const Ray& ray, const DepartedSurface& departed,
                                     bool tangents) const override {
    return search_.all(ray, departed, tangents);
  }
  std::size_t tested_of_one(const Ray& ray, const DepartedSurface& departed) const override {
    return search_.tested(ray, departed);
  }
  std::size_t bytes() const override {
    return (cells_ ? cells_->bytes() : 0) + (curve_cells_ ? curve_cells_->bytes() : 0);
  }
  std::string structure() const override {
    const std::size_t curves = walls_.curve_numbers.size();
    if (curves == 0) return structure_of(cells_);
    const std::string of_curves = counted(curves, "curve") + " in " + structure_of(curve_cells_);
    return walls_.segments.empty() ? of_curves : structure_of(cells_) + ", " + of_curves;
  }
  std::size_t cells() const override { return cells_of(cells_) + cells_of(curve_cells_); }

 private:
  // A segment that is the first of a ray, unless it has left one that has a copy.
  lanes::SingleHit segment_of_one(const Ray& ray, std::uint32_t left) const {
    if (left != kNoSurface && cells_->next_copy(left) != CellGrid::kNoSlot)
      return {lanes::kDoubt, 0, 0};
    return kernels_.single_ray(view_, ray.origin.x(), ray.origin.y(), ray.direction.x(),
                               ray.direction.y(), left);
  }
  // Given the first of the segments, if any.
  NearestHit nearest_beside(const NearestHit& hit, const Ray& ray, const DepartedSurface& departed,
                            bool tangents) const {
    if (!curve_cells_->is_for_lanes()) return search_.nearest_beside(hit, ray, departed, tangents);
    const lanes::SingleHit found = kernels_.single_curve(
        curve_view_, ray.origin.x(), ray.origin.y(), ray.direction.x(), ray.direction.y(),
        LaneBlock::curve_slot(walls_, departed), LaneBlock::roots_of(departed), hit.t);
    if (found.found == lanes::kDoubt) return search_.nearest_beside(hit, ray, departed, tangents);
    if (found.found < 0) return hit;
    const std::uint32_t surface = walls_.curve_numbers[found.slot];
    const Root root = (found.found & lanes::kSecond) != 0 ? Root::second : Root::first;
    if (std::isnan(found.t)) return crossing_hit(walls_, ray, surface, root);
    return {surface, HitClass::through, root, false, found.t};
  }

  static bool has_cells(const std::optional<CellGrid>& grid) { return grid && grid->has_cells(); }
  static std::size_t cells_of(const std::optional<CellGrid>& grid) {
    if (!has_cells(grid)) return 0;
    return static_cast<std::size_t>(grid->columns()) * static_cast<std::size_t>(grid->rows());
  }
  static std::string structure_of(const std::optional<CellGrid>& grid) {
    if (!has_cells(grid)) return "one list";
    const std::string cells =
        std::to_string(grid->columns()) + " x " + std::to_string(grid->rows()) + " cells";
    return grid->divided() == 0
               ? cells
               : cells + ", " + std::to_string(grid->divided()) + " of them crowded and divided";
  }
  bool has_lanes() const {
    return (cells_ || walls_.segments.empty()) && (curve_cells_ || walls_.curve_numbers.empty()) &&
           walls_.size() > 0;
  }
  bool walks() const { return has_cells(cells_) || has_cells(curve_cells_); }
  bool are_few(const RayBatch& rays) const {
    return !has_lanes() || rays.size() <= (walks() ? kFewRays : kFewRaysOfList);
  }

  static constexpr double kNowhere = -1;  // where rays end that go on no more
  template <class Each>
  void in_blocks(const RayBatch& rays, const Each& each) const {
    const std::size_t most = std::min(walks() ? kBlockOfCells : kBlockOfList, rays.size());
    LaneBlock block(walls_, kernels_, most);
    for (std::size_t begin = 0; begin < rays.size(); begin += most) {
      const std::size_t count = std::min(most, rays.size() - begin);
      block.load(rays, begin, count);
      each(block, begin, count);
    }
  }

  // The hits of a block, t of curves NaN where it is not certain; gives the rays that have none yet, which
  // `open` may hold.
  std::span<const int> find_in_lanes(LaneBlock& block, std::span<NearestHit> hits,
                                     std::vector<int>& open) const {
    std::span<const int> left;
    if (cells_) {
      block.walk({*cells_, view_}, LaneBlock::Asked::first);
      left = block.finish({*cells_, view_}, hits.data());
    } else {
      std::fill(hits.begin(), hits.end(), NearestHit{});
    }
    if (!curve_cells_) return left;
    add_curves(block, left, hits, open);
    return open;
  }
  // Curves that are met before the segments; gives the rays that have no answer yet, those before among them, where
  // `ends` is kNowhere: of others the first segment is known.
  void add_curves(LaneBlock& block, std::span<const int> left, std::span<NearestHit> hits,
                  std::vector<int>& open) const {
    const LaneCells curves{*curve_cells_, curve_view_};
    const std::span<double> ends = block.ends();
    for (std::size_t i = 0; i < hits.size(); ++i) ends[i] = hits[i].t;
    for (const int i : left) ends[static_cast<std::size_t>(i)] = kNowhere;
    const bool is_sure = curve_cells_->is_for_lanes();
    std::span<const int> found;
    if (is_sure) found = block.walk(curves, LaneBlock::Asked::first_before_end);
    open.clear();
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (ends[i] < 0)
        hits[i] = NearestHit{};
      else if (hits[i])
        hits[i].surface = walls_.segment_numbers[hits[i].surface];
      if (ends[i] < 0 || !is_sure || found[i] == lanes::kDoubt) open.push_back(static_cast<int>(i));
    }
    if (is_sure) block.finish_curves(curves, hits.data());
  }

  static lanes::Grid view_of(const Surfaces& walls, const CellGrid& cells) {
    lanes::Grid view = cells.view();
    view.ends = walls.segments.front().a.data();
    return view;
  }

  const std::optional<CellGrid> cells_, curve_cells_;
  const lanes::Grid view_, curve_view_;
  const lanes::WalkKernels& kernels_;
  const CellSearch search_;
};

}  // namespace

std::unique_ptr<Accelerator> trace_in_lanes(const Surfaces& walls, std::optional<CellGrid> cells,
                                            Isa isa, unsigned threads) {
  return std::make_unique<LaneTracer>(walls, std::move(cells), isa, threads);
}

}  // namespace flatray
