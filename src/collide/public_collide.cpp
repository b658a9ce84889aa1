#include <cmath>
#include <vector>

#include "collide/contact_batch.h"
#include "collide/round_contact.h"
#include "flatray/collide.h"
#include "trace/plain_arrays.h"

namespace flatray::api {
namespace {

ContactFeature feature_of(const flatray::ContactFeature& feature) {
  return {feature.edge_of_a, feature.edge, feature.vertex};
}

Contact contact_of(const HitInterval& times, const flatray::ContactFeature& first = {},
                   const flatray::ContactFeature& last = {}) {
  return {times.t_enter,
          times.t_exit,
          static_cast<Meeting>(times.kind),
          static_cast<Place>(times.start),
          times.enter_overflows,
          times.exit_overflows,
          feature_of(first),
          feature_of(last)};
}

Status check_radius(double radius) {
  if (!std::isfinite(radius)) return {Fault::not_finite, 0};
  return radius < 0 ? Status{Fault::radius, 0} : Status{};
}

flatray::MovingPair moving(const MovingPair& pair) {
  return {
      pair.a, pair.b, {pair.velocity_ax, pair.velocity_ay}, {pair.velocity_bx, pair.velocity_by}};
}

}  // namespace

struct Bodies::Data {
  PolygonSet cores;
  std::vector<double> radii;

  void add(std::span<const Vec2> ring, double radius) {
    radii.reserve(radii.size() + 1);
    cores.add(ring);
    radii.push_back(radius);
  }
  bool is_round(const flatray::MovingPair& pair) const {
    return radii[pair.a] > 0 || radii[pair.b] > 0;
  }
  RoundBody body(std::uint32_t number, const Vec2& velocity) const {
    return {{cores.ring(number), velocity}, radii[number]};
  }
};

Bodies::Bodies() = default;
Bodies::Bodies(Bodies&&) noexcept = default;
Bodies& Bodies::operator=(Bodies&&) noexcept = default;
Bodies::~Bodies() = default;

std::size_t Bodies::size() const { return data_ ? data_->radii.size() : 0; }

Status Bodies::add_polygon(Column x, Column y, double radius) {
  if (const Status fault = check_convex(x, y); !fault) return fault;
  if (const Status fault = check_radius(radius); !fault) return fault;
  if (size() == kNoWall) return {Fault::full, 0};
  if (!data_) data_ = Owned<Data>(new Data);
  data_->add(points_of(x, y), radius);
  return {};
}

Status Bodies::add_discs(Column x, Column y, Column radius) {
  if (const Status fault = check_columns({x, y, radius}); !fault) return fault;
  for (std::size_t i = 0; i < radius.size(); ++i)
    if (radius[i] < 0) return {Fault::radius, i};
  if (x.size() > kNoWall - size()) return {Fault::full, 0};
  if (!data_) data_ = Owned<Data>(new Data);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec2 centre(x[i], y[i]);
    data_->add(std::span(&centre, 1), radius[i]);
  }
  return {};
}

Status Bodies::contacts(std::span<const MovingPair> pairs, Range within,
                        std::span<Contact> contacts) const {
  if (contacts.size() != pairs.size()) return {Fault::sizes, 0};
  if (const Status fault = check_range(within); !fault) return fault;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const MovingPair& pair = pairs[i];
    if (pair.a >= size() || pair.b >= size()) return {Fault::no_such, i};
    for (const double v : {pair.velocity_ax, pair.velocity_ay, pair.velocity_bx, pair.velocity_by})
      if (!std::isfinite(v)) return {Fault::not_finite, i};
  }
  const flatray::Range range{within.low, within.high};
  std::vector<flatray::MovingPair> sharp;
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const flatray::MovingPair pair = moving(pairs[i]);
    if (data_->is_round(pair)) {
      contacts[i] = contact_of(round_contact(data_->body(pair.a, pair.velocity_a),
                                             data_->body(pair.b, pair.velocity_b), range)
                                   .times);
    } else {
      sharp.push_back(pair);
      place.push_back(i);
    }
  }
  std::vector<flatray::Contact> found(sharp.size());
  if (!sharp.empty()) flatray::contacts(data_->cores, sharp, range, found);
  for (std::size_t i = 0; i < found.size(); ++i)
    contacts[place[i]] = contact_of(found[i].times, found[i].first, found[i].last);
  return {};
}

}  // namespace flatray::api
