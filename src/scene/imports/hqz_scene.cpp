#include "scene/imports/hqz_scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "scene/reading/numbers.h"

namespace flatray {
namespace {

constexpr double kFarthestHqz = 1e12;  // products of two stay exact enough to be decided on
constexpr double kMostDegrees =
    360'000;  // of a normal, and of its turn: mirror_turn of mix holds both
// The keys of every scene, and what each may be.
constexpr std::pair<std::string_view, const char*> kNeeded[] = {
    {"resolution", "[1920, 1080]"},
    {"viewport", "[0, 0, 1920, 1080]"},
    {"lights", "[[1, 960, 540, 0, 0, [0, 360], 0]]"},
    {"objects", "[]"},
    {"materials", "[]"}};

std::string example_hint(std::string_view key) {
  const auto* found = std::ranges::find(kNeeded, key, [](const auto& one) { return one.first; });
  return fmt::format("write \"{}\": {}", key, found->second);
}

std::string_view kind_of(const Value& value) {
  return value.text == "null" ? "null" : kind_name(value.kind);
}

constexpr const char* kRangeHint = "write a number, or [low, high] for one drawn at random";

class HqzReader {
 public:
  HqzReader(const Value& scene, const LoadLimits& limits, Diagnostics& warnings)
      : root_(scene), limits_(limits), warnings_(warnings) {}

  Result<HqzScene> read() {
    HqzScene scene{.where = root_.where};
    if (root_.kind != Value::Kind::table)
      return fail(root_.where, "the scene is no object", R"(it begins with { "resolution": )");
    check_keys();
    read_view(scene);
    read_light_settings(scene);
    each("materials", [&](const Value& value) { read_material(value, scene); });
    each("lights", [&](const Value& value) { read_light(value, scene); });
    each("objects", [&](const Value& value) { read_object(value, scene); });
    if (problems_.empty() && scene.lights.empty())
      problem(root_.where, "no light shines", R"(write "lights": [[1, x, y, 0, 0, [0, 360], 0]])");
    const auto place = [](const Diagnostic& problem) { return problem.where.offset; };
    std::ranges::stable_sort(problems_, {}, place);
    if (!problems_.empty()) return tl::unexpected(std::move(problems_));
    return scene;
  }

 private:
  void problem(const Place& where, std::string message, std::string hint = {}) {
    problems_.push_back({where, std::move(message), std::move(hint)});
  }
  std::nullopt_t refuse(const Place& where, std::string message, std::string hint = {}) {
    problem(where, std::move(message), std::move(hint));
    return std::nullopt;
  }
  void warning(const Place& where, std::string message, std::string hint = {}) {
    warnings_.push_back({where, std::move(message), std::move(hint)});
  }

  void check_keys() {
    static const std::vector<std::string> kKnown = {"resolution", "viewport", "lights", "objects",
                                                    "materials",  "exposure", "rays",   "timelimit",
                                                    "seed",       "gamma",    "debug"};
    for (const Member& member : root_.members) {
      if (std::ranges::find(kKnown, member.key) != kKnown.end()) continue;
      const std::string near = nearest_word(member.key, kKnown);
      warning(member.where, fmt::format("unknown key '{}' is not used", member.key.substr(0, 40)),
              near.empty() ? "" : fmt::format("did you mean '{}'?", near));
    }
    for (const auto& [needed, example] : kNeeded)
      if (root_.find(needed) == nullptr)
        problem(root_.where, fmt::format("the scene needs \"{}\"", needed),
                fmt::format("add \"{}\": {}", needed, example));
    if (const Member* limit = root_.find("timelimit"))
      warning(limit->where, "timelimit is not honoured: every picture has all its rays",
              "leave it out, or lower rays");
    if (const Member* debug = root_.find("debug"))
      warning(debug->where, "debug is not honoured", "leave it out");
  }

