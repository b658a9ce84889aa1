#include "transport/light/backward.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/philox.h"
#include "geom/turn.h"
#include "scene/lambert.h"
#include "transport/light/net.h"
#include "transport/light/seen_lamps.h"

namespace flatray {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kParts = 16;  // independent, each with a net of its own
constexpr std::size_t kPixels = 64;   // that a thread takes at a time
constexpr std::uint64_t kRound = 64;  // paths of a pixel followed at once, a multiple of kParts
constexpr std::size_t kLooksAtOnce = 1U << 16;
constexpr double kFaint = 0.1;  // of the weight of a path that sets off

// A path on its way from a pixel to lamps.
struct Path {
  std::uint32_t pixel = 0;  // of those a thread has taken
  std::uint32_t part = 0;
  std::uint64_t key = 0;     // names its random numbers
  LightSum weight{0, 0, 0};  // what light that comes along it adds to the fluence, by its radiance
};

// A point that looks towards a lamp.
struct Look {
  std::size_t path;
  std::uint32_t bounces;  // that are left
  Vec2 from;              // of the lamp
  LightSum light;         // that it adds, if nothing is in the way
};

class Backward {
 public:
  Backward(const World& world, std::span<const Scatterer* const> scatterers,
           std::span<const LampState> lamps, const FilmPlace& place, const LightRules& rules)
      : walls_(world, scatterers, rules.tracer),
        lamps_(lamps, walls_),
        place_(place),
        rules_(rules),
        paths_(paths_a_pixel(rules.light.rays, pixels())) {}

  GatheredLight gather() const {
    GatheredLight gathered;
    gathered.fluence.resize(3 * pixels());
    gathered.error.resize(3 * pixels());
    std::vector<std::uint8_t> left_out((pixels() + kPixels - 1) / kPixels);
    parallel_for(left_out.size(), rules_.threads, [&](std::size_t i) {
      const std::size_t first = i * kPixels;
      Pixels taken(*this, first, std::min(kPixels, pixels() - first));
      if (!taken.gather()) left_out[i] = 1;
      taken.give(std::span(gathered.fluence).subspan(3 * first),
                 std::span(gathered.error).subspan(3 * first));
    });
    gathered.paths = paths_ * pixels();
    gathered.whole = std::ranges::find(left_out, 1) == left_out.end();
    return gathered;
  }

 private:
  std::size_t pixels() const {
    return static_cast<std::size_t>(place_.width) * static_cast<std::size_t>(place_.height);
  }

  // Some pixels, followed together.
  class Pixels {
   public:
    Pixels(const Backward& of, std::size_t first, std::size_t count)
        : of_(of), first_(first), count_(count), sums_(count * kParts) {}

    bool gather() {
      for (std::uint64_t begin = 0; begin < of_.paths_; begin += kRound) {
        if (of_.rules_.stop != nullptr && of_.rules_.stop()) return false;
        set_off(begin, std::min(begin + kRound, of_.paths_));
        for (std::uint32_t bounces = 0; !paths_.empty(); ++bounces) {
          fly();
          scatter(bounces);
        }
      }
      return true;
    }

    // Means, and standard errors from the parts.
    void give(std::span<double> fluence, std::span<double> error) const {
      const std::uint64_t paths_of_part = of_.paths_ / kParts;
      const auto paths = static_cast<double>(paths_of_part);
      for (std::size_t i = 0; i < 3 * count_; ++i) {
        double sum = 0, squares = 0;
        const auto part = [&](std::size_t k) { return sums_[i / 3 * kParts + k][i % 3] / paths; };
        for (std::size_t k = 0; k < kParts; ++k) sum += part(k);
        fluence[i] = sum / kParts;
        for (std::size_t k = 0; k < kParts; ++k)
          squares += (part(k) - fluence[i]) * (part(k) - fluence[i]);
        error[i] = std::sqrt(squares / (kParts * (kParts - 1)));
      }
    }

   private:
    void set_off(std::uint64_t begin, std::uint64_t end) {
      for (std::uint32_t pixel = 0; pixel < count_; ++pixel)
        for (std::uint64_t i = begin; i < end; ++i) {
          const Path path{pixel,
                          static_cast<std::uint32_t>(i % kParts),
                          bits(first_ + pixel, static_cast<std::uint32_t>(i)),
                          {2 * kPi, 2 * kPi, 2 * kPi}};
          const LightRay light = of_.start(first_ + pixel, i);
          look(path, light, 1 / (2 * kPi), of_.rules_.light.bounces, nullptr);
          paths_.push_back(path), rays_.push_back(light);
        }
      add_looks();
      drop([&](std::size_t i) { return !of_.walls_.sets_off(rays_[i]); });
    }

