#include <fmt/core.h>

#include <memory>

#include "anim/rays.h"
#include "app/answers/orbit_report.h"
#include "app/files/scene_input.h"
#include "app/options/resource_limits.h"
#include "app/options/tracer_choice.h"
#include "app/verb.h"
#include "base/number_text.h"
#include "collide/scene_timeline.h"
#include "scene/moving_mirrors.h"
#include "scene/names.h"
#include "scene/responses.h"

namespace flatray::orbit_verb {
namespace {

// What --speed says of all rays.
struct SpeedAsked {
  bool frozen = false;
  std::optional<double> speed;

  std::optional<double> of(const RayPath& ray) const {
    if (frozen) return std::nullopt;
    return speed ? speed : ray.speed;
  }
};

Result<SpeedAsked> parse_speed(const std::string& text, const Place& where) {
  if (text == "none") return SpeedAsked{true, std::nullopt};
  const auto speed = parse_number(text);
  if (speed && *speed > 0 && *speed < kFarthest) return SpeedAsked{false, *speed};
  return usage_error(
      where, "'" + text + "' is not a speed",
      fmt::format("write world units a second, above 0 and below {}, or none", kFarthest));
}

constexpr Word<CornerRule> kCorners[] = {{"stop", CornerRule::stop}, {"back", CornerRule::back}};

struct Options : Arguments {
  SceneOptions scene;
  std::optional<std::string> ray;
  std::optional<std::uint64_t> bounces;
  Precision precision;
  SpeedAsked speeds;
  CornerRule corner = CornerRule::stop;
  unsigned frame = 1;

  OrbitRequest request(const Scene& of, std::uint32_t number) const {
    return {precision.certified,
            precision.most_bits,
            {corner, precision.tracer, of.field()},
            chance_of_orbit(scene.seed_of(of), number)};
  }

