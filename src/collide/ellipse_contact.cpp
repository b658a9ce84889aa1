#include "collide/ellipse_contact.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "base/portable_math.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

constexpr double kWhole = 2 * std::numbers::pi;
constexpr int kFirstCorners = 16, kFiner = 4, kMostRounds = 24;
// More than a corner is rounded by, as a part of what it adds up.
constexpr double kRounding = 0x1p-45;

// Polygons about and in an ellipse, which touch it at chosen angles of u and v.
class Sandwich {
 public:
  explicit Sandwich(const CurvedBody& body) : body_(body) {
    if (!body.curve) return;
    const Ellipse& curve = *body.curve;
    const double long_axis = std::sqrt(curve.u.squaredNorm() + curve.v.squaredNorm());
    const double short_axis = std::fabs(cross(curve.u, curve.v)) / long_axis;
    const double rounding =
        kRounding * (curve.centre.lpNorm<1>() + curve.u.lpNorm<1>() + curve.v.lpNorm<1>());
    room_ = rounding / short_axis;
    finest_ = 8 * std::sqrt(room_);
    for (int i = 0; i < kFirstCorners; ++i) angles_.push_back(kWhole * i / kFirstCorners);
    width_ = kWhole / kFirstCorners;
  }

  RoundBody inner(Ring& ring) const {
    if (!body_.curve) return body_.round;
    ring.clear();
    for (const double angle : angles_) ring.push_back(corner(angle, 1 - room_));
    return {{ring, body_.round.core.velocity}, 0};
  }
  RoundBody outer(Ring& ring) const {
    if (!body_.curve) return body_.round;
    ring.clear();
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      const double from = angles_[i],
                   to = i + 1 < angles_.size() ? angles_[i + 1] : angles_[0] + kWhole;
      ring.push_back(corner(0.5 * (from + to), (1 + room_) / portable::cos(0.5 * (to - from))));
    }
    return {{ring, body_.round.core.velocity}, 0};
  }

  // Whether rounding leaves anything of it.
  bool is_sound() const { return !body_.curve || room_ < 0x1p-10; }

  // More corners where it is farthest along some directions; whether there is room for them.
  bool refine(const std::vector<Vec2>& directions) {
    if (!body_.curve || !(width_ / kFiner > finest_) || directions.empty()) return false;
    const Ellipse& curve = *body_.curve;
    for (const Vec2& n : directions) {
      const double middle = portable::atan2(n.dot(curve.v), n.dot(curve.u));
      for (int i = -2 * kFiner; i <= 2 * kFiner; ++i) add(middle + i * width_ / kFiner);
    }
    width_ /= kFiner;
    std::sort(angles_.begin(), angles_.end());
    return true;
  }

 private:
  Vec2 corner(double angle, double scale) const {
    const Ellipse& curve = *body_.curve;
    return curve.centre + scale * (portable::cos(angle) * curve.u + portable::sin(angle) * curve.v);
  }
  // Not too near another, so that rounding leaves the polygon convex.
  void add(double angle) {
    if (angle < 0) angle += kWhole;
    if (angle >= kWhole) angle -= kWhole;
    for (const double other : angles_) {
      const double apart = std::fabs(angle - other);
      if (std::min(apart, kWhole - apart) < width_ / (2 * kFiner)) return;
    }
    angles_.push_back(angle);
  }

  const CurvedBody& body_;
  double room_ = 0, finest_ = 0;  // of the half-diameters; the least step of angles
  double width_ = 0;              // of the steps so far
  std::vector<double> angles_;    // ascending
};

bool is_convex(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  Sign sense = Sign::zero;
  for (std::size_t i = 0; n > 2 && i < n; ++i) {
    const Sign turn = orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]);
    if (turn == Sign::zero || (sense != Sign::zero && turn != sense)) return false;
    sense = turn;
  }
  return true;
}

class Search {
 public:
  Search(const CurvedBody& a, const CurvedBody& b, Range within)
      : a_(a), b_(b), is_curve_a_(a.curve), is_curve_b_(b.curve), within_(within) {
    found_.verdict = CurvedContact::Verdict::undecided;
    found_.enter = found_.exit = within;
    found_.start = StartPlace::boundary;
  }

  CurvedContact run() {
    for (int round = 0; round < kMostRounds; ++round) {
      const std::vector<Vec2> normals = look();
      if (!sound_ || found_.verdict == CurvedContact::Verdict::apart) break;
      std::vector<Vec2> back;
      back.reserve(normals.size());
      for (const Vec2& n : normals) back.push_back(-n);
      const bool finer_a = a_.refine(normals), finer_b = b_.refine(back);
      if (!finer_a && !finer_b) break;
    }
    return found_;
  }

