#pragma once
#include <vector>

#include "render/light/light_run.h"
#include "support/pictures.h"

namespace flatray {

// The fluence of a frame by its pixels, and what became of the light.
struct Fluence {
  int width, height;
  std::vector<double> rgb;
  LightCounts counts;

  double at(int x, int y, int channel = 0) const {
    return rgb[static_cast<std::size_t>(3 * (y * width + x) + channel)];
  }
  double sum() const {
    double all = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) all += rgb[i];
    return all;
  }
};

// The light of the first frame.
inline TracedLight traced(const Scene& scene, const LightGoal& goal = {}, TracedLight so_far = {},
                          std::uint64_t seed = 0, unsigned threads = 1) {
  const Timeline timeline(scene, seed, 1);
  return trace_frame_light(scene, at(timeline, 1), nullptr, seed, threads, nullptr, goal,
                           std::move(so_far));
}

inline Fluence fluence(const Scene& scene, unsigned threads = 1, std::uint64_t seed = 0) {
  const TracedLight light = traced(scene, {}, {}, seed, threads);
  Fluence made{scene.film.width, scene.film.height, {}, light.counts};
  for (const std::int64_t sum : light.sums())
    made.rgb.push_back(static_cast<double>(sum) * light.unit());
  return made;
}

// A film of 64 by 64 pixels from (-4, -4) to (4, 4).
inline Scene lit(const std::string& rest, const std::string& light = "rays = 65536") {
  return scene_of("flatray = 1\nfilm = { size = [64, 64], world = [[-4, -4], [4, 4]] }\n[light]\n" +
                  light + "\n" + rest);
}

// All that became of it.
inline std::int64_t accounted(const LightCounts& counts) {
  return counts.absorbed + counts.escaped + counts.at_corners + counts.cut_off + counts.gambled;
}

}  // namespace flatray