  void rows(OptionTable& row) {
    row("-r, --ray RAY", "only this ray of the scene, or this fan", ray);
    row("-n, --bounces N", "most bounces, instead of the ray's own", bounces, 0, 10'000'000);
    precision.rows(row);
    row("--speed V|none",
        "world units a second, from the frame of -f on: mirrors are met where they are by then; "
        "none: as the frame has them",
        speeds, &parse_speed);
    row("--corner", "what a ray does in a corner: stop, or return the way it came", corner,
        kCorners);
    row_of_frame(row, frame);
    scene.row_of_seed(row);
    row("--svg", "print a diagram in world coordinates");
    row(kJsonRow);
    row(kCsvRow);
    scene.rows(row);
    if (precision.certified && corner == CornerRule::back)
      row.problem("corner", "a certified orbit ends in a corner",
                  "leave --corner back out, or say --precision double");
  }
};

// As they set off at the time of the frame, not displaced.
Result<std::vector<RayState>> chosen_rays(const Options& options, const Scene& scene,
                                          const FrameState& frame) {
  const std::optional<std::string>& wanted = options.ray;
  std::vector<std::string> known;
  bool any = false;
  const auto chosen = [&](std::uint32_t ray) {
    return !wanted || *wanted == ray_name(scene, ray) || *wanted == scene.rays[ray].written_name;
  };
  for (std::uint32_t ray = 0; ray < scene.rays.size(); ++ray) {
    any |= chosen(ray);
    known.push_back(ray_name(scene, ray));
  }
  std::vector<RayState> rays = ray_states(scene, frame.time);
  std::erase_if(rays, [&](const RayState& ray) { return !chosen(ray.ray); });
  if (!rays.empty()) return rays;
  if (any)
    return fail(named_place(options.operands().front()),
                fmt::format("no ray has a direction in frame {}", frame.frame),
                "ask for a frame in which its curve is not 0");
  if (known.empty())
    return fail(named_place(options.operands().front()), "has no ray to follow",
                "add [[ray]] with at, direction and bounces");
  return unknown_name(options.where("ray"), "ray of the scene", *wanted, known);
}

// The first of some options that asks for more than the usual.
const char* asks_more(const Options& options, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const std::string text = options.text(name).value_or("none");
        text != "none" && text != "double" && text != "stop")
      return name;
  return nullptr;
}

// What only mirrors at rest have.
Result<void> check_frozen(const Options& options, const std::string& ray) {
  if (const char* option = asks_more(options, {"precision", "tracer", "corner"}))
    return usage_error(options.where(option),
                       "is not for rays of finite speed, as '" + ray + "' is",
                       "leave it out, or say --speed none");
  return {};
}

// Mirrors as they move: where contact changes how, they are known up to the last frame.
struct MovingRoom {
  MovingWalls walls;
  double until;
};

Result<MovingRoom> moving_room(const Options& options, const Scene& scene,
                               const FrameState& frame) {
  if (Diagnostics refused = refused_mirrors(scene); !refused.empty())
    return tl::unexpected(std::move(refused));
  const unsigned last = std::max(scene.frames, frame.frame);
  FLATRAY_TRY(timeline, make_timeline(scene, options.scene.seed_of(scene), last));
  return MovingRoom{moving_walls(*timeline), responds(scene) ? (last - 1) / scene.fps : kInfinity};
}

// Rays of finite speed set off at the time of the frame.
Result<OrbitReport> follow_ray(const Options& options, const OrbitRoom& room,
                               const FrameState& frame, const RayState& state,
                               std::optional<MovingRoom>& moving) {
  const RayPath& ray = room.scene.rays[state.ray];
  const std::uint64_t bounces = options.bounces.value_or(ray.bounces);
  const double bytes = static_cast<double>(bounces) * sizeof(Bounce);
  FLATRAY_TRY(fits, expect_memory(options, bytes, fmt::format("an orbit of {} bounces", bounces),
                                  "say fewer --bounces"));
  const std::optional<double> speed = options.speeds.of(ray);
  const std::string name = ray_name(room.scene, state.ray);
  const auto& [at, direction] = state.start;
  if (!speed)
    return follow_orbit(room, name, {world_pose(frame)(at), direction}, bounces,
                        options.request(room.scene, state.ray));
  FLATRAY_TRY(frozen, check_frozen(options, name));
  if (!moving) {
    FLATRAY_TRY(made, moving_room(options, room.scene, frame));
    moving = std::move(*made);
  }
  return follow_moving(room, moving->walls, name, {at, at_speed(direction, *speed)}, frame.time,
                       {bounces, moving->until});
}

// What only straight flights have.
Result<void> check_straight(const Options& options, const Scene& scene) {
  const char* option = asks_more(options, {"precision", "tracer", "corner", "speed"});
  if (scene.field() == 0 || option == nullptr) return {};
  return usage_error(options.where(option), "is not for flights in a magnetic field",
                     "leave it out, or say -D chamber.0.field=0");
}

// What glass does not split.
Result<void> check_unsplit(const Options& options, const Scene& scene) {
  if (const char* option = asks_more(options, {"precision", "corner"}))
    return expect_no_glass(scene, fmt::format("--{} {}", option, *options.text(option)));
  return {};
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

Result<void> follow(const Options& options, Followed& all) {
  FLATRAY_TRY(rays, chosen_rays(options, all.scene, all.frame));
  for (const RayState& ray : *rays) {
    const RayPath& path = all.scene.rays[ray.ray];
    FLATRAY_TRY(report, follow_ray(options, all.room, all.frame, ray, all.moving));
    if (report->starts_badly)
      report_warnings(
          {{path.where, called("ray", path.name, path.where) + " starts " + report->start, ""}},
          options);
    all.reports.push_back(std::move(*report));
  }
  return {};
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(scene, load_only_input(options, options.scene));
  if (auto checked = check_straight(options, *scene); !checked) return fail(std::move(checked));
  if (auto checked = check_unsplit(options, *scene); !checked) return fail(std::move(checked));
  FLATRAY_TRY(frame, frame_of(options.scene, *scene, options.frame));
  const auto all = std::make_shared<Followed>(*std::move(scene), *std::move(frame));
  if (auto done = follow(options, *all); !done) return fail(std::move(done));
  if (options.has("svg")) return VerbOutput{{svg_of(all->room, all->reports)}};
  VerbOutput output{.table = bounce_table(all->room, all->reports), .kept = all};
  for (const OrbitReport& report : all->reports) {
    output.text.emplace_back(bounce_table(all->room, {&report, 1}));
    output.add(as_value(all->room, report), status_line(all->room, report));
  }
  return output;
}

}  // namespace

extern const Verb entry = {
    "orbit",
    "SCENE",
    "follow the rays of a scene from mirror to mirror",
    kCommand<Options, &run>,
    "  flatray orbit scenes/chamber/hall.toml\n"
    "  flatray orbit scenes/chamber/hall.toml --ray probe -n 100 --csv\n"
    "  flatray orbit scenes/chamber/sinai.toml -n 200 --precision certified\n"
    "  flatray orbit scenes/chamber/fermi.toml --csv\n"
    "  flatray orbit scenes/chamber/three_discs.toml --svg > orbit.svg\n",
    "nothing traced"};

}  // namespace flatray::orbit_verb
