#include <fmt/core.h>

#include <memory>

#include "anim/rays.h"
#include "app/answers/orbit_report.h"
#include "app/files/scene_input.h"
#include "app/options/option_values.h"
#include "app/options/resource_limits.h"
#include "app/options/tracer_choice.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "base/number_text.h"
#include "collide/scene_timeline.h"
#include "scene/moving_mirrors.h"
#include "scene/responses.h"

namespace flatray::verbs {
namespace {

constexpr auto kOptions = with_scene_options(
    {{"ray", 'r', "RAY", "only this ray of the scene, or this fan"},
     {"bounces", 'n', "N", "most bounces, instead of the ray's own"},
     {"precision", '\0', "double|certified",
      "certified proves every bounce, in as many bits as it takes"},
     kBitsOption,
     kTracerOption,
     {"speed", '\0', "V|none",
      "world units a second: mirrors are met where they are by then; none: as the frame has them"},
     {"corner", '\0', "stop|back", "what a ray does in a corner: stop, or return the way it came"},
     kFrameOption,
     kSeedOption,
     {"svg", '\0', "", "print a diagram in world coordinates", OptionKind::flag},
     kJsonOption,
     kCsvOption});

// As they set off at the time of the frame, not displaced.
Result<std::vector<RayState>> chosen_rays(const Arguments& arguments, const Scene& scene,
                                          const FrameState& frame) {
  const std::optional<std::string> wanted = arguments.text("ray");
  std::vector<std::string> known;
  bool any = false;
  const auto chosen = [&](const RayPath& ray) {
    return !wanted || *wanted == ray.name || *wanted == ray.written_name;
  };
  for (const RayPath& ray : scene.rays) {
    any |= chosen(ray);
    known.push_back(ray.name);
  }
  std::vector<RayState> rays = ray_states(scene, frame.time);
  std::erase_if(rays, [&](const RayState& ray) { return !chosen(scene.rays[ray.ray]); });
  if (!rays.empty()) return rays;
  if (any)
    return fail(named_place(arguments.operands().front()),
                fmt::format("no ray has a direction in frame {}", frame.frame),
                "ask for a frame in which its curve is not 0");
  if (!wanted)
    return fail(named_place(arguments.operands().front()), "has no ray to follow",
                "add [[ray]] with at, direction and bounces");
  return unknown_name(arguments.where("ray"), "ray of the scene", *wanted, known);
}

Result<OrbitRequest> read_request(const Arguments& arguments) {
  const auto precision = chosen_precision(arguments);
  if (!precision) return tl::unexpected(precision.error());
  const auto corner = arguments.one_of("corner", {"stop", "back"});
  if (!corner) return tl::unexpected(corner.error());
  const OrbitRequest request{
      precision->certified,
      precision->most_bits,
      {*corner == "back" ? CornerRule::back : CornerRule::stop, precision->tracer}};
  if (request.certified && request.rules.corners == CornerRule::back)
    return usage_error(arguments.where("corner"), "a certified orbit ends in a corner",
                       "leave --corner back out, or say --precision double");
  return request;
}

constexpr std::uint64_t kMostBounces = 10'000'000;

// What --speed says of all rays.
struct SpeedAsked {
  bool frozen = false;
  std::optional<double> speed;

  std::optional<double> of(const RayPath& ray) const {
    if (frozen) return std::nullopt;
    return speed ? speed : ray.speed;
  }
};

Result<SpeedAsked> read_speed(const Arguments& arguments) {
  const std::optional<std::string> text = arguments.text("speed");
  if (!text) return SpeedAsked{};
  if (*text == "none") return SpeedAsked{true, std::nullopt};
  const auto speed = parse_number(*text);
  if (!speed || !(*speed > 0) || !(*speed < kFarthest))
    return usage_error(
        arguments.where("speed"), "'" + *text + "' is not a speed",
        fmt::format("write world units a second, above 0 and below {}, or none", kFarthest));
  return SpeedAsked{false, *speed};
}

// What only mirrors at rest have.
Result<void> check_frozen(const Arguments& arguments, const std::string& ray) {
  for (const char* option : {"precision", "tracer", "corner"})
    if (arguments.has(option) && *arguments.text(option) != "double" &&
        *arguments.text(option) != "stop")
      return usage_error(arguments.where(option),
                         "is not for rays of finite speed, as '" + ray + "' is",
                         "leave it out, or say --speed none");
  return {};
}

// Rays of finite speed set off at the time of the frame; where contact changes how mirrors move,
// these are known up to the last frame.
class MovingRoom {
 public:
  static Result<MovingRoom> make(const Arguments& arguments, const Scene& scene,
                                 const FrameState& frame) {
    if (Diagnostics refused = refused_mirrors(scene); !refused.empty())
      return tl::unexpected(std::move(refused));
    const auto seeded = seed(arguments, scene);
    if (!seeded) return tl::unexpected(seeded.error());
    const unsigned last = std::max(scene.frames, frame.frame);
    const auto timeline = make_timeline(scene, *seeded, last);
    if (!timeline) return tl::unexpected(timeline.error());
    return MovingRoom(moving_walls(*timeline), frame.time,
                      responds(scene) ? (last - 1) / scene.fps : kInfinity);
  }

