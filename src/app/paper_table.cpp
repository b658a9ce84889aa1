#include "app/paper_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/arguments.h"
#include "collide/contact.h"
#include "geom/cyrus_beck.h"

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
  return std::any_of(scene.entities.begin(), scene.entities.end(), [&](const Entity& entity) {
    const Shape& shape = scene.shapes[entity.shape];
    if (shape.piece_count() != 1 || shape.vertices.size() != box.size()) return false;
    for (std::size_t i = 0; i < box.size(); ++i)
      if (shape.vertices[i] + entity.at != box[i]) return false;
    return true;
  });
}

std::string table_four(const std::array<Segment, 4>& one, const std::array<Segment, 4>& two) {
  std::string text =
      "table 4: the rays, all right as numbers; they are pieces of the sides, with 25 cut off at "
      "some ends,\n"
      "and leave gaps at three corners\n"
      "edge  box 1: from -> to              edge, normal            box 2: from -> to\n";
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 e = one[i].b - one[i].a;
    const auto way = [](const Segment& s) {
      return fmt::format("({}, {}) -> ({}, {})", s.a.x(), s.a.y(), s.b.x(), s.b.y());
    };
    text += fmt::format("{:>4}  {:<30} {:<23} {}\n", i, way(one[i]),
                        fmt::format("({}, {}), ({}, {})", e.x(), e.y(), e.y(), -e.x() + 0.0),
                        way(two[i]));
  }
  return text;
}

std::string table_five(const std::array<Segment, 4>& one, const std::array<Segment, 4>& two) {
  std::string text =
      "\ntable 5: the first ray of box 1 against the edges of box 2, as printed | as it must be\n"
      "edge  tmp                      numer            denom       t       status\n";
  const Ray ray{one[0].a, one[0].b - one[0].a};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 e = two[i].b - two[i].a, normal(e.y(), -e.x()), tmp = two[i].a - ray.origin;
    const double numer = normal.dot(tmp), denom = normal.dot(ray.direction);
    const Printed& printed = kPrinted[i];
    text += fmt::format("{:>4}  {:<10} | {:<10}  {:>6} | {:<6}  {} | {:<5}  {:<6}  {} | {}\n", i,
                        printed.tmp, fmt::format("({}, {})", tmp.x(), tmp.y()), printed.numer,
                        numer, printed.denom, denom + 0.0,
                        denom == 0 ? "-" : fmt::format("{:.4f}", numer / denom), printed.status,
                        status(numer, denom));
  }
  return text +
         "Each printed denominator is a normal against its own edge, so 0; the printed tmp is that "
         "of edge 0\n"
         "for all edges. Wrong as numbers: 3 of 4 numerators, 2 of 4 denominators, 2 of 4 kinds of "
         "edge.\n";
}

int misses(const Ring& from, const Ring& against) {
  int count = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!clip_convex({from[i], from[(i + 1) % from.size()] - from[i]}, against, kSegment)) ++count;
  return count;
}

}  // namespace

Result<std::string> paper_table(const Scene& scene, const Place& where) {
  const Ring one = box(250, 200, 314, 328), two = box(885, 378, 949, 506);
  if (!has_box(scene, one) || !has_box(scene, two))
    return usage_error(where, "the tables are of the paper's two boxes, which this scene has not",
                       "flatray collide scenes/paper/case_two.toml --table");
  const std::array<Segment, 4> rays_one = paper_rays(one), rays_two = paper_rays(two);
  const HitInterval met = contact({one, {635, 178}}, {two, {0, 0}}).times;
  return table_four(rays_one, rays_two) + table_five(rays_one, rays_two) +
         fmt::format(
             "\nat rest {} of 4 sides of box 1 miss box 2, and {} of 4 of box 2 miss box 1: no "
             "hit.\n"
             "The paper has no velocity, so no hit time. Box 1 moving (635, 178) meets box 2 at\n"
             "t = {} = 571/635 and leaves it at t = {} = 699/635.\n",
             misses(one, two), misses(two, one), met.t_enter, met.t_exit);
}

}  // namespace flatray
