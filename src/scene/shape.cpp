#include "scene/shape.h"

#include <fmt/core.h>

#include <numeric>

#include "scene/corner_limit.h"
#include "scene/numbers.h"
#include "scene/overrides.h"

namespace flatray {
namespace shapes {
#define FLATRAY_ENTRY(name) extern const ShapeType name;
#include "shapes.inc"
#undef FLATRAY_ENTRY
}  // namespace shapes
namespace {

bool written_the_same(const Value& a, const Value& b) {
  for (std::size_t i = 0; i < 2; ++i)
    if (parse_decimal(source_text(a.items[i])) != parse_decimal(source_text(b.items[i])))
      return false;
  return true;
}

std::string point_text(const Value& point) {
  return fmt::format("({}, {})", source_text(point.items[0]).substr(0, 40),
                     source_text(point.items[1]).substr(0, 40));
}

const ShapeType* find_type(std::string_view name) {
  for (const ShapeType* type : shape_types())
    if (type->name == name) return type;
  return nullptr;
}

std::vector<std::string> type_names() {
  std::vector<std::string> names;
  for (const ShapeType* type : shape_types()) names.emplace_back(type->name);
  return names;
}

// The one member of `{ KIND = { ... } }` and its type; what is wrong with it is noted.
const ShapeType* kind_of(Reader& in, const Field& field) {
  if (!in.is(field, Value::Kind::table, "a shape")) return nullptr;
  if (field.value.members.size() != 1) {
    in.problem(field.value.where,
               fmt::format("{} has {} kinds, not one", field.name, field.value.members.size()),
               "write one of: " + joined(type_names()));
    return nullptr;
  }
  const Member& kind = field.value.members.front();
  const ShapeType* type = find_type(kind.key);
  if (type == nullptr)
    in.problems.push_back(unknown_word(kind.where, "shape", kind.key, type_names()));
  return type;
}

void append(Diagnostics& to, Diagnostics&& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

Args::Args(Field field, std::span<const KeyInfo> keys, Reader& in, Imports& imports)
    : where(field.value.where),
      field_(std::move(field)),
      keys_(keys),
      in_(&in),
      imports_(&imports) {
  check_keys(field_.value, field_.name, keys, in.problems);
  for (const KeyInfo& key : keys)
    if (key.fallback == kRequired && field_.value.find(key.name) == nullptr)
      in.problem(where, fmt::format("{} needs '{}'", field_.name, key.name),
                 fmt::format("write {} = {}", key.name, key.takes));
}

std::optional<Field> Args::find(const char* key) const {
  const Member* member = field_.value.find(key);
  if (member == nullptr) return std::nullopt;
  const auto info = std::find_if(keys_.begin(), keys_.end(), [&](const KeyInfo& known) {
    return std::string_view(known.name) == key;
  });
  return Field{field_.name + "." + key, member->value, info == keys_.end() ? "" : info->takes};
}

Vec2 Args::point(const char* key) {
  const std::optional<Field> field = find(key);
  const std::optional<Vec2> point = field ? in_->point(*field) : std::nullopt;
  if (point && !has_distribution(field->value)) read_.push_back({*point, &field->value});
  return point.value_or(Vec2(0, 0));
}

double Args::number(const char* key, double fallback) {
  const std::optional<Field> field = find(key);
  return field ? in_->number(*field).value_or(fallback) : fallback;
}

double Args::size(const char* key) {
  const std::optional<Field> field = find(key);
  const std::optional<double> size = field ? in_->number(*field) : std::nullopt;
  if (!size || (*size > 0 && *size <= kFarthest)) return size.value_or(0);
  in_->problem(field->value.where,
               fmt::format("{} is {}", field->name, source_text(field->value).substr(0, 40)),
               "write a number above 0, at most 1e300");
  return 0;
}

std::int64_t Args::integer(const char* key, std::int64_t fallback, std::int64_t low,
                           std::int64_t high) {
  const std::optional<Field> field = find(key);
  return field ? in_->integer(*field, low, high).value_or(fallback) : fallback;
}

std::string Args::string(const char* key, std::string fallback) {
  const std::optional<Field> field = find(key);
  return field ? in_->string(*field).value_or(fallback) : fallback;
}

bool Args::flag(const char* key, bool fallback) {
  const std::optional<Field> field = find(key);
  return field ? in_->flag(*field).value_or(fallback) : fallback;
}

std::vector<Vec2> Args::points(const char* key) {
  std::vector<Vec2> points;
  const std::optional<Field> field = find(key);
  if (!field || !in_->is(*field, Value::Kind::array, "a list of points")) return points;
  if (field->value.items.empty())
    in_->problem(field->value.where, field->name + " is empty", "write at least one point");
  for (std::size_t i = 0; i < field->value.items.size(); ++i)
    if (const std::optional<Vec2> point = in_->point(field->item(i))) {
      points.push_back(*point);
      if (const Value& item = field->value.items[i]; !has_distribution(item))
        read_.push_back({*point, &item});
    }
  return points;
}

Place Args::place(const char* key) const {
  const Member* member = field_.value.find(key);
  return member == nullptr ? where : member->value.where;
}

Place Args::place(const char* key, std::size_t index) const {
  const Member* member = field_.value.find(key);
  if (member == nullptr || index >= member->value.items.size()) return place(key);
  return member->value.items[index].where;
}

void Args::warnings(Diagnostics more) { append(in_->warnings, std::move(more)); }

void Args::check_lost_features() {
  std::vector<std::size_t> order(read_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Vec2 &p = read_[a].point, &q = read_[b].point;
    return std::tuple(p.x(), p.y(), a) < std::tuple(q.x(), q.y(), b);
  });
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const ReadPoint &first = read_[order[i]], &second = read_[order[i + 1]];
    if (first.point != second.point || written_the_same(*first.value, *second.value)) continue;
    in_->warning(second.value->where,
                 fmt::format("{} and {} read as the same point", point_text(*first.value),
                             point_text(*second.value)),
                 "doubles hold about 16 digits: move the shape nearer to 0");
  }
}

std::vector<const ShapeType*> shape_types() {
  return {
#define FLATRAY_ENTRY(name) &shapes::name,
#include "shapes.inc"
#undef FLATRAY_ENTRY
  };
}

std::string usage(const ShapeType& type) {
  std::string all;
  for (const KeyInfo& key : type.keys)
    all += fmt::format("{}{} = {}", all.empty() ? "" : ", ", key.name, key.takes);
  return all;
}

std::vector<Listed> listed_shapes() {
  std::vector<Listed> all;
  for (const ShapeType* type : shape_types()) all.push_back({type->name, usage(*type)});
  return all;
}

namespace {

std::optional<ShapeId> build_shape(Builder& builder, const Field& field) {
  const std::size_t problems = builder.in.problems.size();
  const ShapeType* type = kind_of(builder.in, field);
  if (type == nullptr) return std::nullopt;
  const Field arguments{type->name, field.value.members.front().value, "{ ... }"};
  if (!builder.in.is(arguments, Value::Kind::table, "a table")) return std::nullopt;
  Args args(arguments, type->keys, builder.in, builder.imports);
  Result<Shape> shape = type->build(args);
  if (builder.in.problems.size() > problems) return std::nullopt;
  args.check_lost_features();
  if (!shape) {
    append(builder.in.problems, std::move(shape).error());
    return std::nullopt;
  }
  if (!take_corners(builder, corner_count(*shape), place_of_change(field.value, field.value.where)))
    return std::nullopt;
  builder.scene.shapes.push_back(std::move(*shape));
  return static_cast<ShapeId>(builder.scene.shapes.size() - 1);
}

std::optional<ShapeId> one_shape(Builder& builder, const Field& field) {
  const auto known = builder.fixed_shapes.find(&field.value);
  if (known != builder.fixed_shapes.end()) return known->second;
  const std::optional<ShapeId> shape = build_shape(builder, field);
  if (shape && builder.in.draws != nullptr && !has_distribution(field.value))
    builder.fixed_shapes.emplace(&field.value, *shape);
  return shape;
}

}  // namespace

std::optional<ShapeId> read_shape(Builder& builder, const Field& field) {
  return builder.in.chosen(field, [&](const Field& one) { return one_shape(builder, one); });
}

}  // namespace flatray
