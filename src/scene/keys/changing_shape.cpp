#include "scene/keys/changing_shape.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "base/number_text.h"
#include "scene/curve.h"
#include "scene/keys/build_scene.h"
#include "scene/keys/corner_limit.h"
#include "scene/lamp.h"
#include "scene/shape.h"

namespace flatray {
namespace {

constexpr std::size_t kNumbersOfAPoint = 2;

// One number alone stays between its keys, where what is right at both is right, but of some shapes.
// Outlines may cross in between, and of several numbers each goes its own way. That a shape is not
// there at a key says nothing of what is right.
bool may_fail_between_keys(const ChangingShape& changing, bool was_gone) {
  return changing.type->fails_between || curves_of(changing).size() > 1 || was_gone ||
         std::ranges::any_of(changing.arguments, [](const auto& argument) {
           return argument.numbers.size() > kNumbersOfAPoint;
         });
}

// What arguments count for where nothing comes of them.
std::uint64_t corners_of(const ChangingShape& changing) {
  std::uint64_t corners = 0;
  for (const ChangingShape::Argument& argument : changing.arguments)
    corners += corner_count(Shape{}) + argument.text.size();
  return corners;
}

// Builds a shape at the times at which it could be wrong.
struct Trials {
  Builder& builder;
  const ShapeType& type;
  const ChangingShape& changing;
  Args& args;
  std::uint64_t corners_of_arguments;
  bool was_gone = false;
  Shape largest{};  // the one with most corners of all seen

  // Whether it can be built then, or is not there.
  bool at(double time) {
    const std::size_t problems = builder.in.problems.size();
    args.set_time(time);
    Result<Shape> shape = type.build(args);
    if (builder.in.problems.size() > problems) return false;
    was_gone |= args.gone();
    if (args.gone()) return count(corners_of_arguments);
    if (!shape) {
      for (Diagnostic& one : shape.error()) {
        one.message += fmt::format(" at {} s", number_text(time));
        builder.in.problems.push_back(std::move(one));
      }
      return false;
    }
    const std::uint64_t corners = corner_count(*shape);
    if (corners > corner_count(largest)) largest = std::move(*shape);
    return count(corners);
  }

  bool count(std::uint64_t corners) {
    const std::uint64_t limit = builder.limits.max_corners;
    builder.checked_corners += corners;
    if (builder.checked_corners <= limit) return true;
    builder.in.problem(
        args.where,
        fmt::format(
            "shapes that change come to more than {} corners in the frames up to their last keys",
            limit),
        "end the curves earlier, let one number change alone, share a shape among copies, or say "
        "--max-corners N");
    return false;
  }

  bool at_all_times() {
    const std::set<double> times = key_times(builder.scene, changing);
    if (!std::ranges::all_of(times, [&](double time) { return at(time); })) return false;
    return !may_fail_between_keys(changing, was_gone) ||
           holds_in_frames_between(times, builder.scene.fps, [&](double time) { return at(time); });
  }
};

}  // namespace

std::optional<ShapeId> build_changing_shape(Builder& builder, const ShapeType& type,
                                            const Field& arguments) {
  const std::size_t problems = builder.in.problems.size();
  ChangingShape changing{{}, &type};
  Args args(builder, arguments, type.keys, &changing);
  (void)type.build(args);  // reads the arguments
  if (builder.in.problems.size() > problems || builder.full) return std::nullopt;
  Scene& scene = builder.scene;
  Trials trials{builder, type, changing, args, corners_of(changing)};
  if (!trials.at_all_times()) return std::nullopt;
  Shape& shape = trials.largest;
  std::uint64_t corners = corner_count(shape);
  for (const auto& argument : changing.arguments) corners += argument.numbers.size();
  if (!take_corners(builder, corners, arguments.value.where)) return std::nullopt;
  shape.changes = static_cast<std::uint32_t>(scene.changing_shapes.size());
  scene.changing_shapes.push_back(std::move(changing));
  scene.shapes.push_back(std::move(shape));
  return static_cast<ShapeId>(scene.shapes.size() - 1);
}

Shape shape_at(const Scene& scene, const ChangingShape& changing, double time) {
  Args args(scene, changing, time);
  Result<Shape> shape = changing.type->build(args);
  return shape && !args.gone() ? std::move(*shape) : Shape{};
}

}  // namespace flatray
