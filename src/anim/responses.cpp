#include "anim/responses.h"

#include <algorithm>
#include <cmath>

namespace flatray {

const Stage& stage_at(std::span<const Stage> stages, double time) {
  const auto after = std::upper_bound(stages.begin(), stages.end(), time,
                                      [](double t, const Stage& s) { return t < s.from; });
  return after == stages.begin() ? stages.front() : *(after - 1);
}

Vec2 place_at(std::span<const Stage> stages, double time) {
  const Stage& stage = stage_at(stages, time);
  return stage.at + (time - stage.from) * stage.velocity;
}

Vec2 sizes_of_place(const Stage& stage, double time) {
  return stage.at.cwiseAbs() +
         (std::fabs(time) + std::fabs(stage.from)) * stage.velocity.cwiseAbs();
}

}  // namespace flatray
