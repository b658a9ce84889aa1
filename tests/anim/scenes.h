#pragma once
#include "anim/frame_state.h"

// Scenes made by hand: what the scene module would build, small enough to check by eye.
namespace flatray::testing {

/// One convex piece; edge i of the input runs from vertex i.
inline Shape polygon(std::vector<Vec2> vertices) {
  Shape shape;
  shape.begin.push_back(static_cast<std::uint32_t>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    shape.edges.push_back(static_cast<std::int32_t>(i));
  shape.vertices = std::move(vertices);
  return shape;
}

inline Shape box(const Vec2& low, const Vec2& high) {
  return polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

/// A film of 200 x 100 pixels on the window [0, 20] x [0, 10], one frame a second.
inline Scene small_scene() {
  Scene scene;
  scene.film.width = 200;
  scene.film.height = 100;
  scene.film.world = Bounds{{0, 0}, {20, 10}};
  scene.fps = 1;
  return scene;
}

/// Adds an entity that is a unit box at `at`; its number.
inline std::uint32_t add_box(Scene& scene, const Vec2& at, const Vec2& velocity = {0, 0}) {
  scene.shapes.push_back(box({0, 0}, {1, 1}));
  Entity entity;
  entity.shape = static_cast<ShapeId>(scene.shapes.size() - 1);
  entity.at = at;
  entity.velocity = velocity;
  entity.material = Material::absorb;
  scene.entities.push_back(entity);
  return static_cast<std::uint32_t>(scene.entities.size() - 1);
}

/// A chain from cumulative probabilities: rows of (cumulative, to), the last of each row
/// reaching 1.
struct Step {
  double cumulative;
  StateId to;
};
inline MarkovChain chain(std::vector<std::string> states, std::vector<std::vector<Step>> rows) {
  MarkovChain made;
  made.name = "chain";
  made.states = std::move(states);
  for (const std::vector<Step>& row : rows) {
    made.rows.emplace_back();
    for (const Step& step : row)
      made.rows.back().push_back({step.cumulative == 1
                                      ? ~std::uint64_t{0}
                                      : static_cast<std::uint64_t>(step.cumulative * 0x1p64) - 1,
                                  step.to});
  }
  return made;
}

/// The paper's chain, the rest of RUNNING sent to the start state.
inline MarkovChain runner_chain() {
  return chain({"STANDING", "RUNNING", "JUMP", "DIE"}, {{{0.10, 0}, {0.95, 1}, {1, 3}},
                                                        {{0.09, 0}, {0.69, 1}, {0.99, 2}, {1, 3}},
                                                        {{0.25, 2}, {1, 3}},
                                                        {{1, 3}}});
}

/// A state that lasts for ever.
inline MarkovChain still_chain() { return chain({"STAY"}, {{{1, 0}}}); }

/// A <-> B, every draw changes the state.
inline MarkovChain flip_chain() { return chain({"A", "B"}, {{{1, 1}}, {{1, 0}}}); }

inline Look moving(const Vec2& velocity) {
  Look look;
  look.velocity = velocity;
  return look;
}

}  // namespace flatray::testing
