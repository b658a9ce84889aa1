#include "collide/ellipse_contact.h"

#include <algorithm>
#include <vector>

#include "collide/sandwich.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;

constexpr int kMostRounds = 24;

class Search {
 public:
  Search(const CurvedBody& a, const CurvedBody& b, Range within)
      : body_a_(a),
        body_b_(b),
        a_(a.round.core.vertices, a.curve),
        b_(b.round.core.vertices, b.curve),
        within_(within) {
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
    const auto body = [](std::span<const Vec2> ring, const CurvedBody& of) {
      return RoundBody{{ring, of.round.core.velocity}, of.curve ? 0 : of.round.radius};
    };
    const RoundBody outer[] = {body(a_.outer(), body_a_), body(b_.outer(), body_b_)};
    const RoundBody inner[] = {body(a_.inner(), body_a_), body(b_.inner(), body_b_)};
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

  const CurvedBody &body_a_, &body_b_;
  CoreLayers a_, b_;
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
