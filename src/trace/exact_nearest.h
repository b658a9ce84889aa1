#pragma once
#include <optional>
#include <vector>

#include "geom/hit_time.h"
#include "trace/hits.h"

namespace flatray {

/// The nearest of the walls offered to one ray, decided without rounding; equal times go to the
/// lowest number, whatever the order of the offers. The one place where hits of two walls at rest are
/// compared: every exact tracer ends here where its bounds leave a doubt.
class ExactNearest {
 public:
  /// Needs   `walls` and what `departed` names to outlive it. `all`: keeps every hit, for hits().
  ExactNearest(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed,
               bool tangents, bool all = false);

  /// Offers a wall; what the ray does not meet, or has just left, changes nothing.
  void offer(std::uint32_t surface);
  void offer_all();

  NearestHit hit() const;
  /// Its exact t; none where there is no hit, or the direction is zero.
  const std::optional<HitTime>& time() const { return best_time_; }
  /// All of them, by t, equal t by number; of a curve the earlier root first.
  std::vector<NearestHit> hits();

 private:
  void offer(const NearestHit& hit, const HitTime& time);
  void offer_point_test(std::uint32_t number, PlaceOn place);

  const Surfaces& walls_;
  Ray ray_;
  DepartedSurface departed_;
  bool tangents_, point_test_;
  NearestHit best_;
  std::optional<HitTime> best_time_;
  std::vector<WallMeeting> met_;  // of the wall offered
  struct Timed {
    NearestHit hit;
    std::optional<HitTime> time;
  };
  const bool all_;
  std::vector<Timed> every_;  // where all are kept
};

/// The hit of a wall known to be the nearest, crossed ahead and between its ends, in a root of a curve.
NearestHit crossing_hit(const Surfaces& walls, const Ray& ray, std::uint32_t surface, Root root);

}  // namespace flatray
