#include "collide/instant.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace flatray {
namespace {

// Of both masses in units of the lighter, rounded down to a power of two: only their ratio counts, and
// none that matters is lost.
std::pair<double, double> inverse_masses(double a, double b) {
  const double lighter = std::min(a, b);
  if (lighter == kInfinity) return {0, 0};
  const int exponent = -std::ilogb(lighter);
  return {1 / std::ldexp(a, exponent), 1 / std::ldexp(b, exponent)};
}

// Orders velocities by their speed; of equal ones as numbers, so that it is an order of all.
bool is_slower(const Vec2& a, const Vec2& b) {
  const auto key = [](const Vec2& v) { return std::tuple(v.squaredNorm(), v.x(), v.y()); };
  return key(a) < key(b);
}

// An order that bodies have no part in, and that keeps those together that are near.
auto order_of(const Touch& touch) {
  const auto& [point, normal] = touch.place;
  return std::tuple(point.x(), point.y(), std::fabs(normal.x()), std::fabs(normal.y()));
}

}  // namespace

bool Instants::does(std::uint32_t body, Response response) const {
  const bool of_all = response == Response::mark || response == Response::remove;
  return bodies_[body].response == response && (of_all || !is_fixed(body));
}

Instants::Player Instants::player(std::uint32_t body, bool hit) const {
  const bool wall = does(body, Response::stop) || does(body, Response::remove);
  double mass = bodies_[body].mass;
  if (wall) mass = kInfinity;
  return {stages_[body].back().velocity, mass, hit, body};
}

std::optional<Changes> Instants::respond(std::span<const Hit> hits, double time) {
  Players players;
  for (const Hit& hit : hits)
    if (!is_mark(hit.pair))
      for (const std::uint32_t body : {hit.pair.first, hit.pair.second})
        players.insert_or_assign(body, player(body, true));
  if (!stop(hits, players, time)) return std::nullopt;
  std::vector<Push> pushes = pushes_of(hits, players);
  add_resting(pushes, players, time);
  if (!resolve(pushes, players, time)) return std::nullopt;
  Changes changes;
  for (const auto& [body, player] : players) {
    const bool gone = player.hit && does(body, Response::remove);
    if (!gone &&
        (is_fixed(body) || (!player.hit && player.velocity == stages_[body].back().velocity)))
      continue;
    changes[body] = {gone ? Vec2(0, 0) : player.velocity, gone};
    // What rests on a wall is not asked when that goes.
    if (player.wall())
      for (const Resting& resting : std::vector(resting_[body])) forget(resting.touch);
  }
  return changes;
}

// What stops stands still, or goes with the fastest of those that hold it and that nothing moves.
// Whether none of these comes nearer all the same.
bool Instants::stop(std::span<const Hit> hits, Players& players, double time) {
  for (const Hit& hit : hits)
    for (const auto& [body, other] : {hit.pair, IndexPair(hit.pair.second, hit.pair.first)})
      if (!is_mark(hit.pair) && does(body, Response::stop) && is_fixed(other))
        held_[body].push_back({hit.touches.front(), time});
  for (auto& [body, player] : players) {
    if (!does(body, Response::stop)) continue;
    const auto velocity = [&, stopped = body](std::uint32_t k) -> const Vec2& {
      return k == stopped ? players.at(k).velocity : stages_[k].back().velocity;
    };
    const auto wall = [stopped = body](const Resting& by) {
      return by.touch.pair.first == stopped ? by.touch.pair.second : by.touch.pair.first;
    };
    std::erase_if(held_[body], [&, &own = player.velocity](const Resting& by) {
      return by.since != time && velocity(wall(by)) != own;
    });
    player.velocity = {0, 0};
    for (const Resting& by : held_[body])
      player.velocity = std::max(player.velocity, velocity(wall(by)), is_slower);
    for (const auto& [touch, since] : held_[body]) {
      const Vec2 &normal = touch.place.normal, &a = velocity(touch.pair.first),
                 &b = velocity(touch.pair.second);
      if (approach(normal, a, b) && !is_gentle(normal, a - b, {0, 0})) return false;
    }
  }
  return true;
}

std::vector<Instants::Push> Instants::pushes_of(std::span<const Hit> hits,
                                                const Players& players) const {
  std::vector<Push> pushes;
  for (const Hit& hit : hits) {
    const auto [a, b] = hit.pair;
    if (is_mark(hit.pair) || (players.at(a).wall() && players.at(b).wall())) continue;
    const bool slides = does(a, Response::slide) || does(b, Response::slide);
    for (const Touch& touch : hit.touches) pushes.push_back({touch, slides});
  }
  return pushes;
}