 private:
  // The normals where the outer polygons first and last meet.
  std::vector<Vec2> look() {
    sound_ = a_.is_sound() && b_.is_sound();
    if (!sound_) return {};
    Ring ring_a, ring_b, inner_a, inner_b;
    const RoundBody outer[] = {a_.outer(ring_a), b_.outer(ring_b)};
    const RoundBody inner[] = {a_.inner(inner_a), b_.inner(inner_b)};
    sound_ = (!is_curve_a_ || (is_convex(ring_a) && is_convex(inner_a))) &&
             (!is_curve_b_ || (is_convex(ring_b) && is_convex(inner_b)));
    if (!sound_) return {};
    const RoundContact wide = round_contact(outer[0], outer[1], within_);
    const RoundContact narrow = round_contact(inner[0], inner[1], within_);
    tell(wide, narrow, outer[0], outer[1]);
    std::vector<Vec2> normals;
    if (!wide.times) return normals;
    if (wide.first)
      normals.push_back(place_at(*wide.first, outer[0], outer[1], wide.times.t_enter).normal);
    if (wide.last)
      normals.push_back(place_at(*wide.last, outer[0], outer[1], wide.times.t_exit).normal);
    return normals;
  }

  void tell(const RoundContact& wide, const RoundContact& narrow, const RoundBody& a,
            const RoundBody& b) {
    using Verdict = CurvedContact::Verdict;
    const HitInterval &out = wide.times, &in = narrow.times;
    found_.start = in.start == StartPlace::inside     ? StartPlace::inside
                   : out.start == StartPlace::outside ? StartPlace::outside
                                                      : StartPlace::boundary;
    found_.verdict = !out ? Verdict::apart : in ? Verdict::meets : Verdict::undecided;
    if (!out) return;
    found_.enter = {out.t_enter, in ? std::max(in.t_enter, out.t_enter) : out.t_exit};
    found_.exit = {in ? std::min(in.t_exit, out.t_exit) : out.t_enter, out.t_exit};
    found_.place =
        wide.first ? place_at(*wide.first, a, b, out.t_enter) : resting_place(a, b, out.t_enter);
  }

  Sandwich a_, b_;
  const bool is_curve_a_, is_curve_b_;
  const Range within_;
  bool sound_ = true;
  CurvedContact found_;
};

// Lengths times a power of two, where that is exact: times stay, and squares neither overflow nor are
// lost.
class ScaledBody {
 public:
  ScaledBody(const CurvedBody& body, int exponent) : exponent_(exponent) {
    if (body.curve)
      body_.curve =
          Ellipse{scaled(body.curve->centre), scaled(body.curve->u), scaled(body.curve->v)};
    for (const Vec2& p : body.round.core.vertices) ring_.push_back(scaled(p));
    body_.round = {{ring_, scaled(body.round.core.velocity)}, scaled(body.round.radius)};
  }
  ScaledBody(const ScaledBody&) = delete;

  const CurvedBody& body() const { return body_; }
  bool is_exact() const { return exact_; }

 private:
  double scaled(double x) {
    const double there = std::ldexp(x, exponent_);
    exact_ = exact_ && std::ldexp(there, -exponent_) == x;
    return there;
  }
  Vec2 scaled(const Vec2& v) { return {scaled(v.x()), scaled(v.y())}; }

  const int exponent_;
  Ring ring_;
  CurvedBody body_;
  bool exact_ = true;
};

double largest_axis(const CurvedBody& body) {
  if (!body.curve) return 0;
  return std::max(body.curve->u.cwiseAbs().maxCoeff(), body.curve->v.cwiseAbs().maxCoeff());
}

}  // namespace

CurvedContact curved_contact(const CurvedBody& a, const CurvedBody& b, Range within) {
  constexpr int kUsual = 400;
  const int exponent = -std::ilogb(std::max(largest_axis(a), largest_axis(b)));
  if (std::abs(exponent) <= kUsual) return Search(a, b, within).run();
  const ScaledBody one(a, exponent), other(b, exponent);
  if (!one.is_exact() || !other.is_exact()) return Search(a, b, within).run();
  CurvedContact found = Search(one.body(), other.body(), within).run();
  const Vec2& point = found.place.point;
  found.place.point = {std::ldexp(point.x(), -exponent), std::ldexp(point.y(), -exponent)};
  return found;
}

}  // namespace flatray
