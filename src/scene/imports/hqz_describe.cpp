#include <fmt/core.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "base/philox.h"
#include "base/portable_math.h"
#include "scene/imports/hqz_scene.h"
#include "scene/reading/made_values.h"
#include "scene/spectrum.h"

namespace flatray {
namespace {

constexpr double kMostPower = 1e30;  // of a lamp
constexpr double kFps = 24;          // lines have no times
constexpr double kDegrees = 180 / std::numbers::pi;

Value pair(Value first, Value second) {
  const Place where = first.where;
  return array_value(where, {std::move(first), std::move(second)});
}
Value word(const char* text) { return string_value({}, text); }
Value kind(const char* name, Value arguments) {
  const Place where = arguments.where;
  return table_of(where, member(name, std::move(arguments)));
}

// What a number is from each frame on in which it changes: as long as what the lines say of it.
struct Track {
  struct Step {
    std::size_t frame;
    double value;
  };
  std::vector<Step> steps{};
  std::size_t end = 0;  // frames that have been told

  // From `frame` on. What has not been told before stays what it was; of a new track it is the same.
  void set(std::size_t frame, double value) {
    add(steps.empty() ? 0 : frame, value), end = frame + 1;
  }
  // What has not been told before is 0.
  void show(std::size_t frame, double value) {
    finish(frame);
    set(frame, value);
  }
  void finish(std::size_t frames) {
    if (end < frames) add(end, 0), end = frames;
  }

 private:
  void add(std::size_t frame, double value) {
    if (steps.empty() || steps.back().value != value) steps.push_back({frame, value});
  }
};

// A number, or a curve that stays from frame to frame.
Value written(const Track& track) {
  if (track.steps.size() == 1) return built_in_number(track.steps[0].value);
  std::vector<double> numbers;
  for (const auto& [frame, value] : track.steps)
    numbers.insert(numbers.end(), {static_cast<double>(frame) / kFps, value});
  std::vector<Value> values = built_in_numbers(numbers), keys;
  keys.reserve(track.steps.size());
  for (std::size_t i = 0; i < values.size(); i += 2)
    keys.push_back(pair(std::move(values[i]), std::move(values[i + 1])));
  return table_of({}, member("keys", array_value({}, std::move(keys))),
                  member("ease", word("step")));
}

// Walls of one kind, one of which a frame may lack: it is then a point, which no light meets.
struct WallKind {
  HqzMaterial material;
  double turn_from = 0, turn_to = 0;  // degrees, of its mirror
  auto operator<=>(const WallKind&) const = default;
};
struct WallTrack {
  Place where;
  Track x0{}, y0{}, x1{}, y1{};
  std::vector<std::array<Vec2, 2>> alternatives{};
};

struct LampTrack {
  Place where;
  Track power{}, tint{};
  std::array<Track, 10> ranges{};  // of kRanges, both ends
};

// y is up here and down there, so angles turn the other way.
struct NamedRange {
  const char* name;
  HqzRange HqzLight::*range;
  double sign;
};
constexpr NamedRange kRanges[] = {{"ray_angle", &HqzLight::ray_angle, -1},
                                  {"polar_angle", &HqzLight::polar_angle, -1},
                                  {"polar_distance", &HqzLight::polar_distance, 1},
                                  {"x", &HqzLight::x, 1},
                                  {"y", &HqzLight::y, -1}};

// Makes one description of the scenes of all frames.
class HqzWriter {
 public:
  HqzWriter(std::vector<HqzScene> scenes, Diagnostics& warnings)
      : scenes_(std::move(scenes)), frames_(scenes_.size()), warnings_(warnings) {}

