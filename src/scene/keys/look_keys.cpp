#include "scene/keys/look_keys.h"

#include <algorithm>

#include "base/counted.h"
#include "scene/keys/corner_limit.h"
#include "scene/keys/keys.h"
#include "scene/keys/motion_keys.h"

namespace flatray {
namespace {

template <bool in_pixels>
void read_width(Builder& builder, const Field& field, Stroke& stroke) {
  const auto width = read_moving(builder, field, nullptr, builder.may_change);
  if (!width) return;
  if (width->curve && lowest(builder.scene.curves[*width->curve]) < 0)
    return builder.in.problem(field, "goes below 0", "end the curve at 0: nothing is drawn then");
  if (!width->curve && !(width->value > 0))
    return builder.in.problem(field, "is not above 0",
                              R"(leave the stroke out, or write stroke = "none")");
  stroke.width = width->value;
  stroke.width_curve = width->curve;
  stroke.in_pixels = in_pixels;
}

constexpr NumberRule kMiterLimitRule{
    [](double limit) { return limit >= 1; }, "is below 1",
    "it counts widths of the line: 4 lets corners of 29 degrees be sharp"};
constexpr NumberRule kDashOffsetRule{
    [](double offset) { return offset >= -kFarthest && offset <= kFarthest; }, "lies beyond 1e300",
    "write a length"};

std::vector<double> dash_lengths(Builder& builder, const Field& field) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < field.value.items.size(); ++i) {
    const double length = builder.in.number(field.item(i)).value_or(0);
    if (!(length >= 0 && length <= kFarthest))
      builder.in.problem(field.item(i), "is not a length",
                         "write numbers from 0 to 1e300: line, gap, line, gap, ...");
    lengths.push_back(length);
  }
  return lengths;
}

void read_dashes(Builder& builder, const Field& field, Stroke& stroke) {
  constexpr std::size_t kMostLengths = 100;
  if (!builder.in.is(field, Value::Kind::array, "a list of numbers")) return;
  if (field.value.items.size() > kMostLengths)
    return builder.in.problem(field,
                              fmt::format("has {}", counted(field.value.items.size(), "length")),
                              fmt::format("at most {}", kMostLengths));
  const std::size_t problems = builder.in.problems.size();
  std::vector<double> lengths = dash_lengths(builder, field);
  if (builder.in.problems.size() > problems) return;
  if (std::ranges::count(lengths, 0.0) == static_cast<std::ptrdiff_t>(lengths.size()))
    return builder.in.problem(field, "have no length",
                              "write line, gap, ..., or leave them out for a whole line");
  if (lengths.size() % 2 == 1)
    for (std::size_t i = 0, count = lengths.size(); i < count; ++i) lengths.push_back(lengths[i]);
  if (!take_corners(builder, lengths.size(), field.value.where)) return;
  stroke.dashes = static_cast<std::uint32_t>(builder.scene.dashes.size());
  builder.scene.dashes.push_back(std::move(lengths));
}

void read_stroke_colour(Builder& builder, const Field& field, Stroke& stroke) {
  if (const auto paint = read_paint(builder, field)) stroke.colour = *paint;
}

constexpr Word<LineJoin> kJoins[] = {
    {"round", LineJoin::round}, {"miter", LineJoin::miter}, {"bevel", LineJoin::bevel}};
constexpr Word<LineCap> kCaps[] = {
    {"round", LineCap::round}, {"butt", LineCap::butt}, {"square", LineCap::square}};

constexpr Key<Stroke> kStrokeKeys[] = {
    {{"width", "world units or a curve", "none"}, &read_width<false>},
    {{"width_px", "pixels or a curve", "1.5"}, &read_width<true>},
    {{"colour", R"("#rrggbb", a curve, { linear = { ... } } or { radial = { ... } })",
      "as the table says"},
     &read_stroke_colour},
    {{"joins", R"("round", "miter" or "bevel")", R"("round")"}, &set_word<&Stroke::joins, kJoins>},
    {{"caps", R"("round", "butt" or "square")", R"("round")"}, &set_word<&Stroke::caps, kCaps>},
    {{"miter_limit", "number", "4"}, &set_number<&Stroke::miter_limit, kMiterLimitRule>},
    {{"dashes", "[line, gap, ...]", "none"}, &read_dashes},
    {{"dash_offset", "number", "0"}, &set_number<&Stroke::dash_offset, kDashOffsetRule>},
};

bool is_none(const Value& value) {
  return value.kind == Value::Kind::string && value.text == "none";
}

}  // namespace

bool read_stroke(Builder& builder, const Field& field, Stroke& stroke) {
  const std::string name = field.name.substr(field.name.rfind('.') + 1);  // or bounding_box
  const bool right = read_keys(builder, field.value, name, kStrokeKeys, stroke);
  const Member* both = field.value.find("width") ? field.value.find("width_px") : nullptr;
  if (both != nullptr)
    builder.in.problem(both->where, "stroke has both width and width_px",
                       "width counts world units, width_px pixels: keep one");
  return right && both == nullptr;
}

Paint default_fill(const Scene& scene, ScattererId scatterer, const Colour& fill) {
  return scatterer != kNoEntry && scene.scatterers[scatterer]->is_clear() ? kClearColour : fill;
}

void read_fill(Builder& builder, const Field& field, std::optional<Paint>& target) {
  using Fill = std::optional<Paint>;
  const auto read = [&](const Field& one) -> std::optional<Fill> {
    if (is_none(one.value)) return Fill{};
    const Fill paint = read_paint(builder, one);
    return paint ? std::optional(paint) : std::nullopt;
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

std::vector<TableInfo> look_tables() { return {{"stroke", key_infos<Stroke>(kStrokeKeys), true}}; }

}  // namespace flatray
