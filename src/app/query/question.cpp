#include "app/query/question.h"

#include <fmt/core.h>

#include <set>

#include "base/counted.h"
#include "base/entry_named.h"
#include "base/shown_text.h"
#include "geom/polygon.h"
#include "geom/predicates.h"
#include "scene/outlines/arcs.h"
#include "scene/reading/format.h"

namespace flatray {

// A value in a question, and how messages name it: "walls[2].circle".
struct QuestionPart {
  Question& question;
  const JsonValue* value;  // null: it is not there
  std::string where;

  explicit operator bool() const { return value != nullptr; }
  QuestionPart operator[](const std::string& field) const {
    return {question, value->find(field), place_of(field)};
  }
  std::string place_of(const std::string& field) const {
    return where.empty() ? field : where + "." + field;
  }
  // The items of a list; null for anything else.
  const Values* list() const { return std::get_if<Values>(&value->data); }
  QuestionPart item(std::size_t i) const {
    return {question, &(*list())[i], fmt::format("{}[{}]", where, i)};
  }
  void mistake(std::string_view what) const { question.mistake(where, what); }
};

namespace {

Vec2 read_point(const QuestionPart& part) {
  const Values* items = part.list();
  if (items == nullptr || items->size() != 2) {
    part.mistake("is not a point: say [x, y]");
    return {0, 0};
  }
  const auto x = (*items)[0].as_number(), y = (*items)[1].as_number();
  if (!x || !y) part.mistake("is not a point: both must be numbers");
  return {x.value_or(0), y.value_or(0)};
}

double read_length(const QuestionPart& part) {
  const auto length = part.value->as_number();
  if (!length || *length < 0) part.mistake("is not a number of 0 or more");
  return length.value_or(0);
}

std::vector<Vec2> read_polygon(const QuestionPart& part) {
  const Values* items = part.list();
  if (items == nullptr || items->empty()) {
    part.mistake("is not a list of points: say [[x, y], ...]");
    return {};
  }
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < items->size(); ++i) corners.push_back(read_point(part.item(i)));
  if (const auto vertex = non_convex_vertex(corners))
    part.item(*vertex).mistake("the polygon is not convex at this vertex");
  return corners;
}

// Says which fields of an object are none of `known`.
void check_fields(const QuestionPart& part, const std::vector<std::string>& known) {
  const auto* fields = std::get_if<Fields>(&part.value->data);
  if (fields == nullptr) return;
  std::set<std::string_view> seen;
  for (const auto& field : *fields) {
    const auto wrong = [&](const std::string& what) {
      part.question.mistake(part.place_of(field.first), what);
    };
    if (!seen.insert(field.first).second) wrong("is given twice");
    if (std::ranges::find(known, field.first) == known.end())
      wrong("is not a field of this question" + did_you_mean(field.first, known));
  }
}

Circle read_circle(const QuestionPart& part) {
  const QuestionPart centre = part["center"], radius = part["radius"];
  if (!centre || !radius) {
    part.mistake("needs a center and a radius");
    return {{0, 0}, 0};
  }
  const double length = read_length(radius);
  return {read_point(centre), length};
}

void read_spin(const QuestionPart& body, Question::Moving& moving) {
  const QuestionPart spin = body["spin"], about = body["about"];
  if (about) moving.about = read_point(about);
  if (!spin) {
    if (about) about.mistake("needs a spin");
    return;
  }
  const auto degrees = spin.value->as_number();
  if (!degrees) spin.mistake("is not a number");
  moving.spin = degrees.value_or(0) * (std::numbers::pi / 180);
}

Circle read_disc(const QuestionPart& part) {
  check_fields(part, {"center", "radius"});
  return read_circle(part);
}

void read_whole(const QuestionPart& circle, Surfaces& walls) { walls.add(read_disc(circle)); }

void read_degrees(const QuestionPart& arc, const Circle& circle, Surfaces& walls) {
  const auto degrees = [&](const QuestionPart& part) {
    const auto number = part ? part.value->as_number() : std::nullopt;
    if (!number) part.mistake("is not a number of degrees, and towards is missing");
    return number.value_or(0);
  };
  const double from = degrees(arc["from"]), to = degrees(arc["to"]);
  if (!arc.question.sound()) return;
  const double sweep = to > from ? to - from : to - from + 360;
  if (!(sweep > 0 && sweep <= 360) || to == from)
    return arc.mistake(
        "from and to do not span part of a turn: say less than 360 degrees, or to = "
        "from + 360 for all of it");
  if (sweep == 360 || circle.radius == 0) {
    walls.add(circle);
    return;
  }
  const Vec2 first = circle.centre + circle.radius * unit_at_degrees(from);
  const Vec2 last = circle.centre + circle.radius * unit_at_degrees(to);
  if (!first.allFinite() || !last.allFinite()) return arc.mistake("ends beyond the doubles");
  if (lie_in_one_direction(circle.centre, first, last))
    return arc.mistake(
        "has ends so near to one another, or to its centre, that doubles do not tell "
        "their directions apart");
  walls.add(Arc{circle, Arc::Extent::between, first, last});
}

void read_arc(const QuestionPart& arc, Surfaces& walls) {
  check_fields(arc, {"center", "radius", "towards", "from", "to"});
  const Circle circle = read_circle(arc);
  const QuestionPart towards = arc["towards"];
  if (!towards) return read_degrees(arc, circle, walls);
  if (arc["from"] || arc["to"]) arc.mistake("says towards, or from and to, not both");
  const Vec2 way = read_point(towards);
  if (arc.question.sound() && way == Vec2(0, 0))
    towards.mistake("is zero: say where the half circle lies");
  if (circle.radius == 0)
    walls.add(circle);
  else
    walls.add(Arc{circle, Arc::Extent::half, way, {0, 0}});
}

// Of a list of 3 or 4.
void add_bezier(const QuestionPart& part, double weight, Surfaces& walls) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < part.list()->size(); ++i) points.push_back(read_point(part.item(i)));
  if (!part.question.sound()) return;
  constexpr double kMostOfBezier = 1e200;  // beyond which products of its forms overflow
  for (const Vec2& point : points)
    if (point.cwiseAbs().maxCoeff() > kMostOfBezier) return part.mistake("reaches beyond 1e200");
  Bezier curve(points);
  curve.weight = weight;
  if (is_on_one_line(curve)) return part.mistake("lies on a line: say a segment");
  walls.add(curve);
}

