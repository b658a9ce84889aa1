#include "transport/light/forward.h"

#include "base/check.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/philox.h"
#include "transport/light/emission.h"
#include "transport/light/lit_walls.h"
#include "transport/light/net.h"
#include "transport/light/order.h"
#include "transport/light/seen_lamps.h"

namespace flatray {
namespace {

constexpr std::size_t kChunk = 2048;  // rays that a thread takes at a time
constexpr std::size_t kAhead = 12;    // of them, fetched before their turn

class Forward {
 public:
  Forward(std::span<const World> worlds, std::span<const Scatterer* const> scatterers,
          std::span<const LampState> lamps, const FilmPlace& place, const LightRules& rules)
      : worlds_(ready(worlds, scatterers, rules.tracer)),
        walls_(*worlds_.front()),
        place_(place),
        rules_(rules),
        scrambles_(scrambles(lamps)),
        size_(world_size(place)),
        beside_(walls_beside(lamps, walls_.walls())) {}

  TracedLight trace(TracedLight light, const NextRound& next) && {
    light_ = std::move(light);
    light_.round_unit = 0x1p-16 * place_.pixels_per_unit * scrambles_.front().emission.ray_power();
    while (light_.films.size() < scrambles_.size())
      light_.films.emplace_back(place_.width, place_.height, rules_.channels);
    while (light_.whole && light_.lines() <= LightFilm::kMostLines - most_lines_of_round()) {
      const std::optional<std::uint64_t> round = next(light_);
      if (!round) break;
      light_.whole = trace_round(*round);
      if (light_.whole) light_.rounds.add(*round);
    }
    return std::move(light_);
  }

 private:
  // Seeds give independent pictures.
  struct Scramble {
    std::uint64_t seed;
    Emission emission;
  };

  std::vector<Scramble> scrambles(std::span<const LampState> lamps) const {
    const std::uint64_t count = rules_.light.scrambles;
    const std::uint64_t rays = std::min(rules_.light.rays, kLightRound);
    const auto of_each = static_cast<std::uint32_t>((rays + count - 1) / count);
    std::vector<Scramble> all;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t seed =
          i == 0 ? rules_.seed : random_bits(rules_.seed, Stream::scramble, 0, i);
      all.push_back({seed, Emission(lamps, of_each, rules_.light.sampler, seed, rules_.frame,
                                    walls_.bodies().disperse() ? kMostOfWavelength : 1)});
    }
    return all;
  }

  std::uint64_t most_lines_of_round() const {
    return (walls_.bodies().absorb() ? kMostLinesOfLeg : 1) * scrambles_.size() *
           scrambles_.front().emission.size() * (std::uint64_t{rules_.light.bounces} + 1);
  }

  // Calls `task(begin, end, counts)` for parts of [0, count), on all threads.
  template <class Task>
  void in_parts(std::size_t count, const Task& task) {
    std::vector<LightCounts> counts((count + kChunk - 1) / kChunk);
    parallel_for(counts.size(), rules_.threads, [&](std::size_t i) {
      task(i * kChunk, std::min((i + 1) * kChunk, count), counts[i]);
    });
    for (const LightCounts& one : counts) light_.counts += one;
  }
  bool trace_round(std::uint64_t round) {
    for (std::size_t i = 0; i < scrambles_.size(); ++i) {
      now_ = &scrambles_[i];
      film_ = &light_.films[i];
      film_->take_room(light_.films[(i == 0 ? scrambles_.size() : i) - 1]);
      if (!trace_block(round)) return false;
    }
    return true;
  }

  // The rays of a scramble in a round.
  bool trace_block(std::uint64_t block) {
    emit(block);
    for (std::uint32_t bounces = 0; !rays_.empty(); ++bounces) {
      if (rules_.stop != nullptr && rules_.stop()) return false;
      choose_worlds(block, bounces);
      fly();
      if (walls_.bodies().absorb()) fade(block, bounces);
      film_->add(lines_, rules_.threads);
      scatter(block, bounces);
    }
    return true;
  }

  void emit(std::uint64_t block) {
    rays_.resize(now_->emission.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts& counts) {
      for (std::size_t i = begin; i < end; ++i) {
        LightRay& ray = rays_[i] = now_->emission.ray(block, static_cast<std::uint32_t>(i));
        counts.emitted += energy(ray.weight);
        gamble(ray, block, kEmitted, counts);
        if (walls_.sets_off(ray, beside_[now_->emission.lamp_of(ray.number)])) continue;
        counts.at_corners += energy(std::exchange(ray.weight, kDark));
      }
      counts.rays += end - begin;
    });
    drop_dark();
  }

