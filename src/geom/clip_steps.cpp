#include <algorithm>

#include "geom/clip.h"
#include "geom/clip_range.h"
#include "geom/decide.h"
#include "geom/polygon.h"

namespace flatray {
namespace {

// The candidate interval as the paper keeps it: edge after edge.
class Candidate {
 public:
  explicit Candidate(Range within) : within_(within) { line_.kind = HitClass::through; }

  // `inside` is the sign of the numerator, `way` that of the denominator.
  void add(int edge, Sign inside, Sign way, const HitTime& time) {
    start_ = std::min(start_, start_place(inside));
    if (way == Sign::negative && (!line_.enter || compare(time, *line_.enter) > 0)) {
      line_.enter = time;
      line_.edge_enter = edge;
    }
    if (way == Sign::positive && (!line_.exit || compare(time, *line_.exit) < 0)) {
      line_.exit = time;
      line_.edge_exit = edge;
    }
    if (way != Sign::zero) return;
    if (inside == Sign::negative) line_.kind = HitClass::miss;
    if (inside == Sign::zero && line_.kind == HitClass::through) line_.kind = HitClass::along;
  }

  HitInterval interval() const {
    LineHit line = line_;
    if (line.enter && line.exit && line.kind != HitClass::miss) {
      const auto order = compare(*line.enter, *line.exit);
      if (order > 0) line.kind = HitClass::miss;
      if (order == 0) line.kind = HitClass::touch;
    }
    HitInterval hit = clip_to_range(line, within_);
    hit.start = start_;
    return hit;
  }

 private:
  LineHit line_;
  Range within_;
  StartPlace start_ = StartPlace::inside;
};

// The row of one edge; `turn` is negative for a clockwise polygon, whose normals it turns outward.
ClipStep step_of_edge(const Ray& ray, const Vec2& velocity, const Segment& edge, Sign turn) {
  const double way = turn == Sign::negative ? -1 : 1;
  const auto numer = [&](const auto& number) {
    return determinant(number, ray.origin, edge.a, edge.a, edge.b) * number(way);
  };
  const auto denom = [&](const auto& number) {
    return determinant(number, velocity, ray.direction, edge.a, edge.b) * number(way);
  };
  ClipStep step{};
  step.numerator = round_once(numer);
  step.denominator = round_once(denom);
  step.kind = static_cast<int>(decide(denom));
  return step;
}

}  // namespace

std::vector<ClipStep> clip_steps(const Ray& ray, std::span<const Vec2> vertices, Range within,
                                 const Vec2& velocity) {
  std::vector<ClipStep> steps;
  const Sign turn = ring_orientation(vertices);
  Candidate candidate(within);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Segment edge{vertices[i], edge_end(vertices, i)};
    if (edge.a == edge.b) continue;
    const Sign side = orientation(edge.a, edge.b, ray.origin);
    ClipStep step = step_of_edge(ray, velocity, edge, turn);
    const HitTime time = HitTime::on_line(ray, edge.a, edge.a, edge.b, velocity);
    if (step.kind != 0) step.t = time.nearest().t;
    step.edge = static_cast<int>(i);
    candidate.add(step.edge, turn == Sign::negative ? -side : side, static_cast<Sign>(step.kind),
                  time);
    step.candidate = candidate.interval();
    steps.push_back(step);
    if (step.candidate.kind == HitClass::miss) break;
  }
  // A polygon without area also ends where its edges do, and the last row is always the answer.
  if (!steps.empty() && steps.back().candidate)
    steps.back().candidate = clip_convex(ray, vertices, within, velocity);
  return steps;
}

}  // namespace flatray