void read_ellipse(const QuestionPart& ellipse, Surfaces& walls) {
  check_fields(ellipse, {"center", "u", "v"});
  std::vector<Vec2> points;
  for (const char* name : {"center", "u", "v"}) {
    const QuestionPart point = ellipse[name];
    if (!point) return ellipse.mistake("needs a center and two half-diameters u and v");
    points.push_back(read_point(point));
  }
  if (cross_sign(points[1], points[2]) == Sign::zero)
    return ellipse.mistake("has half-diameters u and v that are parallel");
  walls.add(Arc{{points[0], points[1], points[2]}, Arc::Extent::whole, {0, 0}, {0, 0}});
}

void read_bezier(const QuestionPart& part, Surfaces& walls) {
  const Values* items = part.list();
  if (items == nullptr || (items->size() != 3 && items->size() != 4))
    return part.mistake("is not a list of 3 or 4 control points");
  add_bezier(part, 1, walls);
}

void read_conic(const QuestionPart& conic, Surfaces& walls) {
  check_fields(conic, {"points", "weight"});
  const QuestionPart points = conic["points"], weight = conic["weight"];
  if (!points || !weight) return conic.mistake("needs 3 points and a weight");
  const auto number = weight.value->as_number();
  if (!number || !Bezier::is_in_range(*number))
    weight.mistake("is not a number from 2^-40 to 2^40");
  if (points.list() == nullptr || points.list()->size() != 3)
    return points.mistake("is not a list of 3 control points");
  add_bezier(points, number.value_or(1), walls);
}

void read_segment(const QuestionPart& ends, Surfaces& walls) {
  if (ends.list() == nullptr || ends.list()->size() != 2)
    return ends.mistake("is not a pair of points");
  walls.add(Segment{read_point(ends.item(0)), read_point(ends.item(1))});
}

