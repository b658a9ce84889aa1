#include "oracle/surd.h"

namespace flatray::oracle {
namespace {

int number_of(Sign sign) { return static_cast<int>(sign); }

// Sign of p + s sqrt(q).
int sign_of(const Rational& p, int s, const Rational& q) {
  const int left = number_of(p.sign()), right = s * number_of(q.sign());
  if (left == 0 || right == 0 || left == right) return left != 0 ? left : right;
  return left * number_of((p * p - q).sign());
}

}  // namespace

Surd Surd::mapped(const Rational& offset, const Rational& slope) const {
  return {offset + slope * p, s * number_of(slope.sign()), slope * slope * q};
}

Sign Surd::sign() const { return static_cast<Sign>(sign_of(p, s, q)); }

std::strong_ordering Surd::operator<=>(const Surd& b) const {
  // (p - b.p) + s sqrt(q) against b.s sqrt(b.q)
  const Rational apart = p - b.p;
  const int left = sign_of(apart, s, q), right = b.s * number_of(b.q.sign());
  if (left != right || left == 0) return left <=> right;
  const Rational twice = Rational(2) * apart;
  const int squares =
      sign_of(apart * apart + q - b.q, s * number_of(twice.sign()), twice * twice * q);
  return left * squares <=> 0;
}

double Surd::nearest() const {
  const double t = Rational::root_sum(p, s, q);
  check_nearest(t, [this](const Rational& x) { return *this <=> Surd{x, 0, 0}; });
  return t;
}

Rational middle_to(double x, double way) {
  const double next = std::nextafter(x, way);
  if (std::isfinite(next)) return (Rational(x) + next) / 2;
  return Rational(x) + (Rational(x) - std::nextafter(x, 0)) / 2;
}

}  // namespace flatray::oracle
