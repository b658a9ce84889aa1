#include "scene/shape.h"

#include <fmt/core.h>

#include "scene/keys/changing_shape.h"
#include "scene/keys/corner_limit.h"
#include "scene/reading/kinds.h"
#include "scene/reading/overrides.h"

namespace flatray {

#include "shapes.inc"  // shape_types()

std::string usage(const ShapeType& type) {
  std::string all;
  for (const KeyInfo& key : type.keys)
    all += fmt::format("{}{} = {}", all.empty() ? "" : ", ", key.name, key.takes);
  return all;
}

namespace {

std::optional<ShapeId> build_shape(Builder& builder, const Field& field) {
  const std::size_t problems = builder.in.problems.size();
  const auto kind = read_kind(builder.in, field, shape_types(), "a shape");
  if (!kind) return std::nullopt;
  const Field arguments{kind->type->name, kind->arguments, "{ ... }"};
  if (builder.may_change && has_curve(arguments.value))
    return build_changing_shape(builder, *kind->type, arguments);
  Args args(builder, arguments, kind->type->keys);
  Result<Shape> shape = kind->type->build(args);
  if (builder.in.problems.size() > problems) return std::nullopt;
  args.check_lost_features();
  if (!shape) {
    builder.in.add(std::move(shape.error()));
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
