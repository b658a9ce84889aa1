#pragma once
#include <compare>
#include <memory>
#include <optional>

#include "geom/enclosure.h"
#include "geom/exact.h"
#include "geom/primitives/arc.h"
#include "geom/primitives/bezier.h"
#include "geom/ray.h"

namespace flatray {

/// A double rounded from a number that may lie beyond the doubles: then the largest of its sign.
struct RoundedTime {
  double t;
  bool overflows;
};

/// When a ray meets a line, an ellipse or a Bezier curve: the parameter t as an exact number, kept
/// as the geometry that defines it.
///
/// Gives   comparisons without error, between walls of any kind and rays of any origin, and the
///         nearest double. Cost    bounded double-doubles first; rationals, compared by squaring,
///         only where those leave a doubt.
class HitTime {
 public:
  HitTime() = default;  ///< No hit: only to be assigned to.

  /// Where `ray` crosses the line through `p` along to - from, which may move with `velocity` as a
  /// point moves along the ray. Needs a ray that is not parallel to it.
  static HitTime on_line(const Ray& ray, const Vec2& p, const Vec2& from, const Vec2& to,
                         const Vec2& velocity = {0, 0});
  /// Where `ray` crosses the line through a segment. Needs a ray that is not parallel to it.
  static HitTime on_line(const Ray& ray, const Segment& s) { return on_line(ray, s.a, s.a, s.b); }
  /// Where `ray` comes to the foot of the perpendicular from a point. Needs a direction that is not
  /// zero.
  static HitTime abreast(const Ray& ray, const Vec2& point) {
    return on_line(ray, point, {0, 0}, {-ray.direction.y(), ray.direction.x()});
  }
  /// Where `ray` crosses an ellipse, which may move: in the second root where `root` is that, else in
  /// the first. Needs a line that meets it, and a direction that is not `velocity`.
  static HitTime on_curve(const Ray& ray, const Ellipse& curve, Root root,
                          const Vec2& velocity = {0, 0});
  /// Where `ray` meets a Bezier curve, by one of its roots.
  static HitTime on_curve(const Ray& ray, const Bezier& curve, const BezierRoot& root);

  /// t against `other`, which may be infinite. Exact.
  std::strong_ordering compare(double other) const;
  /// Sign of t. Exact.
  Sign sign() const;
  /// Nearest double to t, halves to even: 0.5 ulp always. The flag is set where |t| is above the
  /// largest double.
  RoundedTime nearest() const;
  /// A double near t, to tell what is near from what is far.
  double about() const { return approximate().hi(); }

  Quadratic exact() const;  ///< Needs a line or an ellipse.
  /// As a root of a polynomial: of any curve.
  RealRoot algebraic() const;

 private:
  friend std::strong_ordering compare(const HitTime& a, const HitTime& b);
  template <class Make>
  auto in(const Make& number) const -> decltype(number(0.0));  // not on a Bezier curve
  template <class Make>
  auto time_of_curve(const Make& number) const;
  template <class Make>
  auto direction(const Make& number) const;  // as seen from what moves
  Bounded approximate() const;
  Sign denominator() const;  // of a line

  Ray ray_;
  Ellipse curve() const { return {p_, from_, to_}; }

  Vec2 p_, from_, to_;   // the line; or centre and half-diameters of a curve
  Vec2 velocity_{0, 0};  // of the line or ellipse
  int root_ = 0;         // 0 for a line
  struct OnBezier;
  std::shared_ptr<const OnBezier> bezier_;  // instead of all but the ray
};

/// Which of two hits comes first. Exact.
std::strong_ordering compare(const HitTime& a, const HitTime& b);

/// Where a ray's line meets a closed segment (t of any sign).
struct SegmentHit {
  enum class Part { inner, at_a, at_b } part;  ///< whether exactly at an end
  HitTime t;
};

/// nullopt where the line misses the segment, runs parallel to it (also along it), or the segment
/// is a point not on the line. A point on the line is met `at_a`. Exact. Needs a direction that is
/// not zero.
std::optional<SegmentHit> hit_segment(const Ray& ray, const Segment& segment);

/// Where a ray's line meets a whole ellipse, the curve itself (t of any sign); both the same where
/// it is tangent. The ellipse may move.
struct CurveHit {
  bool tangent;
  HitTime first, second;
};

/// nullopt where the line misses the curve. Exact. Needs a direction that is not `velocity`.
std::optional<CurveHit> hit_curve(const Ray& ray, const Ellipse& curve,
                                  const Vec2& velocity = {0, 0});

/// Where a ray's line meets the joint of an arc at `end`, the piece of the line to the centre
/// between that end and the curve (see Arc), but for the point on the curve; nullopt where it misses
/// the joint, or the end is on the curve and there is none. Exact.
/// Needs   an arc between ends, a direction that is not zero.
std::optional<HitTime> hit_joint(const Ray& ray, const Ellipse& curve, const Vec2& end);

}  // namespace flatray