  OrbitReport follow(const OrbitRoom& room, const RayState& ray, double speed,
                     std::uint64_t bounces) const {
    const auto& [at, direction] = ray.start;
    return follow_moving(room, walls_, room.scene.rays[ray.ray].name,
                         {at, at_speed(direction, speed)}, from_, {bounces, until_});
  }

 private:
  MovingRoom(MovingWalls walls, double from, double until)
      : walls_(std::move(walls)), from_(from), until_(until) {}

  MovingWalls walls_;
  double from_, until_;
};

Result<OrbitReport> follow_ray(const Arguments& arguments, const OrbitRoom& room,
                               const FrameState& frame, const RayState& state,
                               const OrbitRequest& request, const SpeedAsked& speeds,
                               std::optional<MovingRoom>& moving) {
  const RayPath& ray = room.scene.rays[state.ray];
  const auto bounces = arguments.whole("bounces", ray.bounces, 0, kMostBounces);
  if (!bounces) return tl::unexpected(bounces.error());
  const double bytes = static_cast<double>(*bounces) * sizeof(Bounce);
  if (auto fits = expect_memory(arguments, bytes, fmt::format("an orbit of {} bounces", *bounces),
                                "say fewer --bounces");
      !fits)
    return fail(std::move(fits));
  const std::optional<double> speed = speeds.of(ray);
  if (!speed)
    return follow_orbit(room, ray.name,
                        {world_pose(frame)(state.start.origin), state.start.direction}, *bounces,
                        request);
  if (auto checked = check_frozen(arguments, ray.name); !checked) return fail(std::move(checked));
  if (!moving) {
    auto made = MovingRoom::make(arguments, room.scene, frame);
    if (!made) return fail(std::move(made));
    moving = std::move(*made);
  }
  return moving->follow(room, state, *speed, *bounces);
}

// What reports are written of: they name walls of the room, or of walls that move.
struct Followed {
  Scene scene;
  FrameState frame;
  OrbitRoom room{scene, frame};
  std::optional<MovingRoom> moving{};
  std::vector<OrbitReport> reports{};

  Followed(Scene of, FrameState at) : scene(std::move(of)), frame(std::move(at)) {}
};

Result<void> follow(const Arguments& arguments, Followed& all) {
  const auto request = read_request(arguments);
  if (!request) return tl::unexpected(request.error());
  const auto speeds = read_speed(arguments);
  if (!speeds) return tl::unexpected(speeds.error());
  const auto rays = chosen_rays(arguments, all.scene, all.frame);
  if (!rays) return tl::unexpected(rays.error());
  for (const RayState& ray : *rays) {
    auto report = follow_ray(arguments, all.room, all.frame, ray, *request, *speeds, all.moving);
    if (!report) return fail(std::move(report));
    if (report->starts_badly)
      report_note(all.scene.rays[ray.ray].name + " starts " + report->start);
    all.reports.push_back(std::move(*report));
  }
  return {};
}

Result<VerbOutput> run(const Arguments& arguments) {
  auto scene = load_only_input(arguments);
  if (!scene) return fail(std::move(scene));
  auto frame = frame_of(arguments, *scene);
  if (!frame) return fail(std::move(frame));
  const auto all = std::make_shared<Followed>(*std::move(scene), *std::move(frame));
  if (auto done = follow(arguments, *all); !done) return fail(std::move(done));
  if (arguments.has("svg")) return VerbOutput{{svg_of(all->room, all->reports)}};
  VerbOutput output{.table = bounce_table(all->room, all->reports), .kept = all};
  Values values;
  for (const OrbitReport& report : all->reports) {
    values.push_back(as_value(all->room, report));
    output.text.emplace_back(bounce_table(all->room, {&report, 1}));
    output.text.emplace_back(status_line(all->room, report));
  }
  output.results = std::move(values);
  return output;
}

}  // namespace

extern const Verb orbit = {
    "orbit",
    "SCENE",
    "follow the rays of a scene from mirror to mirror",
    1,
    1,
    kOptions,
    "  flatray orbit scenes/chamber/hall.toml\n"
    "  flatray orbit scenes/chamber/hall.toml --ray probe -n 100 --csv\n"
    "  flatray orbit scenes/chamber/sinai.toml -n 200 --precision certified\n"
    "  flatray orbit scenes/chamber/fermi.toml --csv\n"
    "  flatray orbit scenes/chamber/three_discs.toml --svg > orbit.svg\n",
    "nothing traced",
    &run};

}  // namespace flatray::verbs
