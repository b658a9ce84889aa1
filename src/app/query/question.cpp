#include "app/query/question.h"

#include <fmt/core.h>

#include <array>
#include <set>

#include "base/diagnostic.h"
#include "geom/polygon.h"
#include "geom/predicates.h"
#include "scene/outlines/arcs.h"

namespace flatray {
namespace {

std::optional<double> number_in(const JsonValue& value) {
  if (const auto* real = std::get_if<double>(&value.data)) return *real;
  if (const auto* whole = std::get_if<std::uint64_t>(&value.data))
    return static_cast<double>(*whole);
  if (const auto* whole = std::get_if<std::int64_t>(&value.data))
    return static_cast<double>(*whole);
  return std::nullopt;
}

}  // namespace

bool Question::has(std::string_view name) const { return whole_.find(name) != nullptr; }

const JsonValue* Question::find(std::string_view name) {
  asked_.emplace_back(name);
  if (const JsonValue* value = whole_.find(name)) return value;
  mistake(name, "is missing");
  return nullptr;
}

Vec2 Question::read_point(const JsonValue& value, const std::string& where) {
  const auto* items = std::get_if<Values>(&value.data);
  if (items == nullptr || items->size() != 2) {
    mistake(where, "is not a point: say [x, y]");
    return {0, 0};
  }
  const auto x = number_in((*items)[0]), y = number_in((*items)[1]);
  if (!x || !y) mistake(where, "is not a point: both must be numbers");
  return {x.value_or(0), y.value_or(0)};
}

Vec2 Question::point(std::string_view name) {
  const JsonValue* value = find(name);
  return value == nullptr ? Vec2(0, 0) : read_point(*value, std::string(name));
}

std::string Question::word(std::string_view name) {
  const JsonValue* value = find(name);
  if (value == nullptr) return "";
  const auto text = value->as_text();
  if (!text) mistake(name, "is not text");
  return text.value_or("");
}

std::uint64_t Question::whole(std::string_view name) {
  const JsonValue* value = find(name);
  if (value == nullptr) return 0;
  const auto number = value->as_whole();
  if (!number) mistake(name, "is not a whole number of 0 or more");
  return number.value_or(0);
}

Ray Question::ray() { return {point("origin"), point("direction")}; }

Range Question::domain(const char* line, const char* ray, const char* segment) {
  asked_.emplace_back("domain");
  if (!has("domain")) return kRay;
  const std::string name = word("domain");
  if (name == line) return kLine;
  if (name == segment) return kSegment;
  if (name != ray) mistake("domain", fmt::format("is none of {}, {}, {}", line, ray, segment));
  return kRay;
}

std::vector<Vec2> Question::polygon(std::string_view name) {
  const JsonValue* value = find(name);
  return value == nullptr ? std::vector<Vec2>{} : read_polygon(*value, std::string(name));
}

std::vector<Vec2> Question::read_polygon(const JsonValue& value, const std::string& where) {
  const auto* items = std::get_if<Values>(&value.data);
  if (items == nullptr || items->empty()) {
    mistake(where, "is not a list of points: say [[x, y], ...]");
    return {};
  }
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < items->size(); ++i)
    corners.push_back(read_point((*items)[i], fmt::format("{}[{}]", where, i)));
  if (const auto vertex = non_convex_vertex(corners))
    mistake(fmt::format("{}[{}]", where, *vertex), "the polygon is not convex at this vertex");
  return corners;
}

Question::Moving Question::moving(std::string_view name) {
  const JsonValue* value = find(name);
  if (value == nullptr) return {{}, {0, 0}};
  const std::string where(name);
  check_fields(*value, where, {"polygon", "disc", "radius", "velocity", "spin", "about"});
  const JsonValue *polygon = value->find("polygon"), *disc = value->find("disc");
  const JsonValue *velocity = value->find("velocity"), *radius = value->find("radius");
  if ((polygon == nullptr) == (disc == nullptr) || velocity == nullptr) {
    mistake(where, "needs a velocity, and a polygon or a disc");
    return {{}, {0, 0}};
  }
  const Vec2 way = read_point(*velocity, where + ".velocity");
  if (disc != nullptr) {
    check_fields(*disc, where + ".disc", {"center", "radius"});
    if (radius != nullptr) mistake(where + ".radius", "stands in the disc");
    const Circle circle = read_circle(*disc, where + ".disc");
    Moving body = {{circle.centre}, way, circle.radius};
    read_spin(*value, where, body);
    return body;
  }
  const auto length = radius == nullptr ? std::optional<double>(0) : number_in(*radius);
  if (!length || *length < 0) mistake(where + ".radius", "is not a number of 0 or more");
  Moving body = {read_polygon(*polygon, where + ".polygon"), way, length.value_or(0)};
  read_spin(*value, where, body);
  return body;
}

