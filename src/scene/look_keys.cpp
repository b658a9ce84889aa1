#include "scene/look_keys.h"

#include "scene/keys.h"
#include "scene/motion_keys.h"

namespace flatray {
namespace {

std::optional<Moving> constant(const std::optional<double>& value) {
  return value ? std::optional(Moving{*value, {}}) : std::nullopt;
}

template <bool in_pixels>
void read_width(Builder& builder, const Field& field, Stroke& stroke) {
  const auto width =
      builder.stroke_may_change ? read_moving(builder, field) : constant(builder.in.number(field));
  if (!width) return;
  if (width->curve && lowest(builder.scene.curves[*width->curve]) < 0)
    return builder.in.problem(field.value.where, field.name + " goes below 0",
                              "end the curve at 0: nothing is drawn then");
  if (!width->curve && !(width->value > 0))
    return builder.in.problem(field.value.where, field.name + " is not above 0",
                              R"(leave the stroke out, or write stroke = "none")");
  stroke.width = width->value;
  stroke.width_curve = width->curve;
  stroke.in_pixels = in_pixels;
}

constexpr Key<Stroke> kStrokeKeys[] = {
    {{"width", "world units", "none"}, &read_width<false>},
    {{"width_px", "pixels", "1.5"}, &read_width<true>},
    {{"colour", "\"#rrggbb\"", "as the table says"}, &set<&Stroke::colour>},
};

bool is_none(const Value& value) {
  return value.kind == Value::Kind::string && value.text == "none";
}

}  // namespace

bool read_stroke(Builder& builder, const Field& field, Stroke& stroke) {
  const std::size_t problems = builder.in.problems.size();
  read_keys<Stroke>(builder, field.value, "stroke", kStrokeKeys, stroke);
  const Member* both = field.value.find("width") ? field.value.find("width_px") : nullptr;
  if (both != nullptr)
    builder.in.problem(both->where, "stroke has both width and width_px",
                       "width counts world units, width_px pixels: keep one");
  return builder.in.problems.size() == problems;
}

void read_fill(Builder& builder, const Field& field, std::optional<Colour>& target) {
  using Fill = std::optional<Colour>;
  const auto read = [&](const Field& one) -> std::optional<Fill> {
    if (is_none(one.value)) return Fill{};
    const Fill colour = builder.in.colour(one);
    return colour ? std::optional(colour) : std::nullopt;
  };
  if (const std::optional<Fill> fill = builder.in.chosen(field, read)) target = *fill;
}

void read_optional_stroke(Builder& builder, const Field& field, std::optional<Stroke>& target) {
  Stroke stroke = kDefaultStroke;
  if (is_none(field.value))
    target.reset();
  else if (read_stroke(builder, field, stroke))
    target = stroke;
}

std::vector<TableInfo> look_tables() { return {{"stroke", key_infos<Stroke>(kStrokeKeys)}}; }

}  // namespace flatray
