#include "trace/cell_search.h"

#include <algorithm>
#include <numeric>

#include "trace/cell_walk.h"
#include "trace/exact_nearest.h"
#include "trace/segment_filter.h"

namespace flatray {
namespace {

// A segment, or of the one just left its next copy, which may be none.
std::uint32_t not_left(const Surfaces& walls, const CellGrid* listed, const Left& left,
                       std::uint32_t slot) {
  if (walls.segment_numbers[slot] != left.surface) return slot;
  return listed == nullptr ? CellGrid::kNoSlot : listed->next_copy(slot);
}

// The nearest segment as far as bounds can say, and all that may come before it.
class Rivals {
 public:
  Rivals(const Surfaces& walls, const CellGrid* listed, const Ray& ray, const Left& left)
      : walls_(walls), listed_(listed), left_(left), filter_(ray) {}

  /// Takes a segment that need not be counted where it is surely met later than `limit`.
  void offer(std::uint32_t slot, double limit = kInfinity) {
    slot = not_left(walls_, listed_, left_, slot);
    if (slot == CellGrid::kNoSlot) return;
    ++tested_;
    const FilteredHit hit = filter_(walls_.segments[slot]);
    if (hit.verdict == FilteredHit::Verdict::missed || hit.low > limit || hit.low > high_) return;
    const auto recent = open_.end() - std::min(std::ssize(open_), kRecent);
    if (std::any_of(recent, open_.end(), [&](const Rival& other) { return other.slot == slot; }))
      return;
    open_.push_back({slot, hit.low});
    if (hit.verdict == FilteredHit::Verdict::sure && hit.high < high_) {
      high_ = hit.high;
      std::erase_if(open_, [&](const Rival& other) { return other.low > high_; });
    }
  }
  /// Whether nothing met later than t can be the nearest.
  bool settled(double t) const { return high_ < t; }

  CurveCells::Rivals curved(const Ray& ray, const CurveCells& curves) const {
    return curves.rivals(ray, left_, high_);
  }
  std::size_t tested() const { return tested_; }

  NearestHit decide(const Ray& ray, bool tangents, const CurveCells& curves) {
    drop_repeated();
    const CurveCells::Rivals curved = this->curved(ray, curves);
    const bool alone = open_.size() == 1 && high_ < kInfinity;
    if (curved.surfaces.empty()) {
      if (open_.empty()) return {};
      if (alone) return crossing_hit(walls_, ray, open_.front().slot);
    }
    if (curved.sure && open_.empty())
      return crossing_hit(walls_, ray, curved.surfaces.front(), curved.root);
    ExactNearest search(walls_, ray, left_, tangents);
    for (const Rival& rival : open_) search.offer(walls_.segment_numbers[rival.slot]);
    for (const std::uint32_t surface : curved.surfaces) search.offer(surface);
    return search.hit();
  }

 private:
  struct Rival {
    std::uint32_t slot;
    double low;
  };
  // Cells that list a segment again mostly follow each other; among more, to look for it at once
  // would take the square of their number.
  static constexpr std::ptrdiff_t kRecent = 16;
  void drop_repeated() {
    if (open_.size() < 2) return;
    std::sort(open_.begin(), open_.end(),
              [](const Rival& a, const Rival& b) { return a.slot < b.slot; });
    open_.erase(std::unique(open_.begin(), open_.end(),
                            [](const Rival& a, const Rival& b) { return a.slot == b.slot; }),
                open_.end());
  }

  const Surfaces& walls_;
  const CellGrid* listed_;
  const Left& left_;
  SegmentFilter filter_;
  std::vector<Rival> open_;
  double high_ = kInfinity;
  std::size_t tested_ = 0;
};

// Offers all segments in the cells a ray comes through until nothing nearer can come.
void gather(const Surfaces& walls, const CellGrid* listed, const CellGrid* grid, const Ray& ray,
            Rivals& offers) {
  std::optional<CellWalk> walk;
  if (grid != nullptr) walk.emplace(*grid, ray);
  if (!walk || walk->start() == CellWalk::Start::uncertain) {
    for (std::uint32_t slot = 0; slot < walls.segments.size(); ++slot)
      if (listed == nullptr || !listed->is_copy(slot)) offers.offer(slot);
    return;
  }
  while (walk->next()) {
    for (std::size_t record = walk->record();; ++record) {
      offers.offer(grid->slot(record), walk->limit());
      if (grid->last(record)) break;
    }
    if (offers.settled(walk->limit())) break;
  }
}

}  // namespace

// Slots of the segments in all cells a ray comes through, or of all segments, each once.
std::vector<std::uint32_t> CellSearch::segments_near(const Ray& ray) const {
  std::vector<std::uint32_t> slots;
  std::optional<CellWalk> walk;
  if (grid_ != nullptr) walk.emplace(*grid_, ray);
  if (!walk || walk->start() == CellWalk::Start::uncertain) {
    slots.resize(walls_.segments.size());
    std::iota(slots.begin(), slots.end(), 0U);
    return slots;
  }
  while (walk->next())
    for (std::size_t record = walk->record();; ++record) {
      for (std::uint32_t slot = grid_->slot(record); slot != CellGrid::kNoSlot;
           slot = grid_->next_copy(slot))
        slots.push_back(slot);
      if (grid_->last(record)) break;
    }
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
}

std::vector<NearestHit> CellSearch::all(const Ray& ray, const Left& left, bool tangents) const {
  ExactHits every(walls_, ray, left, tangents);
  if (ray.direction == Vec2(0, 0)) {
    every.offers().offer_all();
    return every.hits();
  }
  const SegmentFilter filter(ray);
  for (const std::uint32_t slot : segments_near(ray))
    if (filter(walls_.segments[slot]).verdict != FilteredHit::Verdict::missed)
      every.offers().offer(walls_.segment_numbers[slot]);
  for (const std::uint32_t surface : curves_.near(ray)) every.offers().offer(surface);
  return every.hits();
}

NearestHit CellSearch::nearest(const Ray& ray, const Left& left, bool tangents) const {
  if (ray.direction == Vec2(0, 0)) {
    ExactNearest search(walls_, ray, left, tangents);
    search.offer_all();
    return search.hit();
  }
  Rivals rivals(walls_, listed_, ray, left);
  gather(walls_, listed_, grid_, ray, rivals);
  return rivals.decide(ray, tangents, curves_);
}

std::size_t CellSearch::tested(const Ray& ray, const Left& left) const {
  if (ray.direction == Vec2(0, 0)) return walls_.size();
  Rivals rivals(walls_, listed_, ray, left);
  gather(walls_, listed_, grid_, ray, rivals);
  return rivals.tested() + rivals.curved(ray, curves_).tested;
}

}  // namespace flatray