void Question::read_spin(const JsonValue& value, const std::string& where, Moving& body) {
  const JsonValue *spin = value.find("spin"), *about = value.find("about");
  if (about != nullptr) body.about = read_point(*about, where + ".about");
  if (spin == nullptr) {
    if (about != nullptr) mistake(where + ".about", "needs a spin");
    return;
  }
  const auto degrees = number_in(*spin);
  if (!degrees) mistake(where + ".spin", "is not a number");
  body.spin = degrees.value_or(0) * (std::numbers::pi / 180);
}

// Says which fields of an object are none of `known`.
void Question::check_fields(const JsonValue& value, const std::string& where,
                            const std::vector<std::string>& known) {
  const auto* fields = std::get_if<Fields>(&value.data);
  if (fields == nullptr) return;
  std::set<std::string_view> seen;
  for (const auto& field : *fields) {
    const bool twice = !seen.insert(field.first).second;
    const bool unknown = std::ranges::find(known, field.first) == known.end();
    if (!twice && !unknown) continue;
    const std::string place = where.empty() ? field.first : where + "." + field.first;
    if (twice) mistake(place, "is given twice");
    if (unknown) unknown_field(place, nearest_word(field.first, known));
  }
}

void Question::unknown_field(const std::string& where, const std::string& near) {
  mistake(where, near.empty() ? std::string("is not a field of this question")
                              : fmt::format("is not a field of this question (did you mean "
                                            "'{}'?)",
                                            near));
}

Circle Question::read_circle(const JsonValue& value, const std::string& where) {
  const JsonValue* centre = value.find("center");
  const JsonValue* radius = value.find("radius");
  if (centre == nullptr || radius == nullptr) {
    mistake(where, "needs a center and a radius");
    return {{0, 0}, 0};
  }
  const auto length = number_in(*radius);
  if (!length || *length < 0) mistake(where + ".radius", "is not a number of 0 or more");
  return {read_point(*centre, where + ".center"), length.value_or(0)};
}

Circle Question::disc(std::string_view name) {
  const JsonValue* value = find(name);
  if (value == nullptr) return {{0, 0}, 0};
  check_fields(*value, std::string(name), {"center", "radius"});
  return read_circle(*value, std::string(name));
}

void Question::read_whole(const JsonValue& value, const std::string& where, Surfaces& walls) {
  check_fields(value, where, {"center", "radius"});
  walls.add(read_circle(value, where));
}

void Question::read_arc(const JsonValue& value, const std::string& where, Surfaces& walls) {
  check_fields(value, where, {"center", "radius", "towards", "from", "to"});
  const Circle circle = read_circle(value, where);
  const JsonValue* towards = value.find("towards");
  if (towards == nullptr) return read_degrees(value, where, circle, walls);
  if (value.find("from") != nullptr || value.find("to") != nullptr)
    mistake(where, "says towards, or from and to, not both");
  const Vec2 way = read_point(*towards, where + ".towards");
  if (way == Vec2(0, 0)) mistake(where + ".towards", "is zero: say where the half circle lies");
  if (circle.radius == 0)
    walls.add(circle);
  else
    walls.add(Arc{circle, Arc::Extent::half, way, {0, 0}});
}

void Question::read_degrees(const JsonValue& value, const std::string& where, const Circle& circle,
                            Surfaces& walls) {
  const auto degrees = [&](const char* name) {
    const JsonValue* field = value.find(name);
    const auto number = field == nullptr ? std::nullopt : number_in(*field);
    if (!number) mistake(where + "." + name, "is not a number of degrees, and towards is missing");
    return number.value_or(0);
  };
  const double from = degrees("from"), to = degrees("to");
  if (!sound()) return;
  const double sweep = to > from ? to - from : to - from + 360;
  if (!(sweep > 0 && sweep <= 360) || to == from)
    return mistake(where,
                   "from and to do not span part of a turn: say less than 360 degrees, or to = "
                   "from + 360 for all of it");
  if (sweep == 360 || circle.radius == 0) {
    walls.add(circle);
    return;
  }
  const Vec2 first = circle.centre + circle.radius * unit_at_degrees(from);
  const Vec2 last = circle.centre + circle.radius * unit_at_degrees(to);
  if (!first.allFinite() || !last.allFinite()) return mistake(where, "ends beyond the doubles");
  if (first == last || first == circle.centre || last == circle.centre)
    return mistake(where, "is so small that doubles do not tell its ends apart");
  walls.add(Arc{circle, Arc::Extent::between, first, last});
}