    std::uint64_t bits(std::size_t pixel, std::uint32_t path) const {
      return random_bits(of_.rules_.seed, Stream::gather, of_.rules_.frame, pixel,
                         path + kNetNumbers * kParts);
    }

    // A matt wall that a path has met.
    struct Matt {
      const LightHit& met;
      bool both_sides;
    };
    // Notes the lamps that a point sees from one direction; `share` is what of their fluence, times the
    // cosine at a wall, becomes radiance along the path.
    void look(const Path& path, const LightRay& at, double share, std::uint32_t bounces,
              const Matt* wall) {
      for (std::size_t lamp = 0; lamp < of_.lamps_.size(); ++lamp) {
        const auto sight = of_.lamps_.sight(lamp, at.ray.origin);
        if (!sight) continue;
        LightRay towards = at;
        towards.ray.direction = sight->from - at.ray.origin;
        if (towards.ray.direction.isZero(0)) continue;
        double part = share;
        if (wall != nullptr) {
          const double cosine = wall->met.normal.dot(unit(towards.ray.direction));
          part *= wall->both_sides ? std::abs(cosine) : cosine;
          if (!(part > 0) || !of_.walls_.sets_off_from(towards, wall->met, !wall->both_sides))
            continue;
        }
        Look one{path.pixel * kParts + path.part, bounces, sight->from, {}};
        for (std::size_t c = 0; c < 3; ++c)
          one.light[c] = path.weight[c] * part * sight->fluence[c];
        looks_.push_back(one);
        looking_.add(towards.ray, towards.departed);
        if (looks_.size() == kLooksAtOnce) add_looks();
      }
    }

    void add_looks() {
      std::vector<NearestHit> hits(looks_.size());
      looking_.tangents = false;
      of_.walls_.tracer().nearest(looking_, hits);
      for (std::size_t i = 0; i < looks_.size(); ++i) {
        const Look& one = looks_[i];
        const auto passed = of_.lamps_.passes(one.from, looking_.ray(i), looking_.departed[i],
                                              hits[i], one.bounces);
        for (std::size_t c = 0; c < 3; ++c)
          sums_[one.path][c] += static_cast<double>(passed[c]) * one.light[c];
      }
      looks_.clear();
      looking_.resize(0);
    }

