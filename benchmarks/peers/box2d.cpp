#include "peers/box2d.h"

#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <array>
#include <vector>

namespace bench {

struct Box2dPairs::Inputs {
  struct Pair {
    b2PolygonShape a, b;
    b2Sweep sweep_a, sweep_b;
  };
  std::vector<Pair> pairs;
};

namespace {

using flatray::Vec2;

b2Vec2 vector(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

b2PolygonShape shape(std::span<const Vec2> vertices) {
  std::array<b2Vec2, b2_maxPolygonVertices> points;
  for (std::size_t i = 0; i < vertices.size(); ++i) points[i] = vector(vertices[i]);
  b2PolygonShape made;
  made.Set(points.data(), static_cast<int32>(vertices.size()));
  return made;
}

b2Sweep sweep(const Vec2& velocity) {
  b2Sweep made{};
  made.localCenter.SetZero();
  made.c0.SetZero();
  made.c = vector(velocity);
  made.a0 = made.a = 0;
  made.alpha0 = 0;
  return made;
}

}  // namespace

Box2dPairs::Box2dPairs() : inputs_(std::make_unique<Inputs>()) {}
Box2dPairs::Box2dPairs(Box2dPairs&&) noexcept = default;
Box2dPairs::~Box2dPairs() = default;

void Box2dPairs::add(std::span<const Vec2> a, const Vec2& velocity_a, std::span<const Vec2> b,
                     const Vec2& velocity_b) {
  inputs_->pairs.push_back({shape(a), shape(b), sweep(velocity_a), sweep(velocity_b)});
}

double Box2dPairs::first_time(std::size_t pair) const {
  const Inputs::Pair& asked = inputs_->pairs[pair];
  b2TOIInput input;
  input.proxyA.Set(&asked.a, 0);
  input.proxyB.Set(&asked.b, 0);
  input.sweepA = asked.sweep_a;
  input.sweepB = asked.sweep_b;
  input.tMax = 1;
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input);
  const bool meet =
      output.state == b2TOIOutput::e_touching || output.state == b2TOIOutput::e_overlapped;
  return !meet ? 2 : output.state == b2TOIOutput::e_overlapped ? 0 : static_cast<double>(output.t);
}

}  // namespace bench