  Result<SceneDesc> write() {
    const HqzScene& first = scenes_.front();
    const double exposure = exposure_of(first);
    if (!(exposure > 0 && exposure <= 1e30))
      return fail(first.where, "exposure and viewport leave no picture",
                  "write an exposure from 0 to 1");
    for (frame_ = 0; frame_ < frames_; ++frame_) {
      HqzScene& scene = scenes_[frame_];
      check_alike(scene);
      const double brighter = exposure_of(scene) / exposure;
      for (const HqzLight& light : scene.lights) add_light(light, brighter);
      std::vector<HqzLight>().swap(scene.lights);
      scene.objects = without_overlaps(std::move(scene.objects), warnings_);
      for (const HqzObject& object : scene.objects) add_wall(object, scene);
      lamps_used_.clear(), walls_used_.clear();
      std::vector<HqzObject>().swap(scene.objects);
    }
    if (!problems_.empty()) return tl::unexpected(std::move(problems_));
    std::vector<Member> root;
    root.push_back({"flatray", first.where, built_in_number(1)});
    root.push_back({"frames", first.where, built_in_number(static_cast<double>(frames_))});
    root.push_back({"fps", first.where, built_in_number(kFps)});
    if (first.seed) root.push_back(member("seed", *first.seed));
    root.push_back(member("film", film(first)));
    if (frames_ > 1) root.push_back(member("camera", camera()));
    root.push_back(member("light", light(first, exposure)));
    root.push_back(member("lamp", array_value(first.where, lamps())));
    root.push_back(member("entity", array_value(first.where, walls())));
    SceneDesc desc{table_value(first.where, std::move(root))};
    desc.ends = frames_ > 1;
    return desc;
  }

 private:
  // A pixel of a picture of 1024 x 576 shows 128 / 255 exp(1 + 10 exposure) of a ray of power 1 that
  // is a pixel long there, and one of a larger picture as much more as its side is longer.
  static double exposure_of(const HqzScene& scene) {
    constexpr double kPixels = 1024.0 * 576.0;
    const double scale = std::sqrt(scene.resolution[0] * scene.resolution[1] / kPixels);
    const double pixels_per_unit =
        std::min(scene.resolution[0] / scene.width, scene.resolution[1] / scene.height);
    return 128.0 / 255 * portable::exp(1 + 10 * scene.exposure) * scale / pixels_per_unit;
  }

  void check_alike(const HqzScene& scene) {
    const HqzScene& first = scenes_.front();
    const auto differs = [&](bool it_does, const char* what) {
      if (it_does)
        warnings_.push_back({scene.where, fmt::format("{} is that of the first line", what), {}});
    };
    differs(scene.resolution != first.resolution, "resolution");
    differs(scene.gamma != first.gamma, "gamma");
    const auto text = [](const std::optional<Value>& value) {
      return value ? source_text(*value) : std::string_view();
    };
    differs(text(scene.rays) != text(first.rays), "rays");
    noise_moves_ |= text(scene.seed) != text(first.seed);
  }

  void add_light(const HqzLight& light, double brighter) {
    const double power = light.power.middle() * brighter;
    if (light.colour == HqzLight::Colour::white) return add_lamp(light, power, 0);
    if (light.colour == HqzLight::Colour::kelvin) {
      const double kelvin = light.wavelength.low;
      return add_lamp(
          light,
          power * luminance_of_temperature(kelvin) / luminance(colour_of_temperature(kelvin)),
          kelvin);
    }
    constexpr int kParts = 16;  // of a range of wavelengths
    const int parts = light.wavelength.is_number() ? 1 : kParts;
    for (int i = 0; i < parts; ++i) add_wavelength(light, power / parts, (i + 0.5) / parts);
  }

  void add_wavelength(const HqzLight& light, double power, double part) {
    constexpr double kLeastSeen = 380, kMostSeen = 780;
    const HqzRange& range = light.wavelength;
    const double nm = range.low + part * (range.high - range.low);
    if (nm >= kLeastSeen && nm <= kMostSeen)
      return add_lamp(
          light, power * luminance_of_wavelength(nm) / luminance(colour_of_wavelength(nm)), nm);
    warnings_.push_back({range.where, fmt::format("light of {} nm is not seen", nm), {}});
  }

  // Number `k` of the tracks of a kind, which is new where there is none.
  template <class Of>
  Of& track(std::vector<Of>& of_kind, std::size_t k, const Place& where) {
    if (k == of_kind.size()) of_kind.push_back({.where = where});
    return of_kind[k];
  }

  void add_lamp(const HqzLight& light, double power, double tint) {
    if (!(power <= kMostPower))
      problems_.push_back(
          {light.power.where,
           fmt::format("power comes to {:.3g} with the exposure of its line, beyond {}", power,
                       kMostPower),
           "write less power, or exposures that differ less"});
    LampTrack& lamp = track(lamps_[light.colour], lamps_used_[light.colour]++, light.where);
    lamp.power.show(frame_, power);
    lamp.tint.set(frame_, tint);
    for (std::size_t i = 0; i < std::size(kRanges); ++i) {
      const HqzRange& range = light.*kRanges[i].range;
      lamp.ranges[2 * i].set(frame_, 0 + kRanges[i].sign * range.low);
      lamp.ranges[2 * i + 1].set(frame_, 0 + kRanges[i].sign * range.high);
    }
  }

