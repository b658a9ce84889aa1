#include "transport/light/forward.h"

#include "base/check.h"
#include "base/parallel.h"
#include "base/philox.h"
#include "geom/predicates.h"
#include "transport/light/bodies.h"
#include "transport/light/emission.h"
#include "transport/light/net.h"
#include "transport/light/order.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

constexpr std::size_t kChunk = 2048;  // rays that a thread takes at a time

class Forward {
 public:
  Forward(const World& world, std::span<const Scatterer* const> scatterers,
          std::span<const LampState> lamps, const FilmPlace& place, const LightRules& rules)
      : walls_(world.surfaces),
        materials_(world.materials()),
        scatterers_(scatterers),
        place_(place),
        rules_(rules),
        block_rays_(static_cast<std::uint32_t>(std::min(rules.light.rays, kLightBlock))),
        bodies_(world, scatterers),
        emission_(lamps, block_rays_, rules.light.sampler, rules.seed, rules.frame,
                  bodies_.disperse() ? kMostOfWavelength : 1),
        lander_(walls_),
        tracer_(choose_tracer(walls_, rules.tracer).tracer->build(walls_)),
        size_(world_size(place)),
        film_(place.width, place.height, 3) {}

  TracedLight trace() && {
    const std::uint64_t blocks = rays_traced(rules_.light.rays) / block_rays_;
    bool whole = true;
    for (std::uint64_t block = 0; block < blocks && whole; ++block) whole = trace_block(block);
    const double unit = 0x1p-16 * place_.pixels_per_unit * emission_.ray_power();
    return {std::move(film_), unit / static_cast<double>(blocks), counts_, whole};
  }

 private:
  // Where a ray comes to a wall, and what it may do there.
  struct Landed {
    NearestHit hit;
    Landing landing;
  };

  // What chance decides at a wall, uniform in [0, 1).
  struct Numbers {
    double bounce, colour;
  };

  // Calls `task(begin, end, counts)` for parts of [0, count), on all threads.
  template <class Task>
  void in_parts(std::size_t count, const Task& task) {
    std::vector<LightCounts> counts((count + kChunk - 1) / kChunk);
    parallel_for(counts.size(), rules_.threads, [&](std::size_t i) {
      task(i * kChunk, std::min((i + 1) * kChunk, count), counts[i]);
    });
    for (const LightCounts& one : counts) counts_ += one;
  }

  bool trace_block(std::uint64_t block) {
    emit(block);
    for (std::uint32_t bounces = 0; !rays_.empty(); ++bounces) {
      if (rules_.stop != nullptr && rules_.stop()) return false;
      fly();
      film_.add(lines_, rules_.threads);
      scatter(block, bounces);
    }
    return true;
  }

