#include "oracle/exact.h"

namespace flatray::oracle {
namespace {

// |o + t d - c|^2 - r^2
Rational power(const Ray& ray, const Circle& circle, const Rational& t) {
  const Rational x = ray.origin.x() + t * ray.direction.x() - circle.centre.x();
  const Rational y = ray.origin.y() + t * ray.direction.y() - circle.centre.y();
  return x * x + y * y - Rational(circle.radius) * circle.radius;
}

// The parameter of the point of the line nearest to the centre.
Rational foot(const Ray& ray, const Circle& circle) {
  const Rational dx = ray.direction.x(), dy = ray.direction.y();
  return ((circle.centre.x() - Rational(ray.origin.x())) * dx +
          (circle.centre.y() - Rational(ray.origin.y())) * dy) /
         (dx * dx + dy * dy);
}

}  // namespace

std::strong_ordering root_against(const Ray& ray, const Circle& circle, int root,
                                  const Rational& t) {
  const Sign outside = power(ray, circle, t).sign();
  const auto middle = foot(ray, circle) <=> t;
  if (outside == Sign::negative) return root <=> 0;
  const bool is_this_root = middle == 0 || (middle < 0) == (root > 0);
  if (outside == Sign::zero && is_this_root) return std::strong_ordering::equal;
  return middle;
}

HitClass verdict_on_disc(const Ray& ray, const Circle& circle) {
  switch (power(ray, circle, foot(ray, circle)).sign()) {
    case Sign::positive:
      return HitClass::miss;
    case Sign::zero:
      return HitClass::touch;
    case Sign::negative:
      return HitClass::through;
  }
  return HitClass::miss;
}

StartPlace place_in_disc(const Vec2& point, const Circle& circle) {
  switch (power({point, {0, 0}}, circle, 0).sign()) {
    case Sign::positive:
      return StartPlace::outside;
    case Sign::zero:
      return StartPlace::boundary;
    case Sign::negative:
      break;
  }
  return StartPlace::inside;
}

}  // namespace flatray::oracle
