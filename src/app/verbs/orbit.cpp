#include "transport/orbit.h"

#include <fmt/core.h>

#include "anim/world.h"
#include "app/option_values.h"
#include "app/report.h"
#include "app/scene_input.h"
#include "app/tracer_choice.h"
#include "app/verb.h"
#include "base/number_text.h"
#include "geom/hit_interval.h"

namespace flatray::verbs {
namespace {

constexpr auto kOptions =
    with_scene_options({{"ray", 'r', "RAY", "only this ray of the scene"},
                        {"bounces", 'n', "N", "most bounces, instead of the ray's own"},
                        kTracerOption,
                        kFrameOption,
                        kSeedOption,
                        kJsonOption,
                        kCsvOption});

constexpr double kDegreesInRadian = 57.29577951308232;

std::string point_text(const Vec2& point) {
  return fmt::format("({}, {})", number_text(point.x()), number_text(point.y()));
}

// Name and edge of what stands behind a surface.
struct Named {
  std::string object;
  JsonValue edge;
};

Named named(const Scene& scene, const SurfaceOwner& owner) {
  std::string object;
  switch (owner.kind) {
    case SurfaceOwner::Kind::entity:
      object = scene.entities[owner.index].name;
      break;
    case SurfaceOwner::Kind::chamber:
      object = scene.chambers[owner.index].name;
      break;
    case SurfaceOwner::Kind::pillar: {
      const Chamber& chamber = scene.chambers[owner.index];
      object = fmt::format("{}/{}", chamber.name, chamber.pillars[owner.pillar].name);
      break;
    }
  }
  return {std::move(object), owner.edge == kNoEdge ? JsonValue("circle") : JsonValue(owner.edge)};
}

Table bounce_table(const Scene& scene, const World& world, const std::string& ray,
                   const Orbit& orbit) {
  Table table{{"ray", "bounce", "t", "path_length", "x", "y", "object", "edge", "normal_x",
               "normal_y", "incidence_deg"},
              {}};
  unsigned number = 0;
  for (const Bounce& bounce : orbit.bounces) {
    const Named wall = named(scene, world.owners[bounce.surface]);
    table.rows.push_back({ray, ++number, bounce.t, bounce.path_length, bounce.point.x(),
                          bounce.point.y(), wall.object, wall.edge, bounce.normal.x(),
                          bounce.normal.y(), bounce.incidence * kDegreesInRadian});
  }
  return table;
}

std::string walls_text(const Scene& scene, const World& world, const Orbit& orbit) {
  std::string text;
  for (const std::uint32_t surface : orbit.end_surfaces) {
    const Named wall = named(scene, world.owners[surface]);
    text += fmt::format("{}{} edge {}", text.empty() ? "" : " and ", wall.object,
                        wall.edge.as_text().value_or(json_text(wall.edge)));
  }
  return text;
}

std::string status_line(const Scene& scene, const World& world, const RayPath& ray,
                        const Orbit& orbit) {
  std::string text =
      fmt::format("{}: {} after {} bounces", ray.name, name(orbit.end), orbit.bounces.size());
  if (orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner)
    text += fmt::format(" at {}, {}", point_text(orbit.end_point), walls_text(scene, world, orbit));
  else
    text += fmt::format(", leaving along {}", point_text(orbit.out));
  if (!orbit.bounces.empty())
    text += fmt::format(", path length {} to the last bounce",
                        number_text(orbit.bounces.back().path_length));
  return text + "\n";
}

Result<std::vector<const RayPath*>> chosen_rays(const Arguments& arguments, const Scene& scene) {
  const std::optional<std::string> wanted = arguments.text("ray");
  std::vector<const RayPath*> rays;
  std::vector<std::string> known;
  for (const RayPath& ray : scene.rays) {
    if (!wanted || *wanted == ray.name) rays.push_back(&ray);
    known.push_back(ray.name);
  }
  if (!rays.empty()) return rays;
  if (!wanted)
    return fail(named_place(arguments.operands().front()), "has no ray to follow",
                "add [[ray]] with at, direction and bounces");
  return unknown_name(arguments.where("ray"), "ray of the scene", *wanted, known);
}

JsonValue orbit_value(const Scene& scene, const World& world, const RayPath& ray,
                      const Orbit& orbit) {
  const bool stands_somewhere = orbit.end != OrbitEnd::limit && orbit.end != OrbitEnd::escape;
  return Fields{
      {"ray", ray.name},
      {"start", Values{orbit.start.x(), orbit.start.y()}},
      {"direction", Values{orbit.direction.x(), orbit.direction.y()}},
      {"bounces", as_objects(bounce_table(scene, world, ray.name, orbit))},
      {"end", name(orbit.end)},
      {"out", Values{orbit.out.x(), orbit.out.y()}},
      {"end_point", stands_somewhere ? JsonValue(Values{orbit.end_point.x(), orbit.end_point.y()})
                                     : JsonValue()},
      {"end_walls", walls_text(scene, world, orbit)}};
}

// What the three forms of output are made of, ray after ray.
struct Report {
  Values values;
  Table table;
  std::string text;

  void add(const Scene& scene, const World& world, const RayPath& ray, const Orbit& orbit) {
    values.push_back(orbit_value(scene, world, ray, orbit));
    const Table bounces = bounce_table(scene, world, ray.name, orbit);
    table.columns = bounces.columns;
    table.rows.insert(table.rows.end(), bounces.rows.begin(), bounces.rows.end());
    text += aligned_text(bounces) + status_line(scene, world, ray, orbit);
  }
};

Result<Report> follow(const Arguments& arguments, const Scene& scene) {
  constexpr std::uint64_t kMostBounces = 10'000'000;
  const auto rays = chosen_rays(arguments, scene);
  if (!rays) return tl::unexpected(rays.error());
  const auto frame = frame_of(arguments, scene);
  if (!frame) return tl::unexpected(frame.error());
  const auto tracer = chosen_tracer(arguments);
  if (!tracer) return tl::unexpected(tracer.error());
  const World world = build_world(scene, *frame);
  const std::vector<Material> materials = world.materials();
  Report report;
  for (const RayPath* ray : *rays) {
    const auto bounces = arguments.whole("bounces", ray->bounces, 0, kMostBounces);
    if (!bounces) return tl::unexpected(bounces.error());
    const Ray start{world_pose(*frame)(ray->at), ray->direction};
    report.add(scene, world, *ray,
               trace_orbit(world.surfaces, materials, start, *bounces, *tracer));
  }
  return report;
}

Result<VerbOutput> run(const Arguments& arguments) {
  const auto scene = load_only_input(arguments);
  if (!scene) return tl::unexpected(scene.error());
  auto report = follow(arguments, *scene);
  if (!report) return fail(std::move(report));
  if (arguments.has("json"))
    return VerbOutput{json_report("orbit", arguments, std::move(report->values), 0)};
  return VerbOutput{arguments.has("csv") ? csv_text(report->table) : std::move(report->text)};
}

}  // namespace

extern const Verb orbit = {"orbit",
                           "SCENE",
                           "follow the rays of a scene from mirror to mirror",
                           1,
                           1,
                           kOptions,
                           "  flatray orbit scenes/chamber/hall.toml\n"
                           "  flatray orbit scenes/chamber/hall.toml --ray probe -n 100 --csv\n",
                           "nothing traced",
                           &run};

}  // namespace flatray::verbs
