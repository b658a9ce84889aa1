#pragma once
#include "scene/keys/curve_keys.h"
#include "scene/keys/keys.h"
#include "scene/material.h"

namespace flatray {

inline constexpr Colour kDefaultColour{0x33, 0x33, 0x33, 255};
inline constexpr Colour kPillarColour{0x99, 0x99, 0x99, 255};
inline constexpr Colour kClearColour{0xff, 0xff, 0xff, 0x18};  ///< of glass: light is below it
inline constexpr Stroke kDefaultStroke{1.5, true, kDefaultColour};

/// `{ width, colour }`; what is not given stays as it is in `stroke`. False where it is wrong.
bool read_stroke(Builder& builder, const Field& field, Stroke& stroke);

/// The fill of what is given none: that of glass where light goes through it, else `fill`.
Paint default_fill(const Scene& scene, ScattererId scatterer, const Colour& fill);

/// Colour, or `{ linear = { ... } }` or `{ radial = { ... } }`.
std::optional<Paint> read_paint(Builder& builder, const Field& field);

/// Colour, gradient or stroke that may be "none"; what is wrong leaves `target` as it is.
void read_fill(Builder& builder, const Field& field, std::optional<Paint>& target);
void read_optional_stroke(Builder& builder, const Field& field, std::optional<Stroke>& target);

/// Keys that several tables have alike.
template <class T>
void set_shape(Builder& builder, const Field& field, T& target) {
  if (const auto shape = read_shape(builder, field)) target.shape = *shape;
}
template <class T>
void set_fill(Builder& builder, const Field& field, T& target) {
  read_fill(builder, field, target.fill);
}
template <auto Pointer>
void set_stroke(Builder& builder, const Field& field, OwnerOf<Pointer>& target) {
  read_optional_stroke(builder, field, target.*Pointer);
}
template <class T>
inline constexpr Key<T> kNameKey = {{"name", "\"NAME\"", "\"\""}, &set<&T::name, T>};
template <class T>
inline constexpr Key<T> kShapeKey = {{"shape", "{ KIND = { ... } }", kRequired}, &set_shape<T>};
template <class T>
inline constexpr Key<T> kAtKey = {{"at", "[x, y]", "[0, 0]"}, &set<&T::at>};
template <class T>
inline constexpr Key<T> kAngleKey = {{"angle", "degrees", "0"}, &set_angle<&T::angle>};
template <class T>
inline constexpr Key<T> kLayerKey = {{"layer", "whole number", "0"},
                                     &set_integer<&T::layer, -1000000, 1000000>};
inline constexpr NumberRule kOpacityRule{
    [](double opacity) { return opacity >= 0 && opacity <= 1; }, "does not lie between 0 and 1",
    "0 is not seen, 1 is opaque"};
template <class T>
inline constexpr Key<T> kOpacityKey = {{"opacity", "number", "1"},
                                       &set_number<&T::opacity, kOpacityRule>};
template <class T>
void set_moving_opacity(Builder& builder, const Field& field, T& target) {
  const std::optional<Moving> opacity = read_moving(builder, field);
  if (!opacity) return;
  if (!lies_between(builder.scene, *opacity, 0, 1))
    return builder.in.problem(field, kOpacityRule.broken, kOpacityRule.hint);
  target.opacity = *opacity;
}
template <class T>
inline constexpr Key<T> kMovingOpacityKey = {{"opacity", "number or a curve", "1"},
                                             &set_moving_opacity<T>};
template <class T, const auto& words = kMaterialWords>
void set_material(Builder& builder, const Field& field, T& target) {
  const auto read = read_material(builder, field, words);
  if (!read) return;
  target.material = read->material;
  target.scatterer = read->scatterer;
}
template <class T>
constexpr Key<T> material_key(const char* fallback) {
  return {{"material", R"("absorb", "mirror" or { MATERIAL = { ... } })", fallback},
          &set_material<T>};
}
template <class T>
constexpr Key<T> fill_key(const char* fallback) {
  return {{"fill", R"("#rrggbb", "none", { linear = { ... } } or { radial = { ... } })", fallback},
          &set_fill<T>};
}
template <class T>
constexpr Key<T> stroke_key(const char* fallback) {
  return {{"stroke", R"({ width = w, colour = "#rrggbb" } or "none")", fallback},
          &set_stroke<&T::stroke>};
}

std::vector<TableInfo> look_tables();
std::vector<TableInfo> gradient_tables();

}  // namespace flatray