  void drop_dark() {
    std::erase_if(rays_, [](const LightRay& ray) { return largest(ray.weight) == 0; });
  }

  // Where walls have alternatives, each ray gets a world, and they are put in order of them.
  void choose_worlds(std::uint64_t block, std::uint32_t bounces) {
    world_of_.resize(rays_.size());
    if (worlds_.size() == 1) return;
    const auto count = static_cast<double>(worlds_.size());
    places_.resize(rays_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts&) {
      for (std::size_t i = begin; i < end; ++i)
        places_[i] = static_cast<WallPlace>(
            count * random_number(Stream::alternative, block, rays_[i].number, bounces));
    });
    const std::vector<std::uint32_t> order = ascending_order(places_);
    next_.resize(rays_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts&) {
      for (std::size_t k = begin; k < end; ++k) {
        next_[k] = rays_[order[k]];
        world_of_[k] = static_cast<std::uint32_t>(places_[order[k]]);
      }
    });
    rays_.swap(next_);
  }

  // Takes every ray to its next wall, or out of the picture.
  void fly() {
    arrivals_.resize(rays_.size());
    lines_.resize(rays_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts& counts) {
      for (std::size_t i = begin, last = i; i < end; i = last) {
        while (last < end && world_of_[last] == world_of_[i]) ++last;
        worlds_[world_of_[i]]->fly(std::span<const LightRay>(rays_).subspan(i, last - i),
                                   std::span(arrivals_).subspan(i, last - i));
      }
      for (std::size_t i = begin; i < end; ++i) {
        const Ray& ray = rays_[i].ray;
        const Vec2 to = arrivals_[i].hit ? arrivals_[i].point : beyond_film(ray);
        lines_[i] = line(ray.origin, to, rays_[i].weight);
      }
      counts.legs += end - begin;
    });
  }

  // In bodies that absorb rays get fainter on their way. What falls on the film is added here; for the
  // others, lines_ are left.
  void fade(std::uint64_t block, std::uint32_t bounces) {
    std::vector<std::vector<LightLine>> pieces;
    for (std::size_t first = 0; first < rays_.size(); first += kFading) {
      const std::size_t count = std::min(kFading, rays_.size() - first);
      pieces.assign((count + kChunk - 1) / kChunk, {});
      in_parts(count, [&](std::size_t begin, std::size_t end, LightCounts& counts) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t number = rays_[first + i].number;
          const double shift = 1 - random_number(Stream::fading, block, number, bounces);
          fade(first + i, shift, pieces[begin / kChunk], counts);
        }
      });
      for (const std::vector<LightLine>& some : pieces) film_->add(some, rules_.threads);
    }
    std::erase_if(lines_, [](const LightLine& line) { return line.weight == kDark; });
  }

  // Cuts the flight of a ray into pieces of even weights, over which what fades fastest and has not yet
  // faded to 2^-12 loses a 16th at most; an 8th of a pixel is short enough. Where they are cut moves by
  // `shift` of a piece. With h the depth of a piece and e its end, the weight is exp(-e) h / (1 - exp(-h)):
  // over all shifts its mean at each depth x is exp(-x), up to both ends of the flight.
  void fade(std::size_t i, double shift, std::vector<LightLine>& pieces, LightCounts& counts) {
    LightRay& ray = rays_[i];
    const std::array<double, 3>& absorption = walls_.bodies().absorption_in(ray.media);
    if (!arrivals_[i].hit || absorption == std::array<double, 3>{0, 0, 0}) return;
    const Vec2 to = arrivals_[i].point, way = to - ray.ray.origin;
    const double length = arrivals_[i].hit.t, short_enough = 0.125 / place_.pixels_per_unit;
    const LightWeight first = ray.weight;
    Vec2 at = ray.ray.origin;
    double begin = 0;
    while (begin < length) {
      double fastest = 0;
      for (const double channel : absorption)
        if (begin < kFaded / channel) fastest = std::max(fastest, channel);
      const double until = std::min(length, kFaded / fastest);
      const double piece = std::max(kPiece / fastest, short_enough);
      std::array<double, 3> mean{};  // over a whole piece
      for (std::size_t c = 0; c < mean.size(); ++c) mean[c] = fading(absorption[c], piece).mean;
      for (double last = begin + shift * piece; begin < until; last += piece) {
        const double end = std::min(last, until);
        const Vec2 next = end < length ? Vec2(ray.ray.origin + end / length * way) : to;
        LightWeight weight{};
        for (std::size_t c = 0; c < weight.size(); ++c) {
          const double a = absorption[c];
          // Where it fades within a piece, which is short or dark, its mean.
          const double part = a * piece <= 2 * kPiece
                                  ? fading(a, last).left / mean[c]
                                  : fading(a, begin).left * fading(a, end - begin).mean;
          weight[c] = static_cast<float>(static_cast<double>(first[c]) * part);
        }
        // A line weighs 1 at most, and the first piece, shortened, more: twice the half of it.
        const int lines = largest(weight) > 1 ? 2 : 1;
        for (float& channel : weight) channel /= static_cast<float>(lines);
        for (int k = 0; k < lines; ++k) pieces.push_back(line(at, next, weight));
        at = next, begin = end;
      }
    }
    const std::array<double, 3> left = walls_.bodies().left_after(length, ray.media);
    for (std::size_t c = 0; c < left.size(); ++c) ray.weight[c] *= static_cast<float>(left[c]);
    counts.absorbed += energy(first) - energy(ray.weight);
    lines_[i].weight = kDark;
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
    next_.resize(std::max(next_.size(), order.size()));  // kept as long as the longest
    const auto scramble = static_cast<std::uint32_t>(
        random_bits(now_->seed, Stream::bounce, rules_.frame, block, bounces));
    const auto colours = static_cast<std::uint32_t>(
        random_bits(now_->seed, Stream::colour, rules_.frame, block, bounces));
    in_parts(order.size(), [&](std::size_t begin, std::size_t end, LightCounts& counts) {
      for (std::size_t k = begin; k < end; ++k) {
        if (k + kAhead < end) {  // the order goes to and fro in memory
          fetch(rays_[order[k + kAhead]]);
          fetch(arrivals_[order[k + kAhead]]);
        }
        const auto rank = static_cast<std::uint32_t>(k);
        const auto number = [&](Stream stream) {
          if (rules_.light.sampler == LightSampler::random)
            return random_number(stream, block, rays_[order[k]].number, bounces);
          return stream == Stream::colour ? net_number(rank, 1, colours)
                                          : net_number(rank, 0, scramble);
        };
        next_[k] = scattered(order[k], bounces, number, counts);
        gamble(next_[k], block, bounces, counts);
      }
    });
    rays_.swap(next_);
    rays_.resize(order.size());
    drop_dark();
  }

  // What is longer than a line of the cache may lie in two.
  template <class T>
  static void fetch(const T& thing) {
    const auto* const bytes = reinterpret_cast<const char*>(&thing);
    __builtin_prefetch(bytes);
    __builtin_prefetch(bytes + sizeof(T) - 1);
  }

  double random_number(Stream stream, std::uint64_t block, std::uint32_t number,
                       std::uint32_t bounces) const {
    const std::uint64_t item = block * now_->emission.size() + number;
    const auto high = static_cast<std::uint32_t>(item >> 32);
    return unit_double(random_bits(now_->seed, stream, rules_.frame, item, bounces + (high << 20)));
  }

  std::vector<std::uint32_t> order_of_arrival() {
    places_.resize(rays_.size());
    in_parts(rays_.size(), [&](std::size_t begin, std::size_t end, LightCounts&) {
      for (std::size_t i = begin; i < end; ++i)
        places_[i] = rules_.light.sampler == LightSampler::sorted ? place_of(i) : i;
    });
    return ascending_order(places_);
  }

  WallPlace place_of(std::size_t i) const {
    const LightHit& arrival = arrivals_[i];
    if (!arrival.hit) return ~WallPlace{0};
    return wall_place(worlds_[world_of_[i]]->walls(), arrival.hit.surface, arrival.point);
  }

  // The ray that goes on, or one of weight 0. number(stream): what chance decides, in [0, 1).
  template <class Number>
  LightRay scattered(std::size_t i, std::uint32_t bounces, const Number& number,
                     LightCounts& counts) const {
    const LightRay& ray = rays_[i];
    const LightHit& arrival = arrivals_[i];
    const LitWalls& walls = *worlds_[world_of_[i]];
    const auto ends = [&](std::int64_t& where, std::int64_t with) {
      where += with;
      return LightRay{ray.ray, {}, {0, 0, 0}, ray.number};
    };
    if (!arrival.hit) return ends(counts.escaped, energy(ray.weight));
    if (arrival.in_corner)
      return ends(walls.all_absorb(ray, arrival) ? counts.absorbed : counts.at_corners,
                  energy(ray.weight));
    LightRay next = ray;
    if (ray.nm == 0 && walls.bodies().disperse_at(arrival.hit.surface, ray.media))
      take_wavelength(next, number(Stream::colour), counts);
    const Departure departure =
        walls.depart(arrival, walls.arrival(next, arrival), number(Stream::bounce));
    const std::int64_t left = energy(next.weight);
    if (departure.way == Departure::Way::absorbed) return ends(counts.absorbed, left);
    if (bounces == rules_.light.bounces || !walls.leaves(next, arrival, departure))
      return ends(counts.cut_off, left);
    for (std::size_t c = 0; c < 3; ++c) next.weight[c] *= departure.tint[c];
    counts.absorbed += left - energy(next.weight);
    return next;
  }

  // From then on the light is of one colour, by chance.
  void take_wavelength(LightRay& ray, double u, LightCounts& counts) const {
    const std::int64_t before = energy(ray.weight);
    const auto [nm, part] = now_->emission.part(ray.number, u);
    ray.nm = static_cast<float>(nm);
    for (std::size_t c = 0; c < 3; ++c) ray.weight[c] *= static_cast<float>(part[c]);
    FLATRAY_DCHECK(largest(ray.weight) <= 1);
    counts.gambled += before - energy(ray.weight);
  }

  // Faint rays go on with the chance of their weight, and are then three times as bright as the
  // faintest that is let be.
  void gamble(LightRay& ray, std::uint64_t block, std::uint32_t bounces,
              LightCounts& counts) const {
    const float brightest = largest(ray.weight);
    if (brightest >= faint_ || brightest == 0) return;
    const std::int64_t before = energy(ray.weight);
    const float chance = brightest / (3 * faint_);
    const bool goes_on =
        random_number(Stream::roulette, block, ray.number, bounces) < static_cast<double>(chance);
    for (float& channel : ray.weight) channel = goes_on ? channel / chance : 0;
    counts.gambled += before - energy(ray.weight);
  }

  static Bounds world_size(const FilmPlace& place) {
    const Vec2 size = Vec2(place.width, place.height) / place.pixels_per_unit;
    return {{place.left, place.top - size.y()}, {place.left + size.x(), place.top}};
  }

  static constexpr LightWeight kDark{0, 0, 0};
  static constexpr double kPiece = 0x1p-4, kFaded = 8.5;     // depths; that of 2^-12 is 8.3
  static constexpr std::size_t kFading = 4 * kChunk;         // rays that are cut at once
  static constexpr std::uint32_t kEmitted = (1U << 20) - 1;  // no number of bounces

  using Worlds = std::vector<std::unique_ptr<const LitWalls>>;
  static Worlds ready(std::span<const World> worlds, std::span<const Scatterer* const> scatterers,
                      const Tracer* tracer) {
    Worlds made;
    for (const World& world : worlds)
      made.push_back(std::make_unique<const LitWalls>(world, scatterers, tracer));
    return made;
  }

  const Worlds worlds_;    // one, or those of alternatives, whose surfaces have the same numbers
  const LitWalls& walls_;  // of the first
  const FilmPlace& place_;
  const LightRules& rules_;
  const std::vector<Scramble> scrambles_;
  // What is to have one wavelength must stay as dark as light that has just set off.
  const float faint_ =
      walls_.bodies().disperse() ? 0.1F / static_cast<float>(kMostOfWavelength) : 0.1F;
  const Bounds size_;
  const std::vector<WallsBeside> beside_;  // by lamp
  TracedLight light_;
  const Scramble* now_ = nullptr;  // the one that is traced, and its film
  LightFilm* film_ = nullptr;
  LargeVector<LightRay> rays_, next_;  // under way, and after a bounce
  LargeVector<LightHit> arrivals_;
  LargeVector<LightLine> lines_;
  LargeVector<WallPlace> places_;
  std::vector<std::uint32_t> world_of_;  // by ray
};

}  // namespace

TracedLight trace_light(std::span<const World> worlds, std::span<const Scatterer* const> scatterers,
                        std::span<const LampState> lamps, const FilmPlace& place,
                        const LightRules& rules, TracedLight light, const NextRound& next) {
  return Forward(worlds, scatterers, lamps, place, rules).trace(std::move(light), next);
}

}  // namespace flatray
