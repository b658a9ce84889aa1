#pragma once
#include <vector>

#include "trace/hits.h"
#include "trace/segment_filter.h"

namespace flatray {

/// The walls that may be the first of one ray, as far as bounds can say, and the exact choice among
/// them. Walkers of cells and lanes yield candidates; whatever they offer, the answer is that of
/// ExactNearest for all of it.
class Candidates {
 public:
  /// Needs   `walls`, `ray` and `departed` to outlive it; a direction that is not zero. What is surely
  ///         met later than `limit` is no candidate.
  Candidates(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed,
             double limit = kInfinity)
      : walls_(walls), ray_(ray), departed_(departed), filter_(ray), high_(limit) {}

  /// A segment that the ray has not left.
  void offer_segment(std::uint32_t slot);
  void offer_curve(std::uint32_t surface);
  /// Nothing met later can be the first.
  double latest() const { return high_; }
  bool settled(double t) const { return high_ < t; }
  /// Walls offered, those in several cells once for each.
  std::size_t tested() const { return tested_; }

  /// The first of them.
  NearestHit first(bool tangents);

 private:
  struct Candidate {
    std::uint32_t surface;
    FilteredHit hit;
  };
  bool is_known(std::uint32_t surface) const;
  bool is_out(const FilteredHit& hit) const;
  void take(std::uint32_t surface, const FilteredHit& hit);

  const Surfaces& walls_;
  const Ray& ray_;
  const DepartedSurface& departed_;
  const SegmentFilter filter_;
  std::vector<Candidate> open_;
  double high_;
  std::size_t tested_ = 0;
};

}  // namespace flatray