  static constexpr std::uint32_t kAlternatives = 64;  // of a wall that is drawn for every ray

  // Number `k` of so many walls, each range cut into as many parts, whose order is drawn for each.
  static std::array<Vec2, 2> drawn(const HqzObject& object, std::uint64_t item, std::uint32_t k) {
    std::uint32_t stream = 0;
    const auto number = [&](const HqzRange& range) {
      ++stream;
      if (range.is_number()) return range.low;
      std::array<std::uint32_t, kAlternatives> order{};
      std::iota(order.begin(), order.end(), 0U);
      for (std::uint32_t i = kAlternatives; i-- > 1;)
        std::swap(order[i], order[random_bits(0, Stream::alternative, stream, item, i) % (i + 1)]);
      return range.low + (order[k] + 0.5) / kAlternatives * (range.high - range.low);
    };
    const double x = number(object.x), y = number(object.y);
    return {Vec2(x, y), Vec2(x + number(object.dx), y + number(object.dy))};
  }

  // The wall of an object, or the one in its middle, and what else it may be.
  void add_wall(const HqzObject& object, const HqzScene& scene) {
    const Vec2 at(object.x.middle(), object.y.middle());
    const Vec2 along(object.dx.middle(), object.dy.middle());
    std::array<Vec2, 2> ends{at, object.end.value_or(at + along)};
    std::vector<std::array<Vec2, 2>> alternatives;
    for (const HqzRange* range : {&object.x, &object.y, &object.dx, &object.dy})
      if (!range->is_number()) {
        if (frames_ > 1)
          warn_of_middle(*range, "a wall of an animation");
        else if (alternatives.empty())
          for (std::uint32_t k = 0; k < kAlternatives; ++k)
            alternatives.push_back(drawn(object, entity_count_, k));
      }
    ++entity_count_;
    std::erase_if(alternatives, [](const auto& wall) { return wall[0] == wall[1]; });
    if (!alternatives.empty()) {
      ends = alternatives.back();
      alternatives.pop_back();
    }
    WallKind kind{scene.materials[object.material]};
    if (object.normal) {
      // Out of the left normal of the wall as it stands here.
      const double left = kDegrees * portable::atan2(-along.y(), along.x()) + 90;
      kind.turn_from = -object.normal->angle.middle() - left;
      kind.turn_to = kind.turn_from - object.normal->turn.middle();
      for (const HqzRange* range : {&object.normal->angle, &object.normal->turn})
        if (!range->is_number()) warn_of_middle(*range, "a normal");
      if (!alternatives.empty())
        warnings_.push_back({object.where, "the normals of this wall turn with it", {}});
    }
    WallTrack& wall = track(walls_[kind], walls_used_[kind]++, object.where);
    wall.x0.show(frame_, ends[0].x()), wall.y0.show(frame_, 0 - ends[0].y());
    wall.x1.show(frame_, ends[1].x()), wall.y1.show(frame_, 0 - ends[1].y());
    wall.alternatives = std::move(alternatives);
  }

  void warn_of_middle(const HqzRange& range, const char* what) {
    warnings_.push_back(
        {range.where,
         fmt::format("{} is not drawn at random for every ray: the middle is taken", what),
         {}});
  }

  // Tracks that end before the last frame are not there from then on.
  Value whole(Track& track) {
    track.finish(frames_);
    return written(track);
  }

  static Value film(const HqzScene& scene) {
    const auto corner = [](double x, double y) {
      return pair(built_in_number(x), built_in_number(y));
    };
    Value world = pair(corner(scene.left, -(scene.top + scene.height)),
                       corner(scene.left + scene.width, 0 - scene.top));
    return table_of(scene.where, member("size", scene.size), member("world", std::move(world)),
                    member("background", word("#000000")));
  }

