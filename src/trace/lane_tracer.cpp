#include "trace/lane_tracer.h"

#include <cmath>
#include <utility>

#include "geom/error_bounds.h"
#include "trace/cell_search.h"
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
  LaneTracer(const Surfaces& walls, std::optional<CellGrid> cells, Isa isa)
      : Accelerator(walls),
        cells_(std::move(cells)),
        view_(cells_ ? view_of(walls, *cells_) : lanes::Grid{}),
        curves_(WallCells::of_curves(walls)),
        search_(walls, cells_ ? &*cells_ : nullptr, curves_),
        kernels_(lane_kernels(isa).walk) {}

  void nearest(const RayBatch& rays, std::span<NearestHit> hits) const override {
    if (are_few(rays)) return Accelerator::nearest(rays, hits);
    in_blocks(rays, [&](LaneBlock& block, std::size_t begin, std::size_t count) {
      block.walk();
      const std::span<const int> open = block.finish(&hits[begin]);
      if (walls_.curve_numbers.empty()) {
        for (const int i : open) find_single(rays, begin + static_cast<std::size_t>(i), hits);
        return;
      }
      for (const int i : open) hits[begin + static_cast<std::size_t>(i)].kind = HitClass::along;
      for (std::size_t i = begin; i < begin + count; ++i)
        if (hits[i].kind == HitClass::along)
          find_single(rays, i, hits);
        else
          hits[i] = with_curves(hits[i], rays.ray(i), rays.departed[i], rays.tangents);
    });
  }
  // No ray goes on beyond its end, nor asks which wall of those it meets is the first.
  void any(const RayBatch& rays, std::span<const double> up_to,
           std::span<std::uint8_t> met) const override {
    if (are_few(rays)) return Accelerator::any(rays, up_to, met);
    in_blocks(rays, [&](LaneBlock& block, std::size_t begin, std::size_t) {
      std::size_t i = begin;
      for (const int found : block.walk(up_to)) {
        const bool open =
            found == lanes::kDoubt || (found < 0 && may_meet_curve(rays, i, up_to[i]));
        met[i] =
            open ? any_of_one(rays.ray(i), up_to[i], rays.departed[i], rays.tangents) : found >= 0;
        ++i;
      }
    });
  }
  std::size_t left_by_lanes(const RayBatch& rays) const override {
    if (!cells_ || !walls_.curve_numbers.empty()) return rays.size();
    std::size_t left = 0;
    std::vector<NearestHit> hits(std::min(kBlockOfCells, rays.size()));
    in_blocks(rays, [&](LaneBlock& block, std::size_t, std::size_t) {
      block.walk();
      left += block.finish(hits.data()).size();
    });
    return left;
  }
  NearestHit nearest_of_one(const Ray& ray, const DepartedSurface& departed,
                            bool tangents) const override {
    const std::uint32_t slot = walls_.segment_slot(departed.surface);
    if (!cells_ || (slot != kNoSurface && cells_->next_copy(slot) != CellGrid::kNoSlot))
      return search_.nearest(ray, departed, tangents);
    const lanes::SingleHit found = kernels_.single_ray(view_, ray.origin.x(), ray.origin.y(),
                                                       ray.direction.x(), ray.direction.y(), slot);
    if (found.found == lanes::kDoubt || std::isnan(found.t))
      return search_.nearest(ray, departed, tangents);
    const NearestHit hit =
        found.found < 0 ? NearestHit{}
                        : NearestHit{found.slot, HitClass::touch, Root::none, false, found.t};
    return walls_.curve_numbers.empty() ? hit : with_curves(hit, ray, departed, tangents);
  }
  std::vector<NearestHit> all_of_one(const Ray& ray, const DepartedSurface& departed,
                                     bool tangents) const override {
    return search_.all(ray, departed, tangents);
  }
  std::size_t tested_of_one(const Ray& ray, const DepartedSurface& departed) const override {
    return search_.tested(ray, departed);
  }
  std::size_t bytes() const override { return (cells_ ? cells_->bytes() : 0) + curves_.bytes(); }
  std::string structure() const override {
    std::string curves = curves_.structure();
    if (walls_.segments.empty() && !curves.empty()) return curves;
    return curves.empty() ? segments_in() : segments_in() + ", " + curves;
  }
  std::size_t cells() const override {
    const auto side = [](std::int32_t count) { return static_cast<std::size_t>(count); };
    return (has_cells() ? side(cells_->columns()) * side(cells_->rows()) : 0) + curves_.cells();
  }

 private:
  bool has_cells() const { return cells_ && cells_->has_cells(); }
  std::string segments_in() const {
    if (!has_cells()) return "one list";
    const std::string cells =
        std::to_string(cells_->columns()) + " x " + std::to_string(cells_->rows()) + " cells";
    return cells_->divided() == 0
               ? cells
               : cells + ", " + std::to_string(cells_->divided()) + " of them crowded and divided";
  }
  bool are_few(const RayBatch& rays) const {
    return !cells_ || rays.size() <= (has_cells() ? kFewRays : kFewRaysOfList);
  }
  bool may_meet_curve(const RayBatch& rays, std::size_t i, double up_to) const {
    if (up_to < 0) return false;
    const Ray ray = rays.ray(i);
    Candidates found(walls_, ray, rays.departed[i], up_to * (1 + 0x1p-50) + kUnderflowError);
    curves_.offer_to(found, ray);
    return !found.empty();
  }

  template <class Each>
  void in_blocks(const RayBatch& rays, const Each& each) const {
    const std::size_t most = std::min(has_cells() ? kBlockOfCells : kBlockOfList, rays.size());
    LaneBlock block(walls_, *cells_, view_, kernels_, most);
    for (std::size_t begin = 0; begin < rays.size(); begin += most) {
      const std::size_t count = std::min(most, rays.size() - begin);
      block.load(rays, begin, count);
      each(block, begin, count);
    }
  }

  void find_single(const RayBatch& rays, std::size_t i, std::span<NearestHit> hits) const {
    hits[i] = search_.nearest(rays.ray(i), rays.departed[i], rays.tangents);
  }

  // Of what is sure of the segments, by slot, and the curves.
  NearestHit with_curves(const NearestHit& segment, const Ray& ray, const DepartedSurface& departed,
                         bool tangents) const {
    Candidates found(walls_, ray, departed);
    if (segment) found.take_segment(segment.surface, segment.t);
    curves_.offer_to(found, ray);
    return found.first(tangents);
  }

  static lanes::Grid view_of(const Surfaces& walls, const CellGrid& cells) {
    lanes::Grid view = cells.view();
    view.ends = walls.segments.front().a.data();
    return view;
  }

  const std::optional<CellGrid> cells_;
  const lanes::Grid view_;
  const WallCells curves_;
  const CellSearch search_;
  const lanes::WalkKernels& kernels_;
};

}  // namespace

std::unique_ptr<Accelerator> trace_in_lanes(const Surfaces& walls, std::optional<CellGrid> cells,
                                            Isa isa) {
  return std::make_unique<LaneTracer>(walls, std::move(cells), isa);
}

}  // namespace flatray