void read_wall(const QuestionPart& wall, Surfaces& walls) {
  using Read = void (*)(const QuestionPart&, Surfaces&);
  static constexpr std::pair<const char*, Read> kWalls[] = {
      {"segment", &read_segment}, {"circle", &read_whole},  {"arc", &read_arc},
      {"ellipse", &read_ellipse}, {"bezier", &read_bezier}, {"conic", &read_conic}};
  check_fields(wall, names_of(kWalls));
  std::size_t found = 0;
  for (const auto& [name, read] : kWalls)
    if (const QuestionPart part = wall[name]; part && ++found == 1) read(part, walls);
  if (found > 1)
    wall.mistake("is a segment, a circle, an arc, an ellipse, a bezier or a conic: one of them");
  if (found == 0)
    wall.mistake(
        "is not a wall: say {\"segment\": [[x1, y1], [x2, y2]]}, {\"circle\": ...}, "
        "{\"arc\": ...}, {\"ellipse\": ...}, {\"bezier\": ...} or {\"conic\": ...}");
}

}  // namespace

bool Question::has(std::string_view name) const { return whole_.find(name) != nullptr; }

QuestionPart Question::find(std::string_view name) {
  asked_.emplace_back(name);
  QuestionPart part{*this, whole_.find(name), std::string(name)};
  if (!part) part.mistake("is missing");
  return part;
}

Vec2 Question::point(std::string_view name) {
  const QuestionPart part = find(name);
  return part ? read_point(part) : Vec2(0, 0);
}

std::string Question::word(std::string_view name) {
  const QuestionPart part = find(name);
  if (!part) return "";
  const auto text = part.value->as_text();
  if (!text) mistake(name, "is not text");
  return text.value_or("");
}

std::uint64_t Question::whole(std::string_view name) {
  const QuestionPart part = find(name);
  if (!part) return 0;
  const auto number = part.value->as_whole();
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
  const QuestionPart part = find(name);
  return part ? read_polygon(part) : std::vector<Vec2>{};
}

Question::Moving Question::moving(std::string_view name) {
  const QuestionPart part = find(name);
  if (!part) return {};
  check_fields(part, {"polygon", "disc", "radius", "velocity", "spin", "about"});
  const QuestionPart polygon = part["polygon"], disc = part["disc"], velocity = part["velocity"],
                     radius = part["radius"];
  if (!polygon == !disc || !velocity) {
    part.mistake("needs a velocity, and a polygon or a disc");
    return {};
  }
  Moving body{{}, read_point(velocity)};
  if (disc) {
    check_fields(disc, {"center", "radius"});
    if (radius) radius.mistake("stands in the disc");
    const Circle circle = read_circle(disc);
    body.polygon = {circle.centre};
    body.radius = circle.radius;
  } else {
    if (radius) body.radius = read_length(radius);
    body.polygon = read_polygon(polygon);
  }
  read_spin(part, body);
  return body;
}

Circle Question::disc(std::string_view name) {
  const QuestionPart part = find(name);
  return part ? read_disc(part) : Circle{{0, 0}, 0};
}

Surfaces Question::walls(std::string_view name) {
  Surfaces walls;
  const QuestionPart part = find(name);
  if (!part) return walls;
  const Values* items = part.list();
  if (items == nullptr) mistake(name, "is not a list of walls");
  for (std::size_t i = 0; items != nullptr && i < items->size(); ++i)
    read_wall(part.item(i), walls);
  return walls;
}

void Question::mistake(std::string_view where, std::string_view what) {
  if (++mistake_count_ > kMostProblems) return;
  if (!mistakes_.empty()) mistakes_ += "; ";
  mistakes_ += shortened(fmt::format("{}: {}", where, what));
}

std::string Question::mistakes() {
  std::vector<std::string> known = asked_;
  known.insert(known.end(), {"id", "op"});
  check_fields({*this, &whole_, ""}, known);
  if (mistake_count_ <= kMostProblems) return mistakes_;
  return fmt::format("{}; and {} more", mistakes_,
                     counted(mistake_count_ - kMostProblems, "mistake"));
}

}  // namespace flatray
