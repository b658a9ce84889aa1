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

// The curves of a shape's numbers.
std::set<CurveId> curves_of(const ChangingShape& changing) {
  std::set<CurveId> all;
  for (const ChangingShape::Argument& argument : changing.arguments)
    for (const Moving& number : argument.numbers)
      if (number.curve) all.insert(*number.curve);
  return all;
}

// One number alone stays between its keys, where what is right at both is right: all bounds are
// intervals. Outlines may cross in between, and of several numbers each goes its own way. That a
// shape is not there at a key says nothing of what is right.
bool may_fail_between_keys(const ChangingShape& changing, bool was_gone) {
  return curves_of(changing).size() > 1 || was_gone ||
         std::ranges::any_of(changing.arguments, [](const auto& argument) {
           return argument.numbers.size() > kNumbersOfAPoint;
         });
}

// Builds a shape at the times at which it could be wrong.
class Trials {
 public:
  Trials(Builder& builder, const ShapeType& type, const ChangingShape& changing, Args& args,
         const Place& where)
      : builder_(builder), type_(type), args_(args), where_(where) {
    for (const ChangingShape::Argument& argument : changing.arguments)
      reading_ += corner_count(Shape{}) + argument.text.size();
  }

  // Whether it can be built then, or is not there.
  bool at(double time) {
    const std::size_t problems = builder_.in.problems.size();
    args_.set_time(time);
    Result<Shape> shape = type_.build(args_);
    if (builder_.in.problems.size() > problems) return false;
    was_gone_ |= args_.gone();
    if (args_.gone()) return count(reading_);
    if (!shape) {
      for (Diagnostic& one : shape.error()) {
        one.message += fmt::format(" at {} s", number_text(time));
        builder_.in.problems.push_back(std::move(one));
      }
      return false;
    }
    return take(std::move(*shape));
  }

  bool was_gone() const { return was_gone_; }

  // The one with most corners of all seen.
  Shape largest() && { return std::move(largest_); }

 private:
  bool take(Shape&& shape) {
    const std::uint64_t corners = corner_count(shape);
    if (corners > corner_count(largest_)) largest_ = std::move(shape);
    return count(corners);
  }

  bool count(std::uint64_t corners) {
    const std::uint64_t limit = builder_.limits.max_corners;
    builder_.checked_corners += corners;
    if (builder_.checked_corners <= limit) return true;
    builder_.in.problem(
        where_,
        fmt::format(
            "shapes that change come to more than {} corners in the frames up to their last keys",
            limit),
        "end the curves earlier, let one number change alone, share a shape among copies, or say "
        "--max-corners N");
    return false;
  }

  Builder& builder_;
  const ShapeType& type_;
  Args& args_;
  const Place& where_;
  std::uint64_t reading_ = 0;  // what the arguments count for where nothing comes of them
  bool was_gone_ = false;
  Shape largest_;
};

bool try_all(const Scene& scene, const ChangingShape& changing, Trials& trials) {
  const std::set<double> times = key_times(scene, changing);
  if (!std::ranges::all_of(times, [&](double time) { return trials.at(time); })) return false;
  if (!may_fail_between_keys(changing, trials.was_gone())) return true;
  for (unsigned frame = 1; frame <= kLastFrame; ++frame) {  // any may be asked for
    const double time = (frame - 1) / scene.fps;
    if (time >= *times.rbegin()) return true;
    if (time > *times.begin() && !trials.at(time)) return false;
  }
  return true;
}

}  // namespace

std::optional<ShapeId> build_changing_shape(Builder& builder, const ShapeType& type,
                                            const Field& arguments) {
  const std::size_t problems = builder.in.problems.size();
  ChangingShape changing{{}, &type};
  Args args(builder, arguments, type.keys, &changing);
  (void)type.build(args);  // reads the arguments
  if (builder.in.problems.size() > problems || builder.full) return std::nullopt;
  Scene& scene = builder.scene;
  Trials trials(builder, type, changing, args, arguments.value.where);
  if (!try_all(scene, changing, trials)) return std::nullopt;
  Shape shape = std::move(trials).largest();
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