    void fly() {
      met_.resize(rays_.size());
      of_.walls_.fly(rays_, met_);
      if (!of_.lamps_.any_lines()) return;
      std::vector<LightSum> radiance(rays_.size(), LightSum{0, 0, 0});
      of_.lamps_.add_lines(rays_, met_, radiance);
      for (std::size_t i = 0; i < rays_.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
          sums_[paths_[i].pixel * kParts + paths_[i].part][c] +=
              paths_[i].weight[c] * radiance[i][c];
    }

    void scatter(std::uint32_t bounces) {
      drop([&](std::size_t i) { return !goes_on(i, bounces); });
      add_looks();
    }

    bool goes_on(std::size_t i, std::uint32_t bounces) {
      const LightHit& met = met_[i];
      if (!met.hit || met.in_corner) return false;
      if (bounces == of_.rules_.light.bounces) return false;
      const auto number = [&](std::uint32_t draw) {
        return unit_double(random_bits(paths_[i].key, Stream::bounce, bounces, 0, draw));
      };
      const Arrival arrival = of_.walls_.arrival(rays_[i], met);
      Departure departure = of_.walls_.depart(met, arrival, number(0));
      Path& path = paths_[i];
      const LightSum left = of_.walls_.bodies().left_after(met.hit.t, rays_[i].media);
      for (std::size_t c = 0; c < 3; ++c) path.weight[c] *= left[c];
      for (std::size_t c = 0; c < 3; ++c) path.weight[c] *= static_cast<double>(departure.tint[c]);
      if (departure.way == Departure::Way::scattered &&
          !turned_round(i, of_.rules_.light.bounces - bounces - 1, arrival, departure, number(1)))
        return false;
      return of_.walls_.leaves(rays_[i], met, departure) && gamble(path, number(2));
    }

    // Scattering the other way: of what comes, not of what leaves.
    bool turned_round(std::size_t i, std::uint32_t bounces_left, const Arrival& arrival,
                      Departure& departure, double u) {
      Path& path = paths_[i];
      const double cosine = -arrival.direction.dot(arrival.normal);
      const LightHit& met = met_[i];
      const std::uint32_t surface = met.hit.surface;
      if (of_.walls_.shares(surface) == nullptr) {  // refracted: radiance goes with the index
        const Bodies& bodies = of_.walls_.bodies();
        const double ratio = bodies.index_in(bodies.of(surface), 0) / arrival.outer_index;
        for (double& channel : path.weight) channel *= arrival.from_inside ? ratio : 1 / ratio;
        return true;
      }
      LightRay at = rays_[i];
      at.ray.origin = met.point;
      const Matt wall{met, !departure.stays};
      if (departure.stays) {
        look(path, at, 0.5, bounces_left, &wall);
        return true;
      }
      // Light that comes to a unit of the wall leaves alike in all directions, but from each direction
      // the wall looks shorter by the cosine.
      if (!(cosine > 0)) return false;
      look(path, at, 1 / (2 * kPi * cosine), bounces_left, &wall);
      const bool back = u < 0.5;
      departure.direction =
          lambert_direction((back ? 1.0 : -1.0) * arrival.normal, 2 * u - (back ? 0 : 1));
      for (double& channel : path.weight) channel *= 2 / (kPi * cosine);
      return true;
    }

    static bool gamble(Path& path, double u) {
      const double most = *std::ranges::max_element(path.weight) / (2 * kPi);
      if (most >= kFaint) return true;
      const double chance = most / (3 * kFaint);
      for (double& channel : path.weight) channel /= chance;
      return u < chance;
    }

    template <class Ends>
    void drop(const Ends& ends) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < paths_.size(); ++i) {
        if (ends(i)) continue;
        paths_[kept] = paths_[i], rays_[kept] = rays_[i];
        ++kept;
      }
      paths_.resize(kept), rays_.resize(kept);
    }

    const Backward& of_;
    const std::size_t first_, count_;
    std::vector<LightSum> sums_;  // by pixel and part
    std::vector<Path> paths_;
    std::vector<LightRay> rays_;  // of the paths
    std::vector<LightHit> met_;
    std::vector<Look> looks_;
    RayBatch looking_;
  };

  static constexpr unsigned kNetNumbers = 3;

  // Where in a pixel path `i` sets off, and whereto.
  LightRay start(std::size_t pixel, std::uint64_t i) const {
    const auto part = static_cast<std::uint32_t>(i % kParts);
    const auto index = static_cast<std::uint32_t>(i / kParts);
    double u[kNetNumbers];
    for (unsigned k = 0; k < kNetNumbers; ++k) {
      const auto scramble = static_cast<std::uint32_t>(
          random_bits(rules_.seed, Stream::gather, rules_.frame, pixel, part * kNetNumbers + k));
      u[k] = net_number(index, k, scramble);
    }
    const auto width = static_cast<std::size_t>(place_.width);
    const std::size_t column = pixel % width, row = pixel / width;
    const double x = static_cast<double>(column) + u[1], y = static_cast<double>(row) + u[2];
    const Turn out = turn(2 * kPi * u[0]);
    LightRay ray;
    ray.ray = {{place_.left + x / place_.pixels_per_unit, place_.top - y / place_.pixels_per_unit},
               {out.cos, out.sin}};
    return ray;
  }

  const LitWalls walls_;
  const SeenLamps lamps_;
  const FilmPlace& place_;
  const LightRules& rules_;
  const std::uint64_t paths_;
};

}  // namespace

std::uint64_t paths_a_pixel(std::uint64_t rays, std::uint64_t pixels) {
  const std::uint64_t most = kParts * pixels;
  return std::max<std::uint64_t>((rays + most - 1) / most, 1) * kParts;
}

GatheredLight gather_light(const World& world, std::span<const Scatterer* const> scatterers,
                           std::span<const LampState> lamps, const FilmPlace& place,
                           const LightRules& rules) {
  return Backward(world, scatterers, lamps, place, rules).gather();
}

}  // namespace flatray