  Value camera() const {
    Track x, y, height;
    for (const HqzScene& scene : scenes_) {
      const std::size_t frame = x.end;
      x.set(frame, scene.left + scene.width / 2);
      y.set(frame, -(scene.top + scene.height / 2));
      height.set(frame,
                 std::max(scene.height, scene.width / scene.resolution[0] * scene.resolution[1]));
    }
    return table_of({}, member("at", pair(written(x), written(y))),
                    member("height", written(height)));
  }

  Value light(const HqzScene& scene, double exposure) const {
    std::vector<Member> light;
    if (scene.rays) light.push_back(member("rays", *scene.rays));
    light.push_back(member("exposure", built_in_number(exposure)));
    light.push_back(member("tone", word("gamma")));
    light.push_back(member("gamma", built_in_number(scene.gamma)));
    if (noise_moves_) light.push_back(member("noise", word("moving")));
    return table_value(scene.where, std::move(light));
  }

  std::vector<Value> lamps() {
    std::vector<Value> all;
    for (auto& [colour, tracks] : lamps_)
      for (LampTrack& one : tracks) {
        std::vector<Member> ranges, lamp;
        for (std::size_t i = 0; i < std::size(kRanges); ++i) {
          Value low = written(one.ranges[2 * i]), high = written(one.ranges[2 * i + 1]);
          ranges.push_back(member(kRanges[i].name, pair(std::move(low), std::move(high))));
        }
        lamp.push_back(member("source", kind("ranges", table_value(one.where, std::move(ranges)))));
        lamp.push_back(member("power", whole(one.power)));
        if (colour == HqzLight::Colour::nm) lamp.push_back(member("nm", written(one.tint)));
        if (colour == HqzLight::Colour::kelvin) lamp.push_back(member("kelvin", written(one.tint)));
        all.push_back(table_value(one.where, std::move(lamp)));
      }
    return all;
  }

  static Value material(const WallKind& kind_of) {
    std::vector<Member> parts;
    const auto part = [&](const char* key, double share) {
      if (share != 0) parts.push_back(member(key, built_in_number(share)));
    };
    part("isotropic", kind_of.material.scattered);
    part("pass", kind_of.material.through);
    part("mirror", kind_of.material.mirrored);
    if (parts.empty()) return word("absorb");
    if (kind_of.turn_from != 0 || kind_of.turn_to != 0)
      parts.push_back(member("mirror_turn", pair(built_in_number(kind_of.turn_from),
                                                 built_in_number(kind_of.turn_to))));
    return kind("mix", table_value({}, std::move(parts)));
  }

  static Value segment(const Place& where, Value x0, Value y0, Value x1, Value y1) {
    return kind("segment", table_of(where, member("from", pair(std::move(x0), std::move(y0))),
                                    member("to", pair(std::move(x1), std::move(y1)))));
  }

  std::vector<Value> walls() {
    std::vector<Value> all;
    for (auto& [kind_of, tracks] : walls_)
      for (WallTrack& one : tracks) {
        std::vector<Member> wall;
        wall.push_back(member("shape", segment(one.where, whole(one.x0), whole(one.y0),
                                               whole(one.x1), whole(one.y1))));
        std::vector<Value> more;
        for (const auto& [from, to] : one.alternatives)
          more.push_back(segment(one.where, built_in_number(from.x()),
                                 built_in_number(0 - from.y()), built_in_number(to.x()),
                                 built_in_number(0 - to.y())));
        if (!more.empty())
          wall.push_back(member("alternatives", array_value(one.where, std::move(more))));
        wall.push_back(member("material", material(kind_of)));
        wall.push_back(member("stroke", word("none")));
        all.push_back(table_value(one.where, std::move(wall)));
      }
    return all;
  }

  std::vector<HqzScene> scenes_;
  const std::size_t frames_;
  Diagnostics& warnings_;
  Diagnostics problems_;
  std::size_t frame_ = 0;
  bool noise_moves_ = false;
  std::uint64_t entity_count_ = 0;
  std::map<HqzLight::Colour, std::vector<LampTrack>> lamps_;
  std::map<HqzLight::Colour, std::size_t> lamps_used_;  // in the frame
  std::map<WallKind, std::vector<WallTrack>> walls_;
  std::map<WallKind, std::size_t> walls_used_;
};

}  // namespace

Result<SceneDesc> describe_hqz(std::vector<HqzScene> scenes, Diagnostics& warnings) {
  return HqzWriter(std::move(scenes), warnings).write();
}

}  // namespace flatray
