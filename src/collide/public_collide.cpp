#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "collide/contact_batch.h"
#include "flatray/collide.h"
#include "trace/plain_arrays.h"

namespace flatray::api {
namespace {

// Of two vertices none.
ContactFeature feature_of(const flatray::ContactFeature& feature) {
  if (feature.edge == kNoEdge) return {};
  return {feature.edge_of_a, feature.edge, feature.vertex};
}

Contact contact_of(const flatray::Contact& met) {
  const HitInterval& times = met.times;
  return {times.t_enter,
          times.t_exit,
          static_cast<HitClass>(times.kind),
          static_cast<StartPlace>(times.start),
          times.enter_overflows,
          times.exit_overflows,
          feature_of(met.first),
          feature_of(met.last)};
}

flatray::MovingPair moving(const MovingPair& pair) {
  return {
      pair.a, pair.b, {pair.velocity_ax, pair.velocity_ay}, {pair.velocity_bx, pair.velocity_by}};
}

}  // namespace

struct Bodies::Data {
  BodySet set;
};

Bodies::Bodies() = default;
Bodies::Bodies(Bodies&&) noexcept = default;
Bodies& Bodies::operator=(Bodies&&) noexcept = default;
Bodies::~Bodies() = default;

std::size_t Bodies::size() const { return data_ ? data_->set.size() : 0; }

Status Bodies::add_polygon(Column x, Column y, double radius) {
  if (const Status fault = check_convex(x, y); !fault) return fault;
  if (!std::isfinite(radius)) return {Fault::not_finite, 0};
  if (radius < 0) return {Fault::radius, 0};
  if (size() == kNoWall) return {Fault::full, 0};
  if (!data_) data_ = Owned<Data>(new Data);
  data_->set.add(points_of(x, y), radius);
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
    data_->set.add(std::span(&centre, 1), radius[i]);
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
  if (pairs.empty()) return {};
  std::vector<flatray::MovingPair> asked;
  std::transform(pairs.begin(), pairs.end(), std::back_inserter(asked), moving);
  std::vector<flatray::Contact> found(pairs.size());
  flatray::contacts(data_->set, asked, {within.low, within.high}, found);
  std::transform(found.begin(), found.end(), contacts.begin(), contact_of);
  return {};
}

}  // namespace flatray::api
