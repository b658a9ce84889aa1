#include "oracle/exact.h"

namespace flatray::oracle {

Sign side_of_line(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (a == b) return Sign::zero;
  const Rational run = Rational(b.x()) - a.x(), ahead = Rational(c.x()) - a.x();
  if (run.sign() == Sign::zero) return a.y() < b.y() ? -ahead.sign() : ahead.sign();
  const Rational height = a.y() + (Rational(b.y()) - a.y()) / run * ahead;
  const Sign above = (Rational(c.y()) - height).sign();
  return run.sign() == Sign::positive ? above : -above;
}

}  // namespace flatray::oracle
