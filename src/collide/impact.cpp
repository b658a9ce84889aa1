#include "collide/impact.h"

#include <algorithm>
#include <utility>

#include "collide/complementarity.h"
#include "geom/pair.h"
#include "geom/ray.h"

namespace flatray {
namespace {

// Which way a push along the normal of a contact drives a body.
int side_of(const ImpactContact& contact, std::uint32_t body) {
  return contact.b == body ? 1 : contact.a == body ? -1 : 0;
}

// Whether two do not come nearer to each other, whatever rounding made of normal and velocities.
bool certainly_rest(const Vec2& a, const Vec2& b, const Vec2& normal) {
  return (normal.x() == 0 || a.x() == b.x()) && (normal.y() == 0 || a.y() == b.y());
}

template <class Number>
class Solver {
 public:
  Solver(std::span<const ImpactBody> bodies, std::span<const ImpactContact> contacts)
      : bodies_(bodies), contacts_(contacts) {
    double lightest = kInfinity;  // only the ratio counts
    for (const ImpactBody& body : bodies) lightest = std::min(lightest, body.mass);
    for (const ImpactBody& body : bodies) {
      velocities_.push_back(numbers(body.velocity));
      inverse_.push_back(body.mass == kInfinity ? Number(0) : Number(lightest) / Number(body.mass));
    }
    for (const ImpactContact& contact : contacts) normals_.push_back(numbers(contact.normal));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto& [a, b, normal, slides] = contacts[i];
      parting_.push_back(dot(normals_[i], velocities_[b] - velocities_[a]));
      if (slides || parting_[i] < Number(0)) asked_.push_back(i);
    }
    couple();
  }

  const Couplings<Number>& couplings() const { return couplings_; }

  // All that slides and does not come to rest in doubles leaves, and what that makes leave.
  std::optional<Impact> solve() const {
    double fastest = 0;
    for (const ImpactBody& body : bodies_)
      fastest = std::max(fastest, body.velocity.cwiseAbs().maxCoeff());
    std::vector<double> leaves(contacts_.size(), 0);
    std::optional<Impact> impact = solve(leaves), apart = impact;
    while (apart && !apart->refused) {  // else there is room for those at rest only
      impact = std::exchange(apart, std::nullopt);
      bool more = false;
      for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const auto& [a, b, normal, slides] = contacts_[i];
        if (!impact->rests[i] || leaves[i] > 0 ||
            certainly_rest(impact->velocities[a], impact->velocities[b], normal))
          continue;
        leaves[i] = kSlideLeaves * fastest * normal.norm();
        more |= leaves[i] > 0;
      }
      if (more) apart = solve(leaves);
    }
    return impact;
  }

 private:
  // Those that slide leave at a speed each, times the length of the normal.
  std::optional<Impact> solve(std::span<const double> leaves) const {
    std::vector<Number> lack;
    for (const std::size_t i : asked_)
      lack.push_back(contacts_[i].slides ? parting_[i] - Number(leaves[i])
                                         : parting_[i] + parting_[i]);
    const auto pushes = solve_complementarity(couplings_, lack);
    if (!pushes) return std::nullopt;
    if (pushes->refused) return Impact{{}, {}, true};
    Impact impact{{}, std::vector<bool>(contacts_.size(), false)};
    std::vector<Pair<Number>> velocities = velocities_;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const ImpactContact& contact = contacts_[asked_[i]];
      impact.rests[asked_[i]] = contact.slides && pushes->touches[i];
      for (const std::uint32_t body : {contact.a, contact.b})
        velocities[body] =
            velocities[body] +
            (Number(side_of(contact, body)) * pushes->z[i] * inverse_[body]) * normals_[asked_[i]];
    }
    for (const auto& velocity : velocities)
      impact.velocities.emplace_back(nearest(velocity.x), nearest(velocity.y));
    return impact;
  }

  static Pair<Number> numbers(const Vec2& v) {
    return pair_of([](double x) { return Number(x); }, v);
  }

  // How fast a push in one contact makes those of another part, for all that share a body.
  void couple() {
    std::vector<std::vector<std::size_t>> of_body(bodies_.size());
    for (std::size_t i = 0; i < asked_.size(); ++i)
      for (const std::uint32_t body : {contacts_[asked_[i]].a, contacts_[asked_[i]].b})
        if (inverse_[body] != Number(0)) of_body[body].push_back(i);
    couplings_.resize(asked_.size());
    std::vector<std::size_t> seen(asked_.size(), asked_.size());  // by which contact last
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const ImpactContact& contact = contacts_[asked_[i]];
      std::vector<std::size_t> others{i};
      seen[i] = i;
      for (const std::uint32_t body : {contact.a, contact.b})
        for (const std::size_t k : of_body[body])
          if (std::exchange(seen[k], i) != i) others.push_back(k);
      for (const std::size_t k : others)
        couplings_[i].emplace_back(k, coupling(asked_[i], asked_[k]));
    }
  }

  Number coupling(std::size_t i, std::size_t k) const {
    Number sum(0);
    for (const std::uint32_t body : {contacts_[i].a, contacts_[i].b})
      if (const int sides = side_of(contacts_[i], body) * side_of(contacts_[k], body); sides != 0)
        sum += Number(sides) * inverse_[body];
    return sum * dot(normals_[i], normals_[k]);
  }

  const std::span<const ImpactBody> bodies_;
  const std::span<const ImpactContact> contacts_;
  std::vector<Pair<Number>> velocities_, normals_;
  std::vector<Number> inverse_, parting_;
  std::vector<std::size_t> asked_;
  Couplings<Number> couplings_;
};

// How many bits an entry of the couplings has, at most.
double bits_of(std::span<const ImpactBody> bodies, std::span<const ImpactContact> contacts) {
  std::size_t masses = 0, normals = 0;
  for (const ImpactBody& body : bodies)
    if (body.mass < kInfinity) masses = std::max(masses, Rational(body.mass).bits());
  for (const ImpactContact& contact : contacts)
    for (const double share : contact.normal) normals = std::max(normals, Rational(share).bits());
  return static_cast<double>(2 * (masses + normals));
}

}  // namespace

std::optional<Impact> solve_impact(std::span<const ImpactBody> bodies,
                                   std::span<const ImpactContact> contacts) {
  const Solver<double> near(bodies, contacts);
  const std::size_t count = near.couplings().size();
  if (count > kMostProven || work_of_proof(near.couplings(), bits_of(bodies, contacts)) > kMostWork)
    if (auto impact = near.solve()) return impact;
  return Solver<Rational>(bodies, contacts).solve();
}

}  // namespace flatray
