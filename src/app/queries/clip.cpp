#include "geom/clip.h"

#include "app/query/query.h"

namespace flatray::clip_query {
namespace {

JsonValue edge(int number) { return number == kNoEdge ? JsonValue() : JsonValue(number); }

Fields answer(Question& question) {
  const Ray ray = question.ray();
  const Range within = question.domain("line", "ray", "segment");
  HitInterval hit;
  if (question.has("disc")) {
    const Circle disc = question.disc("disc");
    if (question.has("polygon")) {
      question.polygon("polygon");
      question.mistake("disc", "does not go with a polygon");
    }
    hit = clip_circle(ray, disc, within);
  } else {
    const std::vector<Vec2> corners = question.polygon("polygon");
    // Only a convex polygon may be clipped.
    if (!question.sound()) return {};
    hit = clip_convex(ray, corners, within);
  }
  Fields fields = {{"class", name(hit.kind)},
                   {"t_enter", interval_end(hit, hit.t_enter)},
                   {"t_exit", interval_end(hit, hit.t_exit)},
                   {"edge_enter", edge(hit.edge_enter)},
                   {"edge_exit", edge(hit.edge_exit)},
                   {"start", name(hit.start)}};
  if (hit.enter_overflows || hit.exit_overflows) fields.emplace_back("overflow", true);
  return fields;
}

}  // namespace

extern const Query entry = {
    "clip", "the part of a ray, line or segment inside a convex polygon or disc", &answer};

}  // namespace flatray::clip_query
