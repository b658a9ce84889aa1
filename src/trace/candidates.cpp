#include "trace/candidates.h"

#include <algorithm>

#include "trace/curve_filter.h"
#include "trace/exact_nearest.h"

namespace flatray {

// Cells that list a wall again mostly follow each other; among more, to look for it at once would
// take the square of their number.
bool Candidates::is_known(std::uint32_t surface) const {
  constexpr std::ptrdiff_t kRecent = 16;
  const auto recent = open_.end() - std::min(std::ssize(open_), kRecent);
  return std::any_of(recent, open_.end(),
                     [&](const Candidate& other) { return other.surface == surface; });
}

void Candidates::take(const Candidate& candidate, double high) {
  open_.push_back(candidate);
  if (!candidate.sure || !(high < high_)) return;
  high_ = high;
  std::erase_if(open_, [&](const Candidate& other) { return other.low > high_; });
}

void Candidates::offer_segment(std::uint32_t slot) {
  ++tested_;
  const FilteredHit hit = filter_(walls_.segments[slot]);
  if (hit.verdict == FilteredHit::Verdict::missed || hit.low > high_) return;
  const std::uint32_t surface = walls_.segment_numbers[slot];
  if (is_known(surface)) return;
  take({surface, hit.low, hit.verdict == FilteredHit::Verdict::sure, Root::none}, hit.high);
}

void Candidates::offer_curve(std::uint32_t surface) {
  if (is_known(surface)) return;
  ++tested_;
  const Root left = surface == departed_.surface ? departed_.root : Root::none;
  const FilteredHit hit =
      walls_.visit(surface, [&](const auto& wall) { return filter_curve(ray_, wall, left); });
  if (hit.verdict == FilteredHit::Verdict::missed || hit.low > high_) return;
  take({surface, hit.low, hit.verdict == FilteredHit::Verdict::sure, hit.root}, hit.high);
}

NearestHit Candidates::first(bool tangents) {
  if (open_.empty()) return {};
  std::sort(open_.begin(), open_.end(),
            [](const Candidate& a, const Candidate& b) { return a.surface < b.surface; });
  open_.erase(
      std::unique(open_.begin(), open_.end(),
                  [](const Candidate& a, const Candidate& b) { return a.surface == b.surface; }),
      open_.end());
  if (const Candidate& only = open_.front(); open_.size() == 1 && only.sure)
    return crossing_hit(walls_, ray_, only.surface, only.root);
  ExactNearest search(walls_, ray_, departed_, tangents);
  for (const Candidate& candidate : open_) search.offer(candidate.surface);
  return search.hit();
}

}  // namespace flatray
