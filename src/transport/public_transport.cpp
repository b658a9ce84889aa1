#include <algorithm>
#include <iterator>
#include <utility>

#include "flatray/transport.h"
#include "trace/plain_arrays.h"
#include "trace/walls_data.h"
#include "transport/orbit_tracer.h"

namespace flatray::api {
namespace {

static_assert(static_cast<int>(OrbitEnd::along) == static_cast<int>(flatray::OrbitEnd::along));

Bounce bounce_of(const flatray::Bounce& bounce) {
  return {bounce.surface,    bounce.point.x(),  bounce.point.y(), bounce.t,      bounce.path_length,
          bounce.normal.x(), bounce.normal.y(), bounce.out.x(),   bounce.out.y()};
}

}  // namespace

struct Room::Data {
  Walls walls;
  std::vector<Material> materials;
  OrbitTracer tracer;

  Data(Walls&& taken, CornerRule corners)
      : walls(std::move(taken)),
        materials(walls.size(), Material::mirror),
        tracer(std::as_const(walls).data().surfaces, materials,
               {static_cast<flatray::CornerRule>(corners)}) {}
};

Room::Room(Walls walls, CornerRule corners) : data_(new Data(std::move(walls), corners)) {}
Room::Room(Room&&) noexcept = default;
Room& Room::operator=(Room&&) noexcept = default;
Room::~Room() = default;

std::size_t Room::walls() const { return data_ ? data_->walls.size() : 0; }

Status Room::absorb(std::span<const std::uint32_t> walls) {
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (walls[i] >= this->walls()) return {Fault::no_such, i};
  for (const std::uint32_t wall : walls) data_->materials[wall] = Material::absorb;
  return {};
}

Status Room::orbits(const Rays& starts, std::uint64_t bounces, std::vector<Orbit>& orbits,
                    std::vector<Bounce>& all_bounces) const {
  const Rays bare{starts.ox, starts.oy, starts.dx, starts.dy};
  if (const Status fault = check_rays(bare, 0); !fault) return fault;
  std::vector<OrbitStart> from;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    from.push_back({ray_of(starts, i)});
    if (starts.dx[i] == 0 && starts.dy[i] == 0) return {Fault::direction, i};
  }
  if (!data_) {
    const Room none{Walls()};
    return none.orbits(starts, bounces, orbits, all_bounces);
  }
  orbits.clear();
  all_bounces.clear();
  for (flatray::Orbit& each : trace_orbits(data_->tracer, from, bounces)) {
    const flatray::Orbit traced = std::move(each);  // its memory is free then
    const std::size_t begin = all_bounces.size();
    std::transform(traced.bounces.begin(), traced.bounces.end(), std::back_inserter(all_bounces),
                   bounce_of);
    orbits.push_back({begin, all_bounces.size(), static_cast<OrbitEnd>(traced.end),
                      traced.end_point.x(), traced.end_point.y(), traced.out.x(), traced.out.y()});
  }
  return {};
}

}  // namespace flatray::api