  void emit(std::uint64_t block) {
    rays_.resize(emission_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts& counts) {
      for (std::size_t i = begin; i < end; ++i) {
        rays_[i] = emission_.ray(block, static_cast<std::uint32_t>(i));
        counts.emitted += energy(rays_[i].weight);
        gamble(rays_[i], faint_, random_number(Stream::roulette, block, rays_[i].number, kEmitted),
               counts);
        if (sets_off(rays_[i])) continue;
        counts.at_corners += energy(rays_[i].weight);
        rays_[i].weight = {0, 0, 0};
      }
      counts.rays += end - begin;
    });
    drop_dark();
  }

  // As an orbit does: what stands on a wall has left it.
  bool sets_off(LightRay& ray) const {
    const std::vector<std::uint32_t> stood_on = lander_.walls_at(ray.ray.origin);
    if (bodies_.any()) ray.media = bodies_.around(ray.ray.origin);
    if (stood_on.empty()) return true;
    if (stood_on.size() > 1 || is_end(walls_, stood_on.front(), ray.ray.origin)) return false;
    ray.left = {stood_on.front(), root_stood_on(walls_, stood_on.front(), ray.ray)};
    if (runs_along(walls_, ray.left, ray.ray.direction)) return false;
    const std::uint32_t body = bodies_.of(ray.left.surface);
    if (body != Media::kNone && goes_inside(walls_, ray.left, ray.ray.direction))
      ray.media.enter(body);
    return true;
  }

  void drop_dark() {
    std::erase_if(rays_, [](const LightRay& ray) { return largest(ray.weight) == 0; });
  }

  // Takes every ray to its next wall, or out of the picture.
  void fly() {
    arrivals_.resize(rays_.size());
    lines_.resize(rays_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts& counts) {
      RayBatch batch;
      batch.tangents = false;
      for (std::size_t i = begin; i < end; ++i) batch.add(rays_[i].ray, rays_[i].left);
      std::vector<NearestHit> hits(end - begin);
      tracer_->nearest(batch, hits);
      for (std::size_t i = begin; i < end; ++i) {
        const Ray& ray = rays_[i].ray;
        Landed& arrival = arrivals_[i];
        arrival.hit = hits[i - begin];
        if (arrival.hit) arrival.landing = lander_.land(ray, arrival.hit);
        const Vec2 to = arrival.hit ? arrival.landing.point : beyond_film(ray);
        lines_[i] = line(ray.origin, to, rays_[i].weight);
      }
      counts.legs += end - begin;
    });
  }

  Vec2 beyond_film(const Ray& ray) const {
    const double far = (ray.origin - size_.centre()).lpNorm<1>() + size_.size().lpNorm<1>();
    return ray.origin + far * ray.direction;
  }

  LightLine line(const Vec2& from, const Vec2& to, const LightWeight& weight) const {
    const auto px = [&](double world) { return held(world * place_.pixels_per_unit); };
    return {px(from.x() - place_.left), px(place_.top - from.y()), px(to.x() - place_.left),
            px(place_.top - to.y()), weight};
  }

  // What the walls do with the light that has come to them, in order of place.
  void scatter(std::uint64_t block, std::uint32_t bounces) {
    const std::vector<std::uint32_t> order = order_of_arrival();
    std::vector<LightRay> next(order.size());
    const auto scramble = static_cast<std::uint32_t>(
        random_bits(rules_.seed, Stream::bounce, rules_.frame, block, bounces));
    in_parts(order.size(), [&](std::size_t begin, std::size_t end, LightCounts& counts) {
      for (std::size_t k = begin; k < end; ++k) {
        const LightRay& ray = rays_[order[k]];
        const Numbers numbers = rules_.light.sampler == LightSampler::sorted
                                    ? net_numbers(static_cast<std::uint32_t>(k), scramble)
                                    : random_numbers(block, ray.number, bounces);
        next[k] = scattered(ray, arrivals_[order[k]], bounces, numbers, counts);
        if (next[k].weight != LightWeight{0, 0, 0})
          gamble(next[k], faint_, random_number(Stream::roulette, block, ray.number, bounces),
                 counts);
      }
    });
    rays_ = std::move(next);
    drop_dark();
  }

  static Numbers net_numbers(std::uint32_t rank, std::uint32_t scramble) {
    return {net_number(rank, scramble), net_number(rank, 1, ~scramble)};
  }
  Numbers random_numbers(std::uint64_t block, std::uint32_t number, std::uint32_t bounces) const {
    return {random_number(Stream::bounce, block, number, bounces),
            random_number(Stream::colour, block, number, bounces)};
  }
  double random_number(Stream stream, std::uint64_t block, std::uint32_t number,
                       std::uint32_t bounces) const {
    const std::uint64_t item = block * emission_.size() + number;
    const auto high = static_cast<std::uint32_t>(item >> 32);
    return unit_double(
        random_bits(rules_.seed, stream, rules_.frame, item, bounces + (high << 20)));
  }

  std::vector<std::uint32_t> order_of_arrival() {
    places_.resize(rays_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts&) {
      for (std::size_t i = begin; i < end; ++i)
        places_[i] = rules_.light.sampler == LightSampler::sorted ? place_of(arrivals_[i]) : i;
    });
    return ascending_order(places_);
  }

  // The place along a segment by its larger extent, on a curve by the angle of its form.
  WallPlace place_of(const Landed& arrival) const {
    const std::uint32_t surface = arrival.hit.surface;
    if (!arrival.hit) return ~WallPlace{0};
    double share = 0;
    const Vec2& point = arrival.landing.point;
    if (walls_.is_straight(surface)) {
      const Segment& wall = walls_.segments[walls_.slot[surface]];
      const Vec2 along = wall.b - wall.a;
      const int axis = std::fabs(along.x()) >= std::fabs(along.y()) ? 0 : 1;
      share = (point[axis] - wall.a[axis]) / along[axis];
    } else {
      share = turn_share(point - walls_.curve(surface).centre);
    }
    const double held = share > 0 ? std::min(share, 1 - 0x1p-32) : 0;  // NaN: 0
    return (WallPlace{surface} << 32) | static_cast<std::uint32_t>(held * 0x1p32);
  }

  // Rises from 0 to 1 as `v` turns once; by its components alone.
  static double turn_share(const Vec2& v) {
    const double part = v.y() / (std::fabs(v.x()) + std::fabs(v.y()));
    return v.x() < 0 ? (2 - part) / 4 : v.y() < 0 ? (4 + part) / 4 : part / 4;
  }

  // The ray that goes on, or one of weight 0.
  LightRay scattered(const LightRay& ray, const Landed& arrival, std::uint32_t bounces,
                     const Numbers& numbers, LightCounts& counts) const {
    const auto ends = [&](std::int64_t& where, std::int64_t with) {
      where += with;
      return LightRay{ray.ray, {}, {0, 0, 0}, ray.number};
    };
    if (!arrival.hit) return ends(counts.escaped, energy(ray.weight));
    if (!arrival.landing.corner.empty())
      return ends(all_absorb(arrival.landing.corner) ? counts.absorbed : counts.at_corners,
                  energy(ray.weight));
    const std::uint32_t surface = arrival.hit.surface;
    const Sign side = inner_side(walls_, ray.ray, arrival.hit);
    const Vec2 normal = static_cast<double>(side) * unit(arrival.landing.normal);
    LightRay next = ray;
    if (ray.nm == 0 && bodies_.disperse_at(surface, ray.media))
      take_wavelength(next, numbers.colour, counts);
    const auto nm = static_cast<double>(next.nm);
    const Departure departure =
        depart(surface,
               {ray.ray.direction, normal, from_inside(walls_, ray.ray, arrival.hit),
                bodies_.index_around(ray.media, bodies_.of(surface), nm), nm},
               numbers.bounce);
    const std::int64_t left = energy(next.weight);
    if (departure.way == Departure::Way::absorbed) return ends(counts.absorbed, left);
    if (bounces == rules_.light.bounces) return ends(counts.cut_off, left);
    next.ray.origin = arrival.landing.point;
    for (std::size_t c = 0; c < 3; ++c) next.weight[c] *= departure.tint[c];
    if (!leaves(ray, arrival, departure, next)) return ends(counts.cut_off, left);
    counts.absorbed += left - energy(next.weight);
    return next;
  }

  // From then on the light is of one colour, by chance.
  static void take_wavelength(LightRay& ray, double u, LightCounts& counts) {
    const std::int64_t before = energy(ray.weight);
    ray.nm = static_cast<float>(kFirstWavelength + u * (kLastWavelength - kFirstWavelength));
    const LightColour part = part_of_wavelength(static_cast<double>(ray.nm));
    for (std::size_t c = 0; c < 3; ++c) ray.weight[c] *= static_cast<float>(part[c]);
    FLATRAY_DCHECK(largest(ray.weight) <= 1);
    counts.gambled += before - energy(ray.weight);
  }

  Departure depart(std::uint32_t surface, const Arrival& arrival, double u) const {
    if (scatterers_[surface] != nullptr) return scatterers_[surface]->scatter(arrival, u);
    return {materials_[surface] == Material::mirror ? Departure::Way::mirrored
                                                    : Departure::Way::absorbed};
  }

  bool all_absorb(std::span<const std::uint32_t> surfaces) const {
    return std::all_of(surfaces.begin(), surfaces.end(), [&](std::uint32_t i) {
      return scatterers_[i] == nullptr && materials_[i] == Material::absorb;
    });
  }

  // Gives `next` its direction and what it has left; false where it would run along the wall.
  bool leaves(const LightRay& ray, const Landed& arrival, const Departure& departure,
              LightRay& next) const {
    const std::uint32_t surface = arrival.hit.surface;
    switch (departure.way) {
      case Departure::Way::absorbed:
        return false;
      case Departure::Way::through:
        next.left = {surface, arrival.hit.root};
        return true;
      case Departure::Way::mirrored: {
        const auto reflection = reflect_off(walls_, ray.ray, arrival.hit, arrival.landing, speed_);
        if (!reflection) return false;
        next.ray.direction = reflection->direction;
        next.left = {surface, root_left_by(arrival.hit.root)};
        return true;
      }
      case Departure::Way::scattered:
        next.ray.direction = departure.direction;
        next.left = {surface, root_stood_on(walls_, surface, next.ray)};
        if (runs_along(walls_, next.left, next.ray.direction)) return false;
        if (departure.stays &&
            !leads_away(walls_, surface, inner_side(walls_, ray.ray, arrival.hit), next.ray.origin,
                        next.ray.direction))
          return false;
        change_media(next, surface, from_inside(walls_, ray.ray, arrival.hit));
        return true;
    }
    unreachable();
  }

  void change_media(LightRay& ray, std::uint32_t surface, bool was_inside) const {
    const std::uint32_t body = bodies_.of(surface);
    if (body == Media::kNone) return;
    const bool is_inside = goes_inside(walls_, ray.left, ray.ray.direction);
    if (was_inside && !is_inside) ray.media.leave(body);
    if (!was_inside && is_inside) ray.media.enter(body);
  }

  // Rays fainter than `faint` go on with the chance of their weight, and are then three times as
  // bright as that.
  static void gamble(LightRay& ray, float faint, double u, LightCounts& counts) {
    const float brightest = largest(ray.weight);
    if (brightest >= faint) return;
    const std::int64_t before = energy(ray.weight);
    const float chance = brightest / (3 * faint);
    const bool goes_on = u < static_cast<double>(chance);
    for (float& channel : ray.weight) channel = goes_on ? channel / chance : 0;
    counts.gambled += before - energy(ray.weight);
  }

  static Bounds world_size(const FilmPlace& place) {
    const Vec2 size = Vec2(place.width, place.height) / place.pixels_per_unit;
    return {{place.left, place.top - size.y()}, {place.left + size.x(), place.top}};
  }

  static constexpr std::uint32_t kEmitted = (1U << 20) - 1;  // no number of bounces

  const Surfaces& walls_;
  const std::vector<Material> materials_;
  std::span<const Scatterer* const> scatterers_;
  const FilmPlace& place_;
  const LightRules& rules_;
  const std::uint32_t block_rays_;
  const Bodies bodies_;
  const Emission emission_;
  // What is to have one wavelength must stay as dark as light that has just set off.
  const float faint_ = bodies_.disperse() ? 0.1F / static_cast<float>(kMostOfWavelength) : 0.1F;
  const Lander lander_;
  const std::unique_ptr<Accelerator> tracer_;
  const Bounds size_;
  const Speed speed_{Vec2(1, 0)};
  LightFilm film_;
  LightCounts counts_;
  std::vector<LightRay> rays_;  // under way
  std::vector<Landed> arrivals_;
  std::vector<LightLine> lines_;
  std::vector<WallPlace> places_;
};

}  // namespace

LightCounts& LightCounts::operator+=(const LightCounts& more) {
  rays += more.rays, legs += more.legs;
  emitted += more.emitted, absorbed += more.absorbed, escaped += more.escaped;
  at_corners += more.at_corners, cut_off += more.cut_off, gambled += more.gambled;
  return *this;
}

std::uint64_t rays_traced(std::uint64_t rays) {
  return rays <= kLightBlock ? rays : (rays + kLightBlock - 1) / kLightBlock * kLightBlock;
}

TracedLight trace_light(const World& world, std::span<const Scatterer* const> scatterers,
                        std::span<const LampState> lamps, const FilmPlace& place,
                        const LightRules& rules) {
  return Forward(world, scatterers, lamps, place, rules).trace();
}

}  // namespace flatray