  // The entries of a list.
  template <class Read>
  void each(const char* key, const Read& read) {
    const Member* member = root_.find(key);
    if (member == nullptr) return;
    if (member->value.kind != Value::Kind::array)
      return problem(member->value.where,
                     fmt::format("{} is {}, not an array", key, kind_of(member->value)),
                     example_hint(key));
    if (member->value.items.size() > limits_.max_entities)
      return problem(member->value.where, fmt::format("more than {} {}", limits_.max_entities, key),
                     "--max-entities raises the limit");
    for (const Value& item : member->value.items) read(item);
  }

  std::optional<double> number(const Value& value, const char* what, double low, double high) {
    if (value.kind != Value::Kind::number)
      return refuse(value.where, fmt::format("{} is {}, not a number", what, kind_of(value)),
                    "write a number");
    auto literal = parse_literal(source_text(value));
    if (value.text == "null") literal.emplace().value = 0;
    if (!literal || !(std::abs(literal->value) <= kFarthest))
      return refuse(value.where, fmt::format("{} is beyond 1e300", what),
                    "write a number between -1e300 and 1e300");
    if (literal->value >= low && literal->value <= high) return literal->value;
    return refuse(value.where, fmt::format("{} does not lie between {} and {}", what, low, high),
                  fmt::format("write a number from {} to {}", low, high));
  }

  std::optional<HqzRange> range(const Value& value, const char* what, double low = -kFarthestHqz,
                                double high = kFarthestHqz) {
    if (value.kind != Value::Kind::array) {
      const auto one = number(value, what, low, high);
      return one ? std::optional(HqzRange{*one, *one, value.where}) : std::nullopt;
    }
    if (value.items.size() != 2 || value.items[1].kind != Value::Kind::number)
      return refuse(value.where, fmt::format("{} is no number and no range", what), kRangeHint);
    const auto first = number(value.items[0], what, low, high);
    const auto second = number(value.items[1], what, low, high);
    return first && second ? std::optional(HqzRange{*first, *second, value.where}) : std::nullopt;
  }

  // One of the numbers of an array, whose length is checked.
  std::optional<double> fixed(const Value& value, const char* what) {
    const auto read = range(value, what);
    if (!read) return std::nullopt;
    if (!read->is_number())
      warning(value.where, fmt::format("{} is not drawn for every ray: its middle is taken", what));
    return read->middle();
  }

  const Value* list(const char* key, std::size_t count) {
    const Member* member = root_.find(key);
    if (member == nullptr) return nullptr;
    const Value& value = member->value;
    if (value.kind == Value::Kind::array && value.items.size() == count) return &value;
    problem(value.where, fmt::format("{} is no list of {} numbers", key, count), example_hint(key));
    return nullptr;
  }

  void read_view(HqzScene& scene) {
    if (const Value* size = list("resolution", 2)) {
      scene.size = *size;
      for (std::size_t i = 0; i < 2; ++i)
        scene.resolution[i] = number(size->items[i], "resolution", 1, 2147483647).value_or(1);
    }
    const Value* view = list("viewport", 4);
    if (view == nullptr) return;
    scene.left = fixed(view->items[0], "left").value_or(0);
    scene.top = fixed(view->items[1], "top").value_or(0);
    scene.width = fixed(view->items[2], "width").value_or(1);
    scene.height = fixed(view->items[3], "height").value_or(1);
    constexpr double kLeastView = 0x1p-30;
    if (!(scene.width >= kLeastView && scene.height >= kLeastView))
      return problem(view->where, "viewport has no area",
                     "write [left, top, width, height], at least 2^-30 wide and high");
    const double aspect = scene.width / scene.height * scene.resolution[1] / scene.resolution[0];
    constexpr double kAlike = 1e-3;
    if (problems_.empty() && !(std::abs(aspect - 1) <= kAlike))
      warning(view->where,
              "viewport is not of the shape of the picture: more is shown than it says",
              "pixels are square; write one of the resolution's aspect");
  }

  std::optional<double> setting(const char* key, double low, double high) {
    const Member* member = root_.find(key);
    return member == nullptr ? std::nullopt : number(member->value, key, low, high);
  }

