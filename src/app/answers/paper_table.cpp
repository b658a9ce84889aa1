#include "app/answers/paper_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/options/arguments.h"
#include "collide/contact.h"
#include "geom/clip.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

// The pieces of the sides that the paper takes for rays: 25 are cut off at some ends.
constexpr double kCut = 25;
std::array<Segment, 4> paper_rays(const Ring& b) {
  return {Segment{b[0] + Vec2(kCut, 0), b[1]}, Segment{b[1] + Vec2(0, kCut), b[2] - Vec2(0, kCut)},
          Segment{b[2], b[3]}, Segment{b[3] - Vec2(0, kCut), b[0] + Vec2(0, kCut)}};
}

// What is printed in table 5.
struct Printed {
  const char* tmp;
  int numer, denom;
  const char* status;
};
constexpr Printed kPrinted[] = {{"(635, 178)", -6942, 0, "parallel"},
                                {"(635, 178)", 49530, 0, "parallel"},
                                {"(635, 178)", 11392, 0, "parallel"},
                                {"(635, 178)", -49530, 0, "parallel"}};

std::string status(double numer, double denom) {
  if (denom == 0) return numer < 0 ? "parallel, outside: miss" : "parallel, inside";
  return denom < 0 ? "entering" : "exiting";
}

bool has_box(const Scene& scene, const Ring& box) {
  return std::ranges::any_of(scene.entities, [&](const Entity& entity) {
    const Shape& shape = scene.shapes[entity.shape];
    if (shape.piece_count() != 1 || shape.vertices.size() != box.size()) return false;
    for (std::size_t i = 0; i < box.size(); ++i)
      if (shape.vertices[i] + entity.at != box[i]) return false;
    return true;
  });
}

// A table of the paper for people and as JSON.
struct Shown {
  std::string text;
  Table rows;
};

Shown table_four(const std::array<Segment, 4>& of_one, const std::array<Segment, 4>& of_two) {
  Shown shown{
      "table 4: the rays, all right as numbers; they are pieces of the sides, with 25 cut off at "
      "some ends,\n"
      "and leave gaps at three corners\n"
      "edge  box 1: from -> to              edge, normal            box 2: from -> to\n",
      Table({"edge", "box_1_from", "box_1_to", "box_1_edge", "box_1_normal", "box_2_from",
             "box_2_to"})};
  const auto way = [](const Segment& s) { return point_text(s.a) + " -> " + point_text(s.b); };
  for (std::size_t i = 0; i < of_one.size(); ++i) {
    const Segment &one = of_one[i], &two = of_two[i];
    const Vec2 e = one.b - one.a, normal(e.y(), -e.x() + 0.0);
    shown.rows.add({std::uint64_t{i}, as_value(one.a), as_value(one.b), as_value(e),
                    as_value(normal), as_value(two.a), as_value(two.b)});
    shown.text += fmt::format("{:>4}  {:<30} {:<23} {}\n", i, way(one),
                              point_text(e) + ", " + point_text(normal), way(two));
  }
  return shown;
}

Shown table_five(const Segment& ray, const std::array<Segment, 4>& edges) {
  Shown shown{
      "\ntable 5: the first ray of box 1 against the edges of box 2, as printed | as it must be\n"
      "edge  tmp                      numer            denom       t       status\n",
      Table({"edge", "printed", "tmp", "numer", "denom", "t", "status"})};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2 e = edges[i].b - edges[i].a, normal(e.y(), -e.x()), tmp = edges[i].a - ray.a;
    const double numer = normal.dot(tmp), denom = normal.dot(ray.b - ray.a) + 0.0;
    const auto t = denom == 0 ? std::nullopt : std::optional(numer / denom);
    const auto& [printed_tmp, printed_numer, printed_denom, printed_status] = kPrinted[i];
    shown.rows.add({std::uint64_t{i},
                    Fields{{"tmp", printed_tmp},
                           {"numer", printed_numer},
                           {"denom", printed_denom},
                           {"status", printed_status}},
                    as_value(tmp), numer, denom, t, status(numer, denom)});
    shown.text +=
        fmt::format("{:>4}  {:<10} | {:<10}  {:>6} | {:<6}  {} | {:<5}  {:<6}  {} | {}\n", i,
                    printed_tmp, point_text(tmp), printed_numer, numer, printed_denom, denom,
                    t ? fmt::format("{:.4f}", *t) : "-", printed_status, status(numer, denom));
  }
  shown.text +=
      "Each printed denominator is a normal against its own edge, so 0; the printed tmp is that "
      "of edge 0\n"
      "for all edges. Wrong as numbers: 3 of 4 numerators, 2 of 4 denominators, 2 of 4 kinds of "
      "edge.\n";
  return shown;
}

int misses(const Ring& from, const Ring& against) {
  int count = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!clip_edge({from[i], from[(i + 1) % from.size()]}, against)) ++count;
  return count;
}

}  // namespace

Result<VerbOutput> paper_tables(const Scene& scene, const Place& where) {
  const Ring one = box(250, 200, 314, 328), two = box(885, 378, 949, 506);
  if (!has_box(scene, one) || !has_box(scene, two))
    return usage_error(where, "the tables are of the paper's two boxes, which this scene has not",
                       "flatray collide scenes/paper/case_two.toml --table");
  const std::array<Segment, 4> rays_one = paper_rays(one), rays_two = paper_rays(two);
  const Shown four = table_four(rays_one, rays_two), five = table_five(rays_one[0], rays_two);
  const int misses_of_one = misses(one, two), misses_of_two = misses(two, one);
  const Vec2 velocity(635, 178);
  const HitInterval met = contact({one, velocity}, {two, {0, 0}}).times;
  return VerbOutput{
      .text = {four.text + five.text +
               fmt::format(
                   "\nat rest {} of 4 sides of box 1 miss box 2, and {} of 4 of box 2 miss box 1: "
                   "no hit.\n"
                   "The paper has no velocity, so no hit time. Box 1 moving (635, 178) meets box 2 "
                   "at\n"
                   "t = {} = 571/635 and leaves it at t = {} = 699/635.\n",
                   misses_of_one, misses_of_two, met.t_enter, met.t_exit)},
      .results = Fields{{"table_4", four.rows},
                        {"table_5", five.rows},
                        {"at_rest", Fields{{"sides_of_box_1_that_miss", misses_of_one},
                                           {"sides_of_box_2_that_miss", misses_of_two}}},
                        {"moving", Fields{{"velocity_of_box_1", as_value(velocity)},
                                          {"t_first", met.t_enter},
                                          {"t_last", met.t_exit}}}}};
}

}  // namespace flatray
