#include "scene/shape.h"

#include <fmt/core.h>

#include "scene/changing_shape.h"
#include "scene/corner_limit.h"
#include "scene/overrides.h"

namespace flatray {
namespace shapes {
#define FLATRAY_ENTRY(name) extern const ShapeType name;
#include "shapes.inc"
#undef FLATRAY_ENTRY
}  // namespace shapes
namespace {

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
  if (builder.may_change && has_curve(arguments.value))
    return build_changing_shape(builder, *type, arguments);
  Args args(builder, arguments, type->keys);
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