  std::optional<Value> whole(const char* key, std::int64_t low, double high) {
    const Member* member = root_.find(key);
    if (member == nullptr) return std::nullopt;
    const auto given = number(member->value, key, static_cast<double>(low), high);
    if (!given) return std::nullopt;
    if (*given != std::floor(*given))
      return refuse(member->value.where, fmt::format("{} is no whole number", key));
    Value value = built_in_number(*given);
    if (member->value.text != "null") value = member->value;
    return value;
  }

  void read_light_settings(HqzScene& scene) {
    constexpr double kMostExposure = 6;  // exp(61)
    scene.exposure = setting("exposure", -kMostExposure, kMostExposure).value_or(0);
    if (root_.find("exposure") == nullptr)
      warning(root_.where, "no exposure is given: it is 0", R"(write "exposure": 0.6)");
    const Member* gamma = root_.find("gamma");
    scene.gamma = setting("gamma", -kFarthestHqz, kFarthestHqz).value_or(0);
    if (gamma != nullptr && gamma->value.text != "null" && !(scene.gamma > 0))
      warning(gamma->value.where, "a gamma of 0 and less counts as 1", "write 2.2");
    if (!(scene.gamma > 0)) scene.gamma = 1;
    if (!(scene.gamma >= 0.1 && scene.gamma <= 10) && gamma != nullptr)
      problem(gamma->value.where, "gamma does not lie between 0.1 and 10", "write 2.2");
    if (const Member* rays = root_.find("rays"); rays != nullptr && rays->value.text != "null")
      scene.rays = whole("rays", 1, 0x1p40);
    if (!scene.rays && problems_.empty())
      warning(root_.where, "no number of rays is given: 1000000 are traced",
              R"(write "rays": 1000000)");
    scene.seed = whole("seed", -2147483648, 4294967295);
    if (scene.seed && source_text(*scene.seed).starts_with('-')) {
      warning(scene.seed->where, "a seed below 0 counts as 0", "write 0 or more");
      scene.seed.reset();
    }
  }

  void read_material(const Value& value, HqzScene& scene) {
    HqzMaterial& material = scene.materials.emplace_back();
    if (value.kind != Value::Kind::array)
      return problem(value.where, "a material is no list of outcomes", R"(write [[0.5, "d"]])");
    double sum = 0;
    for (const Value& outcome : value.items) read_outcome(outcome, material, sum);
    if (constexpr double kRounding = 0x1p-50; sum > 1 + kRounding)
      warning(value.where, "the outcomes are more than 1 together: those behind 1 never come");
  }

  // Outcomes take their shares of [0, 1] in turn.
  void read_outcome(const Value& outcome, HqzMaterial& material, double& sum) {
    if (outcome.kind != Value::Kind::array || outcome.items.size() != 2)
      return problem(outcome.where, "an outcome is a probability and what comes",
                     R"(write [0.5, "d"])");
    const auto part = number(outcome.items[0], "a probability", 0, kFarthestHqz);
    if (!part) return;
    const double before = std::min(sum, 1.0);
    sum += *part;
    const double share = std::min(sum, 1.0) - before;
    const std::string& what = outcome.items[1].text;
    const bool is_text = outcome.items[1].kind == Value::Kind::string;
    if (is_text && what == "d")
      material.scattered += share;
    else if (is_text && what == "t")
      material.through += share;
    else if (is_text && what == "r")
      material.mirrored += share;
    else
      warning(outcome.items[1].where, "unknown outcome: light is absorbed there",
              R"("d" is scattered, "t" let through, "r" mirrored)");
  }

