#include "trace/cell_search.h"

#include <algorithm>
#include <array>

#include "geom/error_bounds.h"
#include "trace/curve_filter.h"
#include "trace/exact_nearest.h"

namespace flatray {
namespace {

// A segment, or of the one just left its next copy, which may be none.
std::uint32_t not_departed(const Surfaces& walls, const CellGrid* cells,
                           const DepartedSurface& departed, std::uint32_t slot) {
  if (walls.segment_numbers[slot] != departed.surface) return slot;
  return cells == nullptr ? CellGrid::kNoSlot : cells->next_copy(slot);
}

// Shows all walls in the cells a ray comes through, or of the list, or all `count` of them, until no later one
// matters; of copies the first.
template <class Visit, class Settled>
void visit_walls(const lanes::WalkKernels& kernels, std::size_t count, const CellGrid* cells,
                 const lanes::Grid& view, const Ray& ray, const Visit& visit,
                 const Settled& settled) {
  struct Who {
    const CellGrid* cells;
    const Visit& visit;
    const Settled& settled;
  } who{cells, visit, settled};
  const auto list = [](void* asking, unsigned first) {
    const Who& of = *static_cast<Who*>(asking);
    for (std::size_t record = first;; ++record) {
      of.visit(of.cells->slot(record));
      if (of.cells->last(record)) return;
    }
  };
  const auto is_settled = [](void* asking, double t) {
    return static_cast<Who*>(asking)->settled(t);
  };
  if (cells != nullptr && cells->has_cells() &&
      kernels.visit_lists(view, ray.origin.x(), ray.origin.y(), ray.direction.x(),
                          ray.direction.y(), {&who, list, is_settled}))
    return;
  for (std::uint32_t slot = 0; slot < count; ++slot)
    if (cells == nullptr || !cells->is_copy(slot)) visit(slot);
}

void leave_each_once(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

// All that the walks of cells offer.
Candidates CellSearch::candidates(const Ray& ray, const DepartedSurface& departed) const {
  Candidates found(walls_, ray, departed);
  visit_walls(
      kernels_, walls_.segments.size(), segments_, segment_view_, ray,
      [&](std::uint32_t slot) {
        slot = not_departed(walls_, segments_, departed, slot);
        if (slot != CellGrid::kNoSlot) found.offer_segment(slot);
      },
      [&](double t) { return found.settled(t); });
  offer_curves(found, ray);
  return found;
}

void CellSearch::offer_curves(Candidates& found, const Ray& ray) const {
  const auto& numbers = walls_.curve_numbers;
  if (numbers.empty()) return;
  std::array<std::uint32_t, 8>
      recent;  // offered last, as cells that follow each other list them again
  recent.fill(CellGrid::kNoSlot);
  std::size_t next = 0;
  const DiscFilter filter(ray, curves_ == nullptr ? kInfinity : curves_->disc_magnitude());
  visit_walls(
      kernels_, numbers.size(), curves_, curve_view_, ray,
      [&](std::uint32_t slot) {
        const bool is_ruled_out =
            curves_ != nullptr && filter.rules_out(curves_->disc(slot), found.latest());
        if (is_ruled_out || std::find(recent.begin(), recent.end(), slot) != recent.end()) return;
        recent[next++ % recent.size()] = slot;
        found.offer_curve(numbers[slot]);
      },
      [&](double t) { return found.settled(t); });
}

// Slots of the segments in all cells a ray comes through, or of all segments, each once.
std::vector<std::uint32_t> CellSearch::segments_near(const Ray& ray) const {
  std::vector<std::uint32_t> slots;
  visit_walls(
      kernels_, walls_.segments.size(), segments_, segment_view_, ray,
      [&](std::uint32_t slot) {
        slots.push_back(slot);
        if (segments_ == nullptr) return;
        while ((slot = segments_->next_copy(slot)) != CellGrid::kNoSlot) slots.push_back(slot);
      },
      [](double) { return false; });
  leave_each_once(slots);
  return slots;
}

// The curves that a ray may meet.
std::vector<std::uint32_t> CellSearch::curves_near(const Ray& ray) const {
  std::vector<std::uint32_t> surfaces;
  visit_walls(
      kernels_, walls_.curve_numbers.size(), curves_, curve_view_, ray,
      [&](std::uint32_t slot) { surfaces.push_back(walls_.curve_numbers[slot]); },
      [](double) { return false; });
  leave_each_once(surfaces);
  std::erase_if(surfaces, [&](std::uint32_t surface) {
    const auto filter = [&](const auto& wall) {
      return filter_curve(ray, wall, Root::none).verdict;
    };
    return walls_.visit(surface, filter) == FilteredHit::Verdict::missed;
  });
  return surfaces;
}

std::vector<NearestHit> CellSearch::all(const Ray& ray, const DepartedSurface& departed,
                                        bool tangents) const {
  ExactNearest every(walls_, ray, departed, tangents, true);
  if (ray.direction == Vec2(0, 0)) {
    every.offer_all();
    return every.hits();
  }
  const SegmentFilter filter(ray);
  for (const std::uint32_t slot : segments_near(ray))
    if (filter(walls_.segments[slot]).verdict != FilteredHit::Verdict::missed)
      every.offer(walls_.segment_numbers[slot]);
  for (const std::uint32_t surface : curves_near(ray)) every.offer(surface);
  return every.hits();
}

NearestHit CellSearch::nearest(const Ray& ray, const DepartedSurface& departed,
                               bool tangents) const {
  if (ray.direction == Vec2(0, 0)) {
    ExactNearest search(walls_, ray, departed, tangents);
    search.offer_all();
    return search.hit();
  }
  return candidates(ray, departed).first(tangents);
}

NearestHit CellSearch::nearest_beside(const NearestHit& segment, const Ray& ray,
                                      const DepartedSurface& departed, bool tangents) const {
  if (ray.direction == Vec2(0, 0)) return nearest(ray, departed, tangents);
  Candidates found(walls_, ray, departed, segment.t * (1 + 0x1p-50) + kUnderflowError);
  if (segment) found.offer_segment(walls_.segment_slot(segment.surface));
  offer_curves(found, ray);
  return found.first(tangents);
}

std::size_t CellSearch::tested(const Ray& ray, const DepartedSurface& departed) const {
  if (ray.direction == Vec2(0, 0)) return walls_.size();
  return candidates(ray, departed).tested();
}

}  // namespace flatray