void Question::read_ellipse(const JsonValue& value, const std::string& where, Surfaces& walls) {
  check_fields(value, where, {"center", "u", "v"});
  std::array<Vec2, 3> points;
  const std::array names = {"center", "u", "v"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const JsonValue* point = value.find(names[i]);
    if (point == nullptr) return mistake(where, "needs a center and two half-diameters u and v");
    points[i] = read_point(*point, where + "." + names[i]);
  }
  if (cross_sign(points[1], points[2]) == Sign::zero)
    return mistake(where, "has half-diameters u and v that are parallel");
  walls.add(Arc{{points[0], points[1], points[2]}, Arc::Extent::whole, {0, 0}, {0, 0}});
}

void Question::read_bezier(const JsonValue& value, const std::string& where, Surfaces& walls) {
  const auto* items = std::get_if<Values>(&value.data);
  if (items == nullptr || (items->size() != 3 && items->size() != 4))
    return mistake(where, "is not a list of 3 or 4 control points");
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < items->size(); ++i)
    points.push_back(read_point((*items)[i], fmt::format("{}[{}]", where, i)));
  if (!sound()) return;
  constexpr double kMostOfBezier = 1e200;  // beyond which products of its forms overflow
  for (const Vec2& point : points)
    if (point.cwiseAbs().maxCoeff() > kMostOfBezier) return mistake(where, "reaches beyond 1e200");
  const Bezier curve(points);
  if (is_on_one_line(curve)) return mistake(where, "lies on a line: say a segment");
  walls.add(curve);
}

void Question::read_segment(const JsonValue& value, const std::string& where, Surfaces& walls) {
  const auto* ends = std::get_if<Values>(&value.data);
  if (ends == nullptr || ends->size() != 2) return mistake(where, "is not a pair of points");
  walls.add(Segment{read_point((*ends)[0], where + "[0]"), read_point((*ends)[1], where + "[1]")});
}

void Question::read_wall(const JsonValue& value, const std::string& where, Surfaces& walls) {
  using Read = void (Question::*)(const JsonValue&, const std::string&, Surfaces&);
  static constexpr std::pair<const char*, Read> kKinds[] = {{"segment", &Question::read_segment},
                                                            {"circle", &Question::read_whole},
                                                            {"arc", &Question::read_arc},
                                                            {"ellipse", &Question::read_ellipse},
                                                            {"bezier", &Question::read_bezier}};
  std::vector<std::string> names;
  for (const auto& [name, read] : kKinds) names.emplace_back(name);
  check_fields(value, where, names);
  std::size_t found = 0;
  for (const auto& [name, read] : kKinds)
    if (const JsonValue* wall = value.find(name); wall != nullptr && ++found == 1)
      (this->*read)(*wall, where + "." + name, walls);
  if (found > 1)
    mistake(where, "is a segment, a circle, an arc, an ellipse or a bezier: one of them");
  if (found == 0)
    mistake(where,
            "is not a wall: say {\"segment\": [[x1, y1], [x2, y2]]}, {\"circle\": ...}, "
            "{\"arc\": ...}, {\"ellipse\": ...} or {\"bezier\": ...}");
}

Surfaces Question::walls(std::string_view name) {
  Surfaces walls;
  const JsonValue* value = find(name);
  if (value == nullptr) return walls;
  const auto* items = std::get_if<Values>(&value->data);
  if (items == nullptr) {
    mistake(name, "is not a list of walls");
    return walls;
  }
  for (std::size_t i = 0; i < items->size(); ++i)
    read_wall((*items)[i], fmt::format("{}[{}]", name, i), walls);
  return walls;
}

void Question::mistake(std::string_view where, std::string_view what) {
  if (!mistakes_.empty()) mistakes_ += "; ";
  mistakes_ += fmt::format("{}: {}", where, what);
}

std::string Question::mistakes() {
  std::vector<std::string> known = asked_;
  known.insert(known.end(), {"id", "op"});
  check_fields(whole_, "", known);
  return mistakes_;
}

}  // namespace flatray
