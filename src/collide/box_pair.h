#pragma once
#include <vector>

#include "collide/turning_pair.h"

namespace flatray {

// Two bodies of several parts each, as the upright boxes around them meet.
class BoxPair {
 public:
  BoxPair(std::span<const TurningBody> a, std::span<const TurningBody> b, double length,
          bool backwards);

  void place(double now) {
    for (TurningPair& pair : pairs_) pair.place(now);
  }
  double apart_for(double enough) const;
  double overlap_for() const;
  ContactPlace touching_place() const;
  double scale() const { return 1; }

 private:
  std::vector<TurningPair> pairs_;
};

}  // namespace flatray
