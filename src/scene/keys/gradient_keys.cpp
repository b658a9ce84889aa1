#include "base/counted.h"
#include "scene/keys/corner_limit.h"
#include "scene/keys/curve_keys.h"
#include "scene/keys/look_keys.h"

namespace flatray {
namespace {

constexpr std::size_t kMostStops = 256;

// "#rrggbb" or [at, "#rrggbb"].
std::optional<Gradient::Stop> read_stop(Builder& builder, const Field& field, double evenly) {
  if (field.value.kind != Value::Kind::array) {
    const auto colour = builder.in.colour(field);
    return colour ? std::optional(Gradient::Stop{evenly, *colour}) : std::nullopt;
  }
  if (field.value.items.size() != 2)
    return builder.in.refuse(field, "is not a place and a colour", "write [0.25, \"#rrggbb\"]");
  const auto at = builder.in.number(field.item(0));
  const auto colour = builder.in.colour(field.item(1));
  if (!at || !colour) return std::nullopt;
  if (*at >= 0 && *at <= 1) return Gradient::Stop{*at, *colour};
  return builder.in.refuse(field.item(0), "does not lie between 0 and 1",
                           "0 is the beginning of the gradient, 1 its end");
}

template <class Words>
void read_stops(Builder& builder, const Field& field, Words& gradient) {
  if (!builder.in.is(field, Value::Kind::array, "a list of colours")) return;
  const std::vector<Value>& items = field.value.items;
  if (items.size() < 2 || items.size() > kMostStops)
    return builder.in.problem(field, fmt::format("has {}", counted(items.size(), "colour")),
                              fmt::format("write from 2 to {}", kMostStops));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double evenly = static_cast<double>(i) / static_cast<double>(items.size() - 1);
    const auto stop = read_stop(builder, field.item(i), evenly);
    if (!stop) continue;
    if (!gradient.stops.empty() && stop->at < gradient.stops.back().at)
      builder.in.problem(field.item(i), "comes before the one it follows",
                         "write the colours in the order of their places");
    gradient.stops.push_back(*stop);
  }
}

struct LinearWords : Gradient {
  Vec2 to{1, 0};
};
struct RadialWords : Gradient {
  Vec2 centre{0, 0};
  double radius = 0;
};

constexpr NumberRule kRadiusRule{[](double radius) { return radius > 0 && radius <= kFarthest; },
                                 "is not above 0",
                                 "the last colour lies on a circle of this radius"};

constexpr const char* kStopsTake = R"(["#rrggbb" or [at, "#rrggbb"], ...])";

constexpr Key<LinearWords> kLinearKeys[] = {
    {{"from", "[x, y]", kRequired}, &set<&LinearWords::from>},
    {{"to", "[x, y]", kRequired}, &set<&LinearWords::to>},
    {{"stops", kStopsTake, kRequired}, &read_stops<LinearWords>},
};
constexpr Key<RadialWords> kRadialKeys[] = {
    {{"centre", "[x, y]", "[0, 0]"}, &set<&RadialWords::centre>},
    {{"radius", "number", kRequired}, &set_number<&RadialWords::radius, kRadiusRule>},
    {{"stops", kStopsTake, kRequired}, &read_stops<RadialWords>},
};

std::optional<Gradient> read_linear(Builder& builder, const Value& table) {
  LinearWords words;
  if (!read_keys(builder, table, "linear", kLinearKeys, words)) return std::nullopt;
  words.along = words.to - words.from;
  if (words.from != words.to) return words;
  return builder.in.refuse(
      {table.where, "the gradient has no length", "write where its first and its last colour are"});
}

std::optional<Gradient> read_radial(Builder& builder, const Value& table) {
  RadialWords words;
  if (!read_keys(builder, table, "radial", kRadialKeys, words)) return std::nullopt;
  words.radial = true;
  words.from = words.centre;
  words.along = {words.radius, 0};
  return words;
}

}  // namespace

std::optional<Paint> read_paint(Builder& builder, const Field& field) {
  const bool is_table = field.value.kind == Value::Kind::table && field.value.members.size() == 1;
  const std::string kind = is_table ? field.value.members.front().key : "";
  if (kind != "linear" && kind != "radial") return read_moving_colour(builder, field);
  const Value& table = field.value.members.front().value;
  auto gradient = kind == "linear" ? read_linear(builder, table) : read_radial(builder, table);
  if (!gradient || !take_corners(builder, gradient->stops.size(), field.value.where))
    return std::nullopt;
  const Colour first = gradient->stops.front().colour;
  builder.scene.gradients.push_back(*std::move(gradient));
  return Paint(first, static_cast<std::uint32_t>(builder.scene.gradients.size() - 1));
}

std::vector<TableInfo> gradient_tables() {
  return {{"linear", key_infos<LinearWords>(kLinearKeys), true},
          {"radial", key_infos<RadialWords>(kRadialKeys), true}};
}

}  // namespace flatray
