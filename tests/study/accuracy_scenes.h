#pragma once
#include "base/entry_named.h"
#include "study/accuracy/accuracy.h"

namespace flatray::testing {

/// A small box flies over a thin wall between two frames, and past a triangle whose box it enters.
inline constexpr const char* kBullet = R"(
[[entity]]
shape    = { box = { min = [0, 4], max = [0.25, 4.25] } }
velocity = [15.5, 0]
[[entity]]
shape = { box = { min = [8, 0], max = [8.125, 8] } }
[[entity]]
shape = { polygon = { points = [[14, 0], [18, 0], [14, 4.5]] } }
at    = [0, 4.125]
[[entity]]
shape = { polygon = { points = [[24, 3.5], [24, 16], [12, 16]] } }
)";

/// What a choice comes to on a scene; nothing where this build has none of that name.
inline ChoiceReport report_of(std::string_view name, const Scene& scene, double seconds = 10) {
  const Choice* choice = entry_named(choices(), name);
  return choice == nullptr ? ChoiceReport() : measure_choice(*choice, {scene, 1, 1, seconds});
}

/// What settings made up for a test come to, of any scene.
inline ChoiceReport report_of(Result<ChoiceSettings> (*settings)(const AccuracyContext&),
                              double seconds) {
  const Choice choice{"made up", "?", ErrorKind::truncation,
                      [](const Scene&) { return std::string(); }, settings};
  const Scene scene;
  return measure_choice(choice, {scene, 1, 1, seconds});
}

}  // namespace flatray::testing
