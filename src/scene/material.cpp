#include "scene/material.h"

#include <algorithm>
#include <numbers>

#include "base/light.h"
#include "base/number_text.h"
#include "scene/reading/kinds.h"

namespace flatray {

#include "materials.inc"  // material_types()

namespace {

std::optional<ScattererId> build_scatterer(Builder& builder, const Field& field) {
  const std::size_t problems = builder.in.problems.size();
  const auto kind = read_kind(builder.in, field, material_types(), "a material");
  if (!kind) return std::nullopt;
  Args args(builder, {std::string("material.") + kind->type->name, kind->arguments, "{ ... }"},
            kind->type->keys);
  Result<std::unique_ptr<const Scatterer>> made = kind->type->build(args);
  if (builder.in.problems.size() > problems) return std::nullopt;
  if (!made) {
    builder.in.add(std::move(made.error()));
    return std::nullopt;
  }
  builder.scene.scatterers.emplace_back(std::move(*made));
  return static_cast<ScattererId>(builder.scene.scatterers.size() - 1);
}

// 1 - x2 / a + x2^2 / (a b) - ..., by Horner's rule.
template <std::size_t N>
double series(double x2, const double (&factors)[N]) {
  double sum = 1;
  for (std::size_t i = N; i-- > 0;) sum = 1 - x2 * factors[i] * sum;
  return sum;
}

// The direction at `u` of a turn, within 2^-50: of the middle of its quarter, turned by at most an
// eighth, whose sine and cosine are series.
Vec2 any_direction(double u) {
  constexpr double kSine[] = {1 / 6.,   1 / 20.,  1 / 42.,  1 / 72.,
                              1 / 110., 1 / 156., 1 / 210., 1 / 272.};
  constexpr double kCosine[] = {1 / 2.,   1 / 12.,  1 / 30.,  1 / 56., 1 / 90.,
                                1 / 132., 1 / 182., 1 / 240., 1 / 306.};
  constexpr double kMiddles[][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const int quarter = static_cast<int>(4 * u);
  const double angle = std::numbers::pi / 2 * (4 * u - quarter - 0.5), square = angle * angle;
  const double half = std::numbers::sqrt2 / 2;
  const double sine = half * angle * series(square, kSine), cosine = half * series(square, kCosine);
  const auto& [x, y] = kMiddles[quarter];
  return {x * cosine - y * sine, y * cosine + x * sine};
}

class Mixture : public Scatterer {
 public:
  Mixture(const LightShares& shares, Material for_rays) : shares_(shares), for_rays_(for_rays) {}

  Departure scatter(const Arrival& arrival, double u) const override {
    using Way = Departure::Way;
    const std::array<float, 3>& tint = shares_.tint;
    if (u < shares_.diffuse)
      return {Way::scattered, lambert_direction(arrival.normal, u / shares_.diffuse), tint, true};
    u -= shares_.diffuse;
    if (u < shares_.isotropic) return {Way::scattered, any_direction(u / shares_.isotropic), tint};
    u -= shares_.isotropic;
    if (u < shares_.mirror) return {Way::mirrored, {1, 0}, tint};
    u -= shares_.mirror;
    if (u < shares_.pass) return {Way::through, {1, 0}, tint};
    return {};
  }
  const LightShares* shares() const override { return &shares_; }
  Material for_rays() const override { return for_rays_; }
  bool colours() const override {
    return shares_.tint[0] != shares_.tint[1] || shares_.tint[1] != shares_.tint[2];
  }

 private:
  LightShares shares_;
  Material for_rays_;
};

}  // namespace

Reflectance read_reflectance(Args& args, const char* key) {
  const double part = args.number(key, 1);
  const Colour colour = args.colour("colour", {255, 255, 255, 255});
  if (!(part >= 0 && part <= 1))
    args.problem(key, fmt::format("is {}, not between 0 and 1", number_text(part)),
                 "0 absorbs all light, 1 gives all back");
  if (colour.a < 255)
    args.problem("colour", "has an opacity, which a wall has not for light", "write #rrggbb");
  const std::array<float, 3> light{linear_from_srgb(colour.r), linear_from_srgb(colour.g),
                                   linear_from_srgb(colour.b)};
  const float most = *std::ranges::max_element(light);
  if (part == 0 || most == 0)
    args.warning(args.place(part == 0 ? key : "colour"), "the material sends no light on",
                 "write \"absorb\", which says so");
  if (most == 0) return {0, {1, 1, 1}};
  return {part * static_cast<double>(most), {light[0] / most, light[1] / most, light[2] / most}};
}

std::unique_ptr<const Scatterer> mixture(const LightShares& shares, Material for_rays) {
  return std::make_unique<Mixture>(shares, for_rays);
}

std::optional<ReadMaterial> read_material(Builder& builder, const Field& field,
                                          std::span<const Word<Material>> words) {
  if (field.value.kind != Value::Kind::table) {
    const std::string& text = field.value.text;
    const auto is_word = [&](const auto& word) { return word.first == text; };
    const auto is_type = [&](const auto* type) { return type->name == text; };
    if (field.value.kind != Value::Kind::string || std::ranges::any_of(words, is_word)) {
      const auto material = builder.in.word<Material>(field, words);
      return material ? std::optional(ReadMaterial{*material}) : std::nullopt;
    }
    if (std::ranges::any_of(material_types(), is_type))
      return builder.in.refuse(field, fmt::format("'{}' has numbers of its own", text),
                               fmt::format("write {{ {} = {{}} }}", text));
    std::vector<std::string> known = names_of(words);
    for (const auto* type : material_types())
      if (std::ranges::find(known, type->name) == known.end()) known.emplace_back(type->name);
    return builder.in.refuse(unknown_word(field.value.where, field.name, text, known));
  }
  const auto known = builder.fixed_scatterers.find(&field.value);
  const std::optional<ScattererId> scatterer = known != builder.fixed_scatterers.end()
                                                   ? std::optional(known->second)
                                                   : build_scatterer(builder, field);
  if (!scatterer) return std::nullopt;
  if (!has_distribution(field.value)) builder.fixed_scatterers.emplace(&field.value, *scatterer);
  return ReadMaterial{builder.scene.scatterers[*scatterer]->for_rays(), *scatterer};
}

const Place* place_of_glass(const Scene& scene) {
  for (const Entity& entity : scene.entities)
    if (entity.material == Material::glass) return &entity.where;
  for (const Chamber& chamber : scene.chambers) {
    if (chamber.material == Material::glass) return &chamber.where;
    for (const Chamber::Pillar& pillar : chamber.pillars)
      if (pillar.material == Material::glass) return &pillar.where;
  }
  return nullptr;
}

}  // namespace flatray
