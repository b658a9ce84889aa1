#include <algorithm>

#include "base/number_text.h"
#include "scene/keys/changing_shape.h"
#include "scene/keys/copies.h"
#include "scene/keys/corner_limit.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/markov_keys.h"
#include "scene/keys/motion_keys.h"
#include "scene/keys/scene_keys.h"
#include "scene/lamp.h"
#include "scene/part_counts.h"
#include "scene/reading/kinds.h"
#include "scene/reading/spectrum_text.h"

namespace flatray {
namespace {

constexpr std::int64_t kMostRays = std::int64_t{1} << 40;
constexpr std::int64_t kMostBounces = 1'000'000;

void read_source(Builder& builder, const Field& field, Lamp& lamp) {
  const std::size_t problems = builder.in.problems.size();
  const auto kind = read_kind(builder.in, field, lamp_types(), "a lamp");
  if (!kind) return;
  lamp.type = kind->type;
  lamp.source = {};
  Args args(builder, {std::string("lamp.") + kind->type->name, kind->arguments, "{ ... }"},
            kind->type->keys, &lamp.source);
  bool was_gone = false;
  const auto can_be_built = [&](double time, const std::string& when) {
    args.set_time(time);
    const auto made = kind->type->build(args);
    was_gone |= args.gone();
    const bool may_vanish = args.gone() && has_curve(kind->arguments);
    if (!made && !may_vanish && builder.in.problems.size() == problems)
      for (Diagnostic one : made.error()) {
        one.message += when;
        builder.in.problems.push_back(std::move(one));
      }
    return builder.in.problems.size() == problems;
  };
  const auto can_be_at = [&](double time) {
    return can_be_built(time, fmt::format(" at {} s", number_text(time)));
  };
  if (!can_be_built(0, "")) return;
  const std::set<double> times = key_times(builder.scene, lamp.source);
  if (!std::ranges::all_of(times, can_be_at)) return;
  if (was_gone || curves_of(lamp.source).size() > 1)
    (void)holds_in_frames_between(times, builder.scene.fps, can_be_at);
}

struct Limits {
  double low, high;
  const char* hint;
};
constexpr Limits kPowerLimits{0, 1e30, "write 0 to 1e30, 1 for a plain lamp"};
constexpr Limits kWavelengthLimits{380, 780, "light that is seen has 380 to 780 nm"};
constexpr Limits kTemperatureLimits{
    800, 1e5, "write 800 to 100000 kelvin, 2700 for a bulb, 6500 for daylight"};

// A number that may be a curve and whose values all lie within limits.
template <auto Pointer, const Limits& limits>
void set_within(Builder& builder, const Field& field, Lamp& lamp) {
  const std::optional<Moving> number = read_moving(builder, field);
  if (!number) return;
  lamp.*Pointer = *number;
  const double least = lowest(builder.scene, *number), most = highest(builder.scene, *number);
  if (least >= limits.low && most <= limits.high) return;
  builder.in.problem(field,
                     fmt::format("{} {}, not {} to {}", number->curve ? "comes to" : "is",
                                 number_text(least >= limits.low ? most : least),
                                 number_text(limits.low), number_text(limits.high)),
                     limits.hint);
}

// A file that several lamps have is read once.
void read_spectrum(Builder& builder, const Field& field, Lamp& lamp) {
  const auto name = builder.in.string(field);
  if (!name) return;
  Result<SourcePtr> source = builder.imports.open(*name, field.value.where);
  if (!source) return builder.in.add(std::move(source.error()));
  const auto [known, is_new] = builder.spectra.try_emplace(source->get());
  if (is_new) {
    Result<Spectrum> spectrum = parse_spectrum(*source);
    if (!spectrum) return builder.in.add(std::move(spectrum.error()));
    known->second = std::make_shared<const Spectrum>(std::move(*spectrum));
  }
  lamp.spectrum = known->second;
}

void read_colour(Builder& builder, const Field& field, Lamp& lamp) {
  const auto colour = read_moving_colour(builder, field);
  if (!colour) return;
  constexpr CurveId kAlpha = 3;  // of the four curves of a colour
  const bool clear = colour->curve == kNoEntry
                         ? colour->a < 255
                         : lowest(builder.scene.curves[colour->curve + kAlpha]) < 1;
  if (clear)
    return builder.in.problem(field, "has an opacity, which light has not",
                              "write #rrggbb, and a power below 1 for less light");
  lamp.colour = *colour;
}

void expect_one_colour(Builder& builder, const LampLight& light, const Value& table) {
  std::vector<std::string> colours;
  if (table.find("colour") != nullptr) colours.emplace_back("colour");
  if (light.wavelength) colours.emplace_back("nm");
  if (light.temperature) colours.emplace_back("kelvin");
  if (light.spectrum) colours.emplace_back("spectrum");
  if (colours.size() > 1)
    builder.in.problem(table.where, fmt::format("a lamp has {} and {}", colours[0], colours[1]),
                       "leave one of them out: either is a colour");
}

// What a state gives; the rest is the lamp's, its colour as a whole.
constexpr const char* kOwn = "the lamp's";
constexpr Key<Lamp> kLampLookKeys[] = {
    kNameKey<Lamp>,
    {{"power", "number or a curve", kOwn}, &set_within<&Lamp::power, kPowerLimits>},
    {{"colour", "\"#rrggbb\" or a curve", kOwn}, &read_colour, true},
    {{"nm", "number or a curve", kOwn}, &set_within<&Lamp::wavelength, kWavelengthLimits>},
    {{"kelvin", "number or a curve", kOwn}, &set_within<&Lamp::temperature, kTemperatureLimits>},
    {{"spectrum", "\"spectrum.csv\"", kOwn}, &read_spectrum},
    {{"velocity", "[vx, vy]", kOwn}, &set<&Lamp::velocity, Lamp>},
};

Look read_lamp_look(Builder& builder, const Value& table, const std::string& name,
                    const Lamp& lamp) {
  Lamp now;
  now.power = lamp.power;
  const auto has = [&](const char* key) { return table.find(key) != nullptr; };
  if (!has("colour") && !has("nm") && !has("kelvin") && !has("spectrum"))
    static_cast<LampLight&>(now) = lamp;
  read_keys(builder, table, "lamp " + name, kLampLookKeys, now);
  expect_one_colour(builder, now, table);
  Look look;
  look.name = now.name;
  if (has("velocity")) look.velocity = now.velocity;
  look.light = std::make_shared<const LampLight>(std::move(now));
  return look;
}

void read_lamp_states(Builder& builder, const Field& field, Lamp& lamp) {
  read_looks(builder, field, lamp.markov, [&](const Value& table, const std::string& name) {
    return read_lamp_look(builder, table, name, lamp);
  });
}

constexpr Key<Lamp> kLampKeys[] = {
    kNameKey<Lamp>,
    {{"source", "{ LAMP = { ... } }", kRequired}, &read_source},
    kGroupKey<Lamp>,
    kMovingAtKey<Lamp>,
    kMovingAngleKey<Lamp>,
    kVelocityKey<Lamp>,
    kAngularVelocityKey<Lamp>,
    {{"power", "number or a curve", "1"}, &set_within<&Lamp::power, kPowerLimits>},
    {{"colour", "\"#rrggbb\" or a curve", "\"#ffffff\""}, &read_colour, true},
    {{"nm", "number or a curve", "none"}, &set_within<&Lamp::wavelength, kWavelengthLimits>},
    {{"kelvin", "number or a curve", "none"}, &set_within<&Lamp::temperature, kTemperatureLimits>},
    {{"spectrum", "\"spectrum.csv\"", "none"}, &read_spectrum},
    kMarkovKey<Lamp>,
    states_key<Lamp>(&read_lamp_states),
    kFollowKey<Lamp>,
    kRepeatKey<Lamp>,
};

void read_exposure(Builder& builder, const Field& field, LightSettings& light) {
  if (field.value.kind == Value::Kind::string) {
    constexpr Word<bool> kWords[] = {{"auto", true}};
    (void)builder.in.word<bool>(field, kWords);
    return;
  }
  const auto exposure = builder.in.number(field);
  if (!exposure) return;
  if (!(*exposure > 0 && *exposure <= 1e30))
    return builder.in.problem(
        field, fmt::format("is {}, not above 0 and at most 1e30", number_text(*exposure)),
        "write what light of 1 is to be shown as, or \"auto\"");
  light.exposure = *exposure;
}

constexpr NumberRule kGammaRule{[](double gamma) { return gamma >= 0.1 && gamma <= 10; },
                                "does not lie between 0.1 and 10",
                                "write 2.2, or 1 for levels in proportion to light"};

void read_scrambles(Builder& builder, const Field& field, LightSettings& light) {
  const auto count = builder.in.integer(field, 1, 64);
  if (!count) return;
  if (*count != 1 && *count != 16 && *count != 32 && *count != 64)
    return builder.in.problem(field, "is neither 1 nor 16, 32 or 64",
                              "write 16 where the error is asked for");
  light.scrambles = static_cast<unsigned>(*count);
}

void read_bounces(Builder& builder, const Field& field, LightSettings& light) {
  set_integer<&LightSettings::bounces, 0, kMostBounces>(builder, field, light);
  light.bounces_chosen = true;
}

constexpr Word<LightSampler> kSamplers[] = {{"sorted", LightSampler::sorted},
                                            {"random", LightSampler::random}};
constexpr Word<LightEstimator> kEstimators[] = {{"auto", LightEstimator::automatic},
                                                {"forward", LightEstimator::forward},
                                                {"backward", LightEstimator::backward}};
constexpr Word<bool> kNoises[] = {{"still", false}, {"moving", true}};

constexpr Key<LightSettings> kLightKeys[] = {
    {{"rays", "whole number", "1000000"}, &set_integer<&LightSettings::rays, 1, kMostRays>},
    {{"bounces", "whole number", "1000"}, &read_bounces},
    {{"scrambles", "whole number", "1"}, &read_scrambles},
    {{"exposure", "number or \"auto\"", "\"auto\""}, &read_exposure},
    {{"tone", R"("linear", "soft", "filmic" or "gamma")", "\"soft\""},
     &set_word<&LightSettings::tone, kToneCurves>},
    {{"gamma", "number", "2.2"}, &set_number<&LightSettings::gamma, kGammaRule>},
    {{"sampler", R"("sorted" or "random")", "\"sorted\""},
     &set_word<&LightSettings::sampler, kSamplers>},
    {{"estimator", R"("forward", "backward" or "auto")", "\"auto\""},
     &set_word<&LightSettings::estimator, kEstimators>},
    {{"noise", R"("still" or "moving")", "\"still\""},
     &set_word<&LightSettings::noise_moves, kNoises>},
    {{"layer", "whole number", "-1"}, &set_integer<&LightSettings::layer, -1000000, 1000000>},
};

// Whether light is surely inside or outside of it, by the side of each of its walls. A ring of a whole turn
// has a slit, whose two sides lie on one another.
bool is_body(const Shape& shape) {
  const PartCounts parts = part_counts(shape);
  const auto has_slit = [](const ArcPath& path) {
    return path.arcs.size() > 1 && std::ranges::all_of(path.arcs, &EllipseArc::is_whole);
  };
  return parts.lines() + parts.crossing_rings == 0 && parts.areas() > 0 &&
         std::ranges::none_of(shape.arc_paths, has_slit);
}

const char* reason_dark(const Scene& scene, const LampLight& light) {
  if (lies_between(scene, light.power, 0, 0)) return "its power is 0";
  if (light.wavelength || light.temperature || light.spectrum) return nullptr;
  const Paint& colour = light.colour;
  if (colour.curve == kNoEntry)
    return colour.r == 0 && colour.g == 0 && colour.b == 0 ? "its colour is black" : nullptr;
  for (CurveId channel = 0; channel < 3; ++channel)
    if (highest(scene.curves[colour.curve + channel]) > 0) return nullptr;
  return "its colour is black";
}

// What leaves a lamp dark in all frames and states; nothing where it shines.
const char* reason_dark(const Scene& scene, const Lamp& lamp) {
  const auto lights = lights_of(lamp);
  for (const LampLight* light : lights)
    if (reason_dark(scene, *light) == nullptr) return nullptr;
  return reason_dark(scene, *lights.front());
}

// Lamps meet nothing, and the scene keeps what they look like.
bool take_states(Builder& builder, const Lamp& lamp, const Place& where) {
  if (lamp.markov && lamp.markov->hit)
    builder.in.problem(where, "a lamp has a state for what is hit, but meets nothing",
                       "leave hit out");
  return take_corners(builder, corner_count(lamp.markov), where);
}

void expect_body(Builder& builder, ScattererId scatterer, ShapeId shape, const Place& where) {
  const Scene& scene = builder.scene;
  if (scatterer == kNoEntry || scene.scatterers[scatterer]->index(0) == 0 ||
      shape >= scene.shapes.size() || is_body(scene.shapes[shape]))
    return;
  builder.in.problem(
      where, "what is of glass here has no inside, or is a ring with a slit",
      "glass is for polygons, circles, ellipses, and what arcs enclose; make a ring of a "
      "disc with one of index = 1 in it");
}

}  // namespace

void check_light(Builder& builder) {
  constexpr int kMostSide = 65536;  // of a LightFilm
  const Scene& scene = builder.scene;
  if (const Film& film = scene.film;
      !scene.lamps.empty() && std::max(film.width, film.height) > kMostSide)
    builder.in.problem(
        scene.lamps.front().where,
        fmt::format("the light of lamps is not kept on a film of {} x {}", film.width, film.height),
        fmt::format("let no side of film.size be above {}, or leave the lamps out", kMostSide));
  for (const Entity& entity : scene.entities)
    expect_body(builder, entity.scatterer, entity.shape, entity.where);
  for (const Chamber& chamber : scene.chambers) {
    expect_body(builder, chamber.scatterer, chamber.shape, chamber.where);
    if (!chamber.holes.empty() && chamber.scatterer != kNoEntry &&
        scene.scatterers[chamber.scatterer]->index(0) != 0)
      builder.in.problem(chamber.holes.front().where, "walls of glass have no holes",
                         "leave the holes out, or make the walls mirrors");
    for (const Chamber::Pillar& pillar : chamber.pillars)
      expect_body(builder, pillar.scatterer, pillar.shape, pillar.where);
    if (chamber.material == Material::periodic && !scene.lamps.empty())
      builder.in.warning(scene.lamps.front().where, "periodic walls let no light of lamps pass",
                         "light ends there: make the chamber a mirror, or leave its lamps out");
  }
  if (builder.in.problems.empty() && scene.light.estimator == LightEstimator::backward) {
    if (auto hindrance = why_not_backward(scene))
      builder.in.problems.push_back(std::move(*hindrance));
    else if (auto noisy = why_noisy_backward(scene))
      builder.in.warning(noisy->where, noisy->message, noisy->hint);
  }
  const auto most = std::ranges::max_element(
      scene.entities, {}, [](const Entity& entity) { return entity.alternatives.size(); });
  if (most != scene.entities.end() && !most->alternatives.empty() &&
      builder.corners > builder.limits.max_corners / (most->alternatives.size() + 1))
    builder.in.problem(
        most->where,
        fmt::format("the corners of all walls, once for each of these {} alternatives, "
                    "come to more than {}",
                    most->alternatives.size(), builder.limits.max_corners),
        "write fewer alternatives, or say --max-corners N");
  if (scene.lamps.empty() && scene.light.where.source != nullptr)
    builder.in.warning(scene.light.where, "no lamp shines", "add [[lamp]] source = { point = {} }");
}

void read_lamps(Builder& builder, const Field& field, Scene& scene) {
  constexpr std::uint32_t kLampTables = 3U << 30;  // apart from groups
  std::uint32_t tables = 0;
  each_table(builder, field, [&](const Value& table) {
    const char* dark = nullptr;
    const CopiedTable what{"lamp", kLampTables + tables++, scene.lamps.size()};
    expect_chain(builder, table, "lamp");
    make_copies<Lamp>(builder, table, what, kLampKeys,
                      [&](Lamp&& lamp, std::uint64_t, const std::string&) {
                        expect_one_colour(builder, lamp, table);
                        if (!take_states(builder, lamp, table.where)) return;
                        if (const char* reason = reason_dark(scene, lamp)) dark = reason;
                        scene.lamps.push_back(std::move(lamp));
                      });
    if (dark != nullptr)
      builder.in.warning(table.where, fmt::format("the lamp is dark: {}", dark),
                         "leave the lamp out, or let it shine");
  });
}

void read_light(Builder& builder, const Field& field, Scene& scene) {
  scene.light.where = field.value.where;
  read_keys(builder, field.value, "light", kLightKeys, scene.light);
}

std::vector<TableInfo> lamp_tables() {
  return {{"lamp", key_infos<Lamp>(kLampKeys), true},
          {"lamp.states", key_infos<Lamp>(kLampLookKeys), true},
          {"light", key_infos<LightSettings>(kLightKeys)}};
}

}  // namespace flatray