// What rests on those that are pushed is pushed, too.
void Instants::add_resting(std::vector<Push>& pushes, Players& players, double time) {
  std::vector<std::uint32_t> reached;
  for (const auto& [body, player] : players) reached.push_back(body);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (players.at(reached[i]).wall()) continue;
    for (const Resting& resting : std::vector(resting_[reached[i]])) {
      const Touch& touch = resting.touch;
      if (std::ranges::any_of(pushes,
                              [&](const Push& push) { return push.touch.is_of_parts(touch); }))
        continue;
      if (!still_rests(resting, time)) {
        forget(touch);
        continue;
      }
      pushes.push_back({touch, true});
      for (const std::uint32_t body : {touch.pair.first, touch.pair.second})
        if (players.emplace(body, player(body, false)).second) reached.push_back(body);
    }
  }
}

bool Instants::still_rests(const Resting& resting, double time) const {
  const auto& [touch, since] = resting;
  const Stage &a = stages_[touch.pair.first].back(), &b = stages_[touch.pair.second].back();
  if (a.gone || b.gone) return false;
  return since == time || a.velocity == b.velocity || pairs_.face(touch, time);
}

// Those that push each other together, whatever goes on elsewhere.
bool Instants::resolve(std::span<const Push> pushes, Players& players, double time) {
  const auto of_push = [&](const Push& push) -> std::pair<Player&, Player&> {
    return {players.at(push.touch.pair.first), players.at(push.touch.pair.second)};
  };
  for (const Push& push : pushes) {
    const auto [a, b] = of_push(push);
    if (a.wall() || b.wall() || a.cluster == b.cluster) continue;
    const auto [low, high] = std::minmax({a.cluster, b.cluster});
    for (auto& [body, player] : players)
      if (player.cluster == high) player.cluster = low;
  }
  std::map<std::uint32_t, std::vector<Push>> clusters;
  for (const Push& push : pushes) {
    const auto [a, b] = of_push(push);
    clusters[a.wall() ? b.cluster : a.cluster].push_back(push);
  }
  for (auto& [body, together] : clusters) {
    std::ranges::sort(together, {}, [](const Push& push) { return order_of(push.touch); });
    if (together.size() == 1 && !together.front().slides)
      bounce(together.front().touch, players);
    else if (!push_together(together, players, time))
      return false;
  }
  return true;
}

// One bounce alone, as the formula has it.
void Instants::bounce(const Touch& touch, Players& players) const {
  const auto [a, b] = touch.pair;
  Player &one = players.at(a), &other = players.at(b);
  const Vec2& normal = touch.place.normal;
  const double speed = normal.dot(one.velocity - other.velocity);
  if (!(speed > 0)) return;  // one has stopped, or they glide and the normal is rounded
  const auto [inverse_a, inverse_b] = inverse_masses(one.mass, other.mass);
  const double thrust = 2 * speed / (inverse_a + inverse_b);
  one.velocity -= thrust * inverse_a * normal;
  other.velocity += thrust * inverse_b * normal;
}

bool Instants::push_together(std::span<const Push> pushes, Players& players, double time) {
  std::map<std::uint32_t, std::uint32_t> numbers;
  std::vector<ImpactBody> bodies;
  std::vector<ImpactContact> contacts;
  const auto number = [&](std::uint32_t body) {
    const auto [at, is_new] = numbers.emplace(body, static_cast<std::uint32_t>(bodies.size()));
    const Player& player = players.at(body);
    if (is_new) bodies.push_back({player.velocity, player.mass});
    return at->second;
  };
  for (const auto& [touch, slides] : pushes)
    contacts.push_back(
        {number(touch.pair.first), number(touch.pair.second), touch.place.normal, slides});
  const std::optional<Impact> impact = solve_impact(bodies, contacts);
  if (!impact) return false;
  if (impact->refused) {
    crowd_ = contacts.size();
    return false;
  }
  for (const auto& [body, at] : numbers)
    if (!players.at(body).wall()) players.at(body).velocity = impact->velocities[at];
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    const Touch& touch = pushes[i].touch;
    forget(touch);
    if (!impact->rests[i]) continue;
    for (const std::uint32_t body : {touch.pair.first, touch.pair.second})
      resting_[body].push_back({touch, time});
  }
  return true;
}

void Instants::forget(const Touch& touch) {
  for (const std::uint32_t body : {touch.pair.first, touch.pair.second})
    std::erase_if(resting_[body],
                  [&](const Resting& other) { return other.touch.is_of_parts(touch); });
}

}  // namespace flatray
