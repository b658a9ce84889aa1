#include "transport/light/seen_lamps.h"

#include <cmath>
#include <numbers>

#include "geom/predicates.h"

namespace flatray {
namespace {

LightSum light_of(const LampState& lamp, double power) {
  return {power * lamp.colour[0], power * lamp.colour[1], power * lamp.colour[2]};
}

Vec2 to_local(const Pose& pose, const Vec2& world) {
  const Vec2 out = (world - pose.at) / pose.scale;
  return {pose.cos * out.x() + pose.sin * out.y(), pose.cos * out.y() - pose.sin * out.x()};
}

// As the ends of arcs are: so small, and so far away, that the doubles do not tell their directions apart, they are
// those of a chord, or of nearly all of the circle.
void add(Surfaces& lines, const LampLine& line, const Pose& pose) {
  const Segment ends{pose(line.ends.a), pose(line.ends.b)};
  std::optional<Circle> circle;
  if (line.circle) circle = {pose(line.circle->centre), pose.length(line.circle->radius)};
  const bool alike = circle && !line.whole && lie_in_one_direction(circle->centre, ends.a, ends.b);
  const bool whole = line.whole || (alike && line.length > std::numbers::pi * line.circle->radius);
  if (!circle || (alike && !whole))
    lines.add(ends);
  else
    lines.add(Arc{*circle, whole ? Arc::Extent::whole : Arc::Extent::between, ends.a, ends.b});
}

constexpr double kPlaceRounding = 0x1p-48;  // of the places of a lamp and its walls, in groups, too

// Whether one lies on the line or curve of the other, as far as rounding of up to `reach` tells.
template <class One, class Other>
bool lies_near(const One&, const Other&, double) {
  return false;
}
bool lies_near(const Segment& one, const Segment& other, double reach) {
  const Vec2 along = one.b - one.a, beside = other.b - other.a;
  if (along.stableNorm() < beside.stableNorm()) return lies_near(other, one, reach);
  const Vec2 unit = along.stableNormalized();
  const auto is_near = [&](const Vec2& end) { return std::abs(cross(unit, end - one.a)) <= reach; };
  return is_near(other.a) && is_near(other.b);
}
bool lies_near(const Arc& one, const Arc& other, double reach) {
  const Ellipse &a = one.curve, &b = other.curve;
  return b.is_circle() && (a.centre - b.centre).cwiseAbs().maxCoeff() <= reach &&
         std::abs(a.u.stableNorm() - b.u.stableNorm()) <= reach;
}

}  // namespace

WallsBeside walls_beside(const LampState& lamp, const Surfaces& walls) {
  const std::optional<LampLine> line = lamp.emitter->starts();
  if (!line) return {};
  Surfaces alone;
  add(alone, *line, lamp.pose);
  const Bounds box = bounds_of(alone);
  const double far =
      box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).cwiseMax(lamp.pose.at.cwiseAbs()).maxCoeff();
  WallsBeside beside{{}, kPlaceRounding * (far + box.size().maxCoeff())};
  for (std::uint32_t wall = 0; wall < walls.size(); ++wall)
    if (walls.visit(wall, [&](const auto& other) {
          return alone.visit(0,
                             [&](const auto& own) { return lies_near(own, other, beside.reach); });
        }))
      beside.walls.push_back(wall);
  return beside;
}

std::vector<WallsBeside> walls_beside(std::span<const LampState> lamps, const Surfaces& walls) {
  std::vector<WallsBeside> all;
  for (const LampState& lamp : lamps) all.push_back(walls_beside(lamp, walls));
  return all;
}

SeenLamps::SeenLamps(std::span<const LampState> lamps, const LitWalls& walls)
    : lamps_(lamps), walls_(walls) {
  for (const LampState& lamp : lamps) {
    const std::optional<LampLine> line = lamp.emitter->line();
    if (!line) continue;
    add(lines_, *line, lamp.pose);
    // A side sends out twice its radiance from each unit of length: the cosine over all angles.
    const double sides = line->left && line->right ? 2 : 1;
    glows_.push_back({light_of(lamp, lamp.power / (2 * sides * lamp.pose.length(line->length))),
                      line->left, line->right});
  }
  if (any_lines()) tracer_ = choose_tracer(lines_).tracer->build(lines_);
}

std::optional<SeenLamps::Sighted> SeenLamps::sight(std::size_t lamp, const Vec2& at) const {
  const LampState& state = lamps_[lamp];
  const std::optional<Sight> sight = state.emitter->sight(to_local(state.pose, at));
  if (!sight || !std::isfinite(sight->fluence)) return std::nullopt;
  return Sighted{state.pose(sight->from),
                 light_of(state, state.power * sight->fluence / state.pose.scale)};
}

// A lamp on a wall shines to both sides of it, and from corners not at all.
std::array<float, 3> SeenLamps::passes(const Vec2& from, const Ray& ray,
                                       const DepartedSurface& departed, const NearestHit& first,
                                       std::uint32_t most) const {
  constexpr std::array<float, 3> kNone{0, 0, 0};
  const Surfaces& walls = walls_.walls();
  const std::vector<std::uint32_t> on = walls_.walls_at(from);
  if (on.size() > 1 || (on.size() == 1 && is_end(walls, on.front(), from))) return kNone;
  const auto arrives = [&](const NearestHit& hit) {
    if (on.empty() || hit.surface != on.front()) return !is_before(walls, ray, hit, from);
    const Root met = root_departed_by(root_stood_on(walls, on.front(), {from, -ray.direction}));
    return met == Root::both ? hit.root == met : enters(hit.root) == enters(met);
  };
  std::array<float, 3> passed{1, 1, 1};
  if (!first || arrives(first)) return passed;
  const auto pass = [&](const NearestHit& hit) {
    const LightShares* shares = walls_.shares(hit.surface);
    return shares == nullptr || hit.at_end ? 0 : shares->pass;
  };
  if (pass(first) == 0) return kNone;
  for (const NearestHit& hit : walls_.tracer().all_of_one(ray, departed, false)) {
    if (arrives(hit)) break;
    const auto part = static_cast<float>(pass(hit));
    if (part == 0 || most-- == 0) return kNone;
    for (std::size_t c = 0; c < 3; ++c) passed[c] *= part * walls_.shares(hit.surface)->tint[c];
  }
  return passed;
}

void SeenLamps::add_lines(std::span<const LightRay> rays, std::span<const LightHit> met,
                          std::span<LightSum> radiance) const {
  RayBatch batch;
  batch.tangents = false;
  for (const LightRay& ray : rays) batch.add(ray.ray);
  std::vector<NearestHit> nearest(rays.size());
  tracer_->nearest(batch, nearest);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!nearest[i] || nearest[i].t > met[i].hit.t) continue;
    for (const NearestHit& hit : tracer_->all_of_one(rays[i].ray, {}, false)) {
      if (hit.t > met[i].hit.t) break;
      if (hit.t == 0 && rays[i].departed.surface != kNoSurface)
        continue;  // seen as the path came there
      const Glow& glow = glows_[hit.surface];
      // From the left of a segment, or the inside of an arc.
      const Sign left = lines_.visit(hit.surface, [](const auto& line) { return inside_of(line); });
      if (!(inner_side(lines_, rays[i].ray, hit) == left ? glow.left : glow.right)) continue;
      const LightSum there = walls_.bodies().left_after(hit.t, rays[i].media);
      for (std::size_t c = 0; c < 3; ++c) radiance[i][c] += glow.radiance[c] * there[c];
    }
  }
}

}  // namespace flatray