  struct Numbered {
    std::size_t index;
    const char* name;
    HqzRange* range;
    double most = kFarthestHqz;
  };
  bool numbers(const Value& value, std::initializer_list<Numbered> parts) {
    bool right = true;
    for (const auto& [index, name, range_of, most] : parts) {
      const auto read = range(value.items[index], name, -most, most);
      right = right && read.has_value();
      if (read) *range_of = *read;
    }
    return right;
  }
  void read_light(const Value& value, HqzScene& scene) {
    constexpr std::size_t kFields = 7;
    if (value.kind != Value::Kind::array || value.items.size() != kFields)
      return problem(value.where, "a light is no list of 7 numbers",
                     "write [power, x, y, polar angle, polar distance, ray angle, wavelength]");
    HqzLight light{.where = value.where};
    const auto power = range(value.items[0], "power", 0, kFarthestHqz);
    if (power) light.power = *power;
    const bool right = numbers(value, {{1, "x", &light.x},
                                       {2, "y", &light.y},
                                       {3, "polar angle", &light.polar_angle},
                                       {4, "polar distance", &light.polar_distance},
                                       {5, "ray angle", &light.ray_angle}});
    if (!read_wavelength(value.items[6], light) || !right || !power) return;
    if (!power->is_number())
      warning(power->where, "power is not drawn for every ray: its middle is taken");
    scene.lights.push_back(light);
  }

  bool read_wavelength(const Value& value, HqzLight& light) {
    const std::vector<Value>& items = value.items;
    if (items.size() == 2 && items[1].kind == Value::Kind::string && items[1].text == "K") {
      constexpr double kLeastKelvin = 800, kMostKelvin = 100'000;
      light.colour = HqzLight::Colour::kelvin;
      const auto kelvin = number(items[0], "a temperature in kelvin", kLeastKelvin, kMostKelvin);
      if (kelvin) light.wavelength = {*kelvin, *kelvin, value.where};
      return kelvin.has_value();
    }
    const auto nm = range(value, "wavelength", 0);
    if (!nm) return false;
    light.wavelength = *nm;
    if (!(nm->is_number() && nm->low == 0)) light.colour = HqzLight::Colour::nm;
    return true;
  }

  void read_object(const Value& value, HqzScene& scene) {
    const std::size_t count = value.items.size();
    if (value.kind != Value::Kind::array || (count != 5 && count != 7))
      return problem(value.where, "an object is no list of 5 or 7 numbers",
                     "write [material, x, y, dx, dy] or [material, x, y, angle, dx, dy, turn]");
    HqzObject object{.where = value.where};
    HqzObject::Normal normal;
    const bool right = count == 5 ? numbers(value, {{1, "x", &object.x},
                                                    {2, "y", &object.y},
                                                    {3, "dx", &object.dx},
                                                    {4, "dy", &object.dy}})
                                  : numbers(value, {{1, "x", &object.x},
                                                    {2, "y", &object.y},
                                                    {3, "angle", &normal.angle, kMostDegrees},
                                                    {4, "dx", &object.dx},
                                                    {5, "dy", &object.dy},
                                                    {6, "turn", &normal.turn, kMostDegrees}});
    const auto material = number(value.items[0], "material", 0, kFarthestHqz);
    if (!material || !right) return;
    const double most = static_cast<double>(scene.materials.size());
    if (*material != std::floor(*material) || !(*material < most))
      return problem(value.items[0].where, "there is no such material",
                     scene.materials.empty()
                         ? R"(write one into "materials")"
                         : fmt::format("they are 0 to {}", scene.materials.size() - 1));
    object.material = static_cast<std::size_t>(*material);
    if (count == 7) object.normal = normal;
    const auto is_zero = [](const HqzRange& range) { return range.low == 0 && range.high == 0; };
    if (is_zero(object.dx) && is_zero(object.dy))
      return warning(value.where, "an object without length is left out");
    scene.objects.push_back(object);
  }

  const Value& root_;
  const LoadLimits& limits_;
  Diagnostics& warnings_;
  Diagnostics problems_;
};

}  // namespace

Result<HqzScene> read_hqz_scene(const Value& scene, const LoadLimits& limits,
                                Diagnostics& warnings) {
  return HqzReader(scene, limits, warnings).read();
}

}  // namespace flatray
