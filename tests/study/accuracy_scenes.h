#pragma once

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

}  // namespace flatray::testing
