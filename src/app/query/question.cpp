#include "app/query/question.h"

#include <fmt/core.h>

#include <set>

#include "base/diagnostic.h"
#include "geom/polygon.h"

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
    mistake(where, "is no point: say [x, y]");
    return {0, 0};
  }
  const auto x = number_in((*items)[0]), y = number_in((*items)[1]);
  if (!x || !y) mistake(where, "is no point: both must be numbers");
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
  if (!text) mistake(name, "is no text");
  return text.value_or("");
}

std::uint64_t Question::whole(std::string_view name) {
  const JsonValue* value = find(name);
  if (value == nullptr) return 0;
  const auto number = value->as_whole();
  if (!number) mistake(name, "is no whole number of 0 or more");
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
    mistake(where, "is no list of points: say [[x, y], ...]");
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
  check_fields(*value, where, {"polygon", "velocity"});
  const JsonValue* polygon = value->find("polygon");
  const JsonValue* velocity = value->find("velocity");
  if (polygon == nullptr || velocity == nullptr) {
    mistake(where, "needs a polygon and a velocity");
    return {{}, {0, 0}};
  }
  return {read_polygon(*polygon, where + ".polygon"), read_point(*velocity, where + ".velocity")};
}

// Says which fields of an object are none of `known`.
void Question::check_fields(const JsonValue& value, const std::string& where,
                            const std::vector<std::string>& known) {
  const auto* fields = std::get_if<Fields>(&value.data);
  if (fields == nullptr) return;
  std::set<std::string_view> seen;
  for (const auto& field : *fields) {
    const bool twice = !seen.insert(field.first).second;
    const bool unknown = std::find(known.begin(), known.end(), field.first) == known.end();
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
  check_fields(value, where, {"center", "radius"});
  const JsonValue* centre = value.find("center");
  const JsonValue* radius = value.find("radius");
  if (centre == nullptr || radius == nullptr) {
    mistake(where, "needs a center and a radius");
    return {{0, 0}, 0};
  }
  const auto length = number_in(*radius);
  if (!length || *length < 0) mistake(where + ".radius", "is no number of 0 or more");
  return {read_point(*centre, where + ".center"), length.value_or(0)};
}

Circle Question::disc(std::string_view name) {
  const JsonValue* value = find(name);
  return value == nullptr ? Circle{{0, 0}, 0} : read_circle(*value, std::string(name));
}

void Question::read_wall(const JsonValue& value, const std::string& where, Surfaces& walls) {
  check_fields(value, where, {"segment", "circle"});
  if (value.find("circle") != nullptr && value.find("segment") != nullptr)
    mistake(where, "is a segment or a circle, not both");
  if (const JsonValue* circle = value.find("circle")) {
    walls.add(read_circle(*circle, where + ".circle"));
    return;
  }
  const JsonValue* segment = value.find("segment");
  if (segment == nullptr) {
    mistake(where, "is no wall: say {\"segment\": [[x1, y1], [x2, y2]]} or {\"circle\": ...}");
    return;
  }
  const auto* ends = std::get_if<Values>(&segment->data);
  if (ends == nullptr || ends->size() != 2) {
    mistake(where + ".segment", "is no pair of points");
    return;
  }
  walls.add(Segment{read_point((*ends)[0], where + ".segment[0]"),
                    read_point((*ends)[1], where + ".segment[1]")});
}

Surfaces Question::walls(std::string_view name) {
  Surfaces walls;
  const JsonValue* value = find(name);
  if (value == nullptr) return walls;
  const auto* items = std::get_if<Values>(&value->data);
  if (items == nullptr) {
    mistake(name, "is no list of walls");
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
