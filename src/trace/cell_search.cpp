#include "trace/cell_search.h"

#include <algorithm>
#include <optional>

#include "trace/cell_walk.h"
#include "trace/exact_nearest.h"

namespace flatray {
namespace {

// A segment, or of the one just left its next copy, which may be none.
std::uint32_t not_departed(const Surfaces& walls, const CellGrid* listed,
                           const DepartedSurface& departed, std::uint32_t slot) {
  if (walls.segment_numbers[slot] != departed.surface) return slot;
  return listed == nullptr ? CellGrid::kNoSlot : listed->next_copy(slot);
}

// Shows all segments in the cells a ray comes through, or of the list, until no later one matters; of
// copies the first.
template <class Visit, class Settled>
void visit_segments(const Surfaces& walls, const CellGrid* listed, const CellGrid* grid,
                    const Ray& ray, const Visit& visit, const Settled& settled) {
  std::optional<CellWalk> walk;
  if (grid != nullptr) walk.emplace(*grid, ray);
  if (!walk || walk->is_uncertain()) {
    for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot)
      if (listed == nullptr || !listed->is_copy(slot)) visit(slot, kInfinity);
    return;
  }
  while (walk->next()) {
    for (std::size_t record = walk->record();; ++record) {
      visit(grid->slot(record), walk->limit());
      if (grid->last(record)) break;
    }
    if (settled(walk->limit())) break;
  }
}

}  // namespace

// All that the walks of cells offer.
Candidates CellSearch::candidates(const Ray& ray, const DepartedSurface& departed) const {
  Candidates found(walls_, ray, departed);
  visit_segments(
      walls_, listed_, grid_, ray,
      [&](std::uint32_t slot, double limit) {
        slot = not_departed(walls_, listed_, departed, slot);
        if (slot != CellGrid::kNoSlot) found.offer_segment(slot, limit);
      },
      [&](double t) { return found.settled(t); });
  curves_.offer_to(found, ray);
  return found;
}

// Slots of the segments in all cells a ray comes through, or of all segments, each once.
std::vector<std::uint32_t> CellSearch::segments_near(const Ray& ray) const {
  std::vector<std::uint32_t> slots;
  visit_segments(
      walls_, listed_, grid_, ray,
      [&](std::uint32_t slot, double) {
        slots.push_back(slot);
        if (listed_ == nullptr) return;
        while ((slot = listed_->next_copy(slot)) != CellGrid::kNoSlot) slots.push_back(slot);
      },
      [](double) { return false; });
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
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
  for (const std::uint32_t surface : curves_.near(ray)) every.offer(surface);
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

std::size_t CellSearch::tested(const Ray& ray, const DepartedSurface& departed) const {
  if (ray.direction == Vec2(0, 0)) return walls_.size();
  return candidates(ray, departed).tested();
}

}  // namespace flatray
