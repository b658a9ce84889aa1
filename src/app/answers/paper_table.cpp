#include "app/answers/paper_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/options/arguments.h"
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

std::array<PaperTable::Ray, 4> table_four(const Ring& one, const Ring& two) {
  const std::array<Segment, 4> rays_one = paper_rays(one), rays_two = paper_rays(two);
  std::array<PaperTable::Ray, 4> rays;
  for (std::size_t i = 0; i < 4; ++i) rays[i] = {rays_one[i], rays_two[i]};
  return rays;
}

std::array<PaperTable::Hit, 4> table_five(const std::array<PaperTable::Ray, 4>& rays) {
  std::array<PaperTable::Hit, 4> hits;
  const Segment& first = rays[0].one;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 e = rays[i].two.b - rays[i].two.a, normal(e.y(), -e.x());
    const Vec2 tmp = rays[i].two.a - first.a;
    const double numer = normal.dot(tmp), denom = normal.dot(first.b - first.a) + 0.0;
    const Printed& printed = kPrinted[i];
    hits[i] = {printed.tmp,
               printed.status,
               printed.numer,
               printed.denom,
               tmp,
               numer,
               denom,
               status(numer, denom),
               denom == 0 ? std::nullopt : std::optional<double>(numer / denom)};
  }
  return hits;
}

std::string text_of(const std::array<PaperTable::Ray, 4>& rays) {
  std::string text =
      "table 4: the rays, all right as numbers; they are pieces of the sides, with 25 cut off at "
      "some ends,\n"
      "and leave gaps at three corners\n"
      "edge  box 1: from -> to              edge, normal            box 2: from -> to\n";
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 e = rays[i].one.b - rays[i].one.a;
    const auto way = [](const Segment& s) {
      return fmt::format("({}, {}) -> ({}, {})", s.a.x(), s.a.y(), s.b.x(), s.b.y());
    };
    text += fmt::format("{:>4}  {:<30} {:<23} {}\n", i, way(rays[i].one),
                        fmt::format("({}, {}), ({}, {})", e.x(), e.y(), e.y(), -e.x() + 0.0),
                        way(rays[i].two));
  }
  return text;
}

std::string text_of(const std::array<PaperTable::Hit, 4>& hits) {
  std::string text =
      "\ntable 5: the first ray of box 1 against the edges of box 2, as printed | as it must be\n"
      "edge  tmp                      numer            denom       t       status\n";
  for (std::size_t i = 0; i < 4; ++i) {
    const PaperTable::Hit& hit = hits[i];
    text +=
        fmt::format("{:>4}  {:<10} | {:<10}  {:>6} | {:<6}  {} | {:<5}  {:<6}  {} | {}\n", i,
                    hit.printed_tmp, fmt::format("({}, {})", hit.tmp.x(), hit.tmp.y()),
                    hit.printed_numer, hit.numer, hit.printed_denom, hit.denom,
                    hit.t ? fmt::format("{:.4f}", *hit.t) : "-", hit.printed_status, hit.status);
  }
  return text +
         "Each printed denominator is a normal against its own edge, so 0; the printed tmp is that "
         "of edge 0\n"
         "for all edges. Wrong as numbers: 3 of 4 numerators, 2 of 4 denominators, 2 of 4 kinds of "
         "edge.\n";
}

JsonValue as_value(const Vec2& v) { return Values{v.x(), v.y()}; }

int misses(const Ring& from, const Ring& against) {
  int count = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!clip_convex({from[i], from[(i + 1) % from.size()] - from[i]}, against, kSegment)) ++count;
  return count;
}

}  // namespace

std::string PaperTable::text() const {
  return text_of(rays) + text_of(hits) +
         fmt::format(
             "\nat rest {} of 4 sides of box 1 miss box 2, and {} of 4 of box 2 miss box 1: no "
             "hit.\n"
             "The paper has no velocity, so no hit time. Box 1 moving (635, 178) meets box 2 at\n"
             "t = {} = 571/635 and leaves it at t = {} = 699/635.\n",
             misses_of_one, misses_of_two, t_first, t_last);
}

JsonValue PaperTable::json() const {
  Values four, five;
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Ray& ray = rays[k];
    const Vec2 e = ray.one.b - ray.one.a;
    four.push_back(Fields{{"edge", i},
                          {"box_1_from", as_value(ray.one.a)},
                          {"box_1_to", as_value(ray.one.b)},
                          {"box_1_edge", as_value(e)},
                          {"box_1_normal", as_value(Vec2(e.y(), -e.x() + 0.0))},
                          {"box_2_from", as_value(ray.two.a)},
                          {"box_2_to", as_value(ray.two.b)}});
    const Hit& hit = hits[k];
    five.push_back(Fields{{"edge", i},
                          {"printed", Fields{{"tmp", hit.printed_tmp},
                                             {"numer", hit.printed_numer},
                                             {"denom", hit.printed_denom},
                                             {"status", hit.printed_status}}},
                          {"tmp", as_value(hit.tmp)},
                          {"numer", hit.numer},
                          {"denom", hit.denom},
                          {"t", hit.t ? JsonValue(*hit.t) : JsonValue()},
                          {"status", hit.status}});
  }
  return Fields{{"table_4", std::move(four)},
                {"table_5", std::move(five)},
                {"at_rest", Fields{{"sides_of_box_1_that_miss", misses_of_one},
                                   {"sides_of_box_2_that_miss", misses_of_two}}},
                {"moving", Fields{{"velocity_of_box_1", as_value(Vec2(635, 178))},
                                  {"t_first", t_first},
                                  {"t_last", t_last}}}};
}

Result<PaperTable> paper_table(const Scene& scene, const Place& where) {
  const Ring one = box(250, 200, 314, 328), two = box(885, 378, 949, 506);
  if (!has_box(scene, one) || !has_box(scene, two))
    return usage_error(where, "the tables are of the paper's two boxes, which this scene has not",
                       "flatray collide scenes/paper/case_two.toml --table");
  const HitInterval met = contact({one, {635, 178}}, {two, {0, 0}}).times;
  const auto rays = table_four(one, two);
  return PaperTable{rays,        table_five(rays), misses(one, two), misses(two, one),
                    met.t_enter, met.t_exit};
}

}  // namespace flatray
