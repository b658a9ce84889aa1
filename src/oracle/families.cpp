#include "oracle/families.h"

namespace flatray::oracle {

double nudge(double x, Draw& draw) {
  const double way = draw.below(3);
  return way == 0 ? x : std::nextafter(x, way == 1 ? -kInfinity : kInfinity);
}
Vec2 nudge(const Vec2& v, Draw& draw) {
  const double x = nudge(v.x(), draw);
  return {x, nudge(v.y(), draw)};
}

Surfaces AimedScene::surfaces() const {
  Surfaces all;
  const auto add_curves = [&] {
    for (const Arc& arc : curves) all.add(arc);
  };
  if (curves_first) add_curves();
  for (const Segment& wall : walls) all.add(wall);
  if (!curves_first) add_curves();
  for (const Bezier& curve : beziers) all.add(curve);
  return all;
}

Move scaled(Draw& draw) {
  return {[factor = draw.power(-900, 900)](const Vec2& v) { return Vec2(v * factor); }};
}
Move moved_by(const Vec2& way) {
  return {[way](const Vec2& v) { return Vec2(v + way); }, true};
}
Move flattened(double thin) {
  return {[thin](const Vec2& v) { return Vec2(v.x(), v.y() * thin); }};
}

static void move_arc(Arc& arc, const Move& move) {
  const auto size = [&](const Vec2& v) { return move.moves_all ? v : move.place(v); };
  arc.curve = {move.place(arc.curve.centre), size(arc.curve.u), size(arc.curve.v)};
  if (arc.extent != Arc::Extent::half) arc.from = move.place(arc.from);
  arc.to = move.place(arc.to);
}

// Rays keep the points they lead to.
static void move_all(AimedScene& scene, const Move& move) {
  for (Segment& wall : scene.walls) wall = {move.place(wall.a), move.place(wall.b)};
  for (Arc& arc : scene.curves) move_arc(arc, move);
  for (Bezier& curve : scene.beziers) curve = mapped(curve, move.place);
  for (Ray& ray : scene.rays) {
    const Vec2 tip = move.place(ray.origin + ray.direction), origin = move.place(ray.origin);
    ray = {origin, tip - origin};
  }
}

std::span<const Family> families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> each = wall_families();
    for (const auto& more : {arc_families(), bezier_families(), mixed_families()})
      each.insert(each.end(), more.begin(), more.end());
    return each;
  }();
  return all;
}

AimedScene make_scene(const Family& family, Draw& draw) {
  const Move move = family.move != nullptr ? family.move(draw) : Move{};
  AimedScene scene = family.walls(draw);
  while (scene.rays.size() < kRaysAScene) scene.rays.push_back(family.ray(scene, draw));
  if (family.move != nullptr) move_all(scene, move);
  for (Arc& arc : scene.curves)  // ends may be rounded to one direction, which is no part
    if (arc.extent == Arc::Extent::between &&
        orientation(arc.curve.centre, arc.from, arc.to) == Sign::zero)
      arc = {arc.curve, Arc::Extent::whole, {0, 0}, {0, 0}};
  return scene;
}

AimedScene make_scene(const Family& family, std::uint64_t seed, std::uint64_t item) {
  Draw draw(seed, static_cast<std::uint64_t>(&family - families().data()), item);
  return make_scene(family, draw);
}

}  // namespace flatray::oracle
