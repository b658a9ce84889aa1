#include "app/answers/hit_report.h"

#include <fmt/core.h>

#include <algorithm>

#include "anim/world.h"
#include "geom/clip.h"
#include "geom/exact.h"
#include "scene/names.h"
#include "scene/outlines/outline.h"

namespace flatray {
namespace {

// Longer fractions say less than their decimals.
constexpr std::size_t kLongestFraction = 24;

std::string short_fraction(const Rational& value) {
  std::string text = value.text();
  if (text.size() > kLongestFraction || text.find('/') == std::string::npos) text.clear();
  return text;
}

// t at which the line of a ray meets the line of an edge: n.(p - o) / n.d with n = (e.y, -e.x).
// Needs   they are not parallel.
Rational exact_time(const NamedRay& named, const Segment& edge) {
  const Ray& ray = named.ray;
  const auto direction = [&](int axis) {
    return named.edge ? Rational(named.edge->b[axis]) - Rational(named.edge->a[axis])
                      : Rational(ray.direction[axis]);
  };
  const Rational nx = Rational(edge.b.y()) - Rational(edge.a.y());
  const Rational ny = Rational(edge.a.x()) - Rational(edge.b.x());
  const Rational numerator = nx * (Rational(edge.a.x()) - Rational(ray.origin.x())) +
                             ny * (Rational(edge.a.y()) - Rational(ray.origin.y()));
  return numerator / (nx * direction(0) + ny * direction(1));
}

// A convex piece in the world with the numbers its edges have in the shape as given.
struct Piece {
  std::vector<Vec2> vertices;
  std::span<const std::int32_t> edges;

  Piece(const Shape& shape, std::size_t piece, const Pose& place)
      : vertices(posed_piece(shape, piece, place)),
        edges(std::span(shape.edges).subspan(shape.begin[piece], vertices.size())) {}
  Segment edge(std::size_t i) const {
    return {vertices[i], vertices[i + 1 < vertices.size() ? i + 1 : 0]};
  }
  int number(int edge) const {
    return edge == kNoEdge ? kNoEdge : edges[static_cast<std::size_t>(edge)];
  }
};

// Where a ray meets an edge of a piece, exactly where that is short; "" of no edge.
std::string exact_text(const NamedRay& ray, const Piece& piece, int edge) {
  if (edge == kNoEdge) return "";
  return short_fraction(exact_time(ray, piece.edge(static_cast<std::size_t>(edge))));
}

HitStep as_step(const ClipStep& step, const NamedRay& ray, const Piece& piece) {
  const int number = piece.number(step.edge);
  HitStep out{.edge = number == kNoEdge ? std::nullopt : std::optional(number),
              .numerator = step.numerator,
              .denominator = step.denominator,
              .t = std::nullopt,
              .exact_t = "",
              .kind = step.kind < 0   ? "entering"
                      : step.kind > 0 ? "exiting"
                                      : "parallel",
              .candidate = {step.candidate.t_enter, step.candidate.t_exit},
              .empty = !step.candidate};
  if (step.kind == 0) return out;
  out.t = step.t;
  out.exact_t = exact_text(ray, piece, step.edge);
  return out;
}

HitReport clip_piece(const NamedRay& ray, std::string against, const Piece& piece, Range within) {
  HitReport report{ray, std::move(against), within, {}, {}, "", ""};
  const Ray clipped = ray.edge ? Ray{ray.edge->a, ray.edge->b} : ray.ray;  // as clip_edge() does
  const Vec2 velocity = ray.edge ? ray.edge->a : Vec2(0, 0);
  for (const ClipStep& step : clip_steps(clipped, piece.vertices, within, velocity))
    report.steps.push_back(as_step(step, ray, piece));
  report.hit = clip_convex(clipped, piece.vertices, within, velocity);
  report.exact_enter = exact_text(ray, piece, report.hit.edge_enter);
  report.exact_exit = exact_text(ray, piece, report.hit.edge_exit);
  report.hit.edge_enter = piece.number(report.hit.edge_enter);
  report.hit.edge_exit = piece.number(report.hit.edge_exit);
  return report;
}

}  // namespace

std::vector<NamedRay> edge_rays(const Scene& scene, const FrameState& state, std::uint32_t entity) {
  if (state.entities[entity].gone) return {};
  const Shape& shape = shape_of(scene, state.entities[entity]);
  const Pose place = entity_pose(state, entity);
  std::vector<OutlineEdge> edges = outline(shape);
  std::ranges::stable_sort(edges, {}, &OutlineEdge::number);
  std::vector<NamedRay> rays;
  const std::string name = entity_name(scene, entity);
  const auto add = [&](const char* what, auto number, const Segment& edge) {
    rays.push_back({fmt::format("{} {} {}", name, what, number), {edge.a, edge.b - edge.a}, edge});
  };
  for (const OutlineEdge& edge : edges)
    add("edge", edge.number, {place(shape.vertices[edge.from]), place(shape.vertices[edge.to])});
  for (std::size_t i = 0; i < shape.segments.size(); ++i)
    add("segment", i, {place(shape.segments[i].a), place(shape.segments[i].b)});
  for (const ArcPath& path : shape.arc_paths)
    for (const PathEdge& edge : path_in_world(path, place).edges)
      if (!edge.arc) add("edge", edge.number, {edge.from, edge.to});
  return rays;
}

std::vector<HitReport> hit_reports(const Scene& scene, const FrameState& state, const NamedRay& ray,
                                   std::uint32_t entity, Range within) {
  if (state.entities[entity].gone) return {};
  const Shape& shape = shape_of(scene, state.entities[entity]);
  const Pose place = entity_pose(state, entity);
  const std::string name = entity_name(scene, entity);
  std::vector<HitReport> reports;
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    reports.push_back(
        clip_piece(ray, shape.piece_count() == 1 ? name : fmt::format("{} piece {}", name, i),
                   Piece(shape, i, place), within));
  const auto add = [&](const char* what, std::size_t i, const HitInterval& hit) {
    reports.push_back({ray, fmt::format("{} {} {}", name, what, i), within, {}, hit, "", ""});
  };
  const auto clip = [&](const Ellipse& ellipse) {
    return ray.edge ? clip_edge(*ray.edge, ellipse, within)
                    : clip_ellipse(ray.ray, ellipse, within);
  };
  for (std::size_t i = 0; i < shape.circles.size(); ++i)
    add("circle", i, clip(posed(shape.circles[i], place)));
  std::size_t ellipses = 0, parts = 0;
  for (const ArcPath& path : shape.arc_paths) {
    if (path.is_ellipse()) {
      add("ellipse", ellipses++, clip(curve_of(path.arcs.front(), place)));
      continue;
    }
    std::vector<HitInterval> hits = clip_path(ray.ray, path_in_world(path, place), within);
    if (hits.empty()) hits.emplace_back();
    for (const HitInterval& hit : hits) add("part", parts++, hit);
  }
  for (std::size_t i = 0; i < shape.beziers.size(); ++i) {
    const Bezier curve = mapped(shape.beziers[i], place);
    std::vector<HitInterval> hits;
    if (is_on_one_line(curve))
      hits = {clip_segment(ray.ray, stretch_of(curve), within)};
    else
      hits = clip_curve(ray.ray, curve, within);
    if (hits.empty()) hits.emplace_back();
    for (const HitInterval& hit : hits) add("curve", i, hit);
  }
  for (std::size_t i = 0; i < shape.segments.size(); ++i) {
    const Segment segment{place(shape.segments[i].a), place(shape.segments[i].b)};
    add("segment", i,
        ray.edge ? clip_edge(*ray.edge, segment, within) : clip_segment(ray.ray, segment, within));
  }
  return reports;
}

}  // namespace flatray
