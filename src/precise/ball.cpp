#include "precise/ball.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatray {
namespace {

constexpr mpfr_prec_t kRadiusBits = 32;

// A radius under way: every step is rounded up.
class Radius {
 public:
  Radius() { mpfr_init2(value, kRadiusBits); }
  Radius(const Radius&) = delete;
  Radius& operator=(const Radius&) = delete;
  ~Radius() { mpfr_clear(value); }

  mpfr_t value;
};

void set_size_up(mpfr_t out, const mpfr_t x) { mpfr_abs(out, x, MPFR_RNDU); }

// out += a * b, of sizes.
void add_product_up(mpfr_t out, const mpfr_t a, const mpfr_t b) {
  Radius size, product;
  set_size_up(size.value, a);
  mpfr_mul(product.value, size.value, b, MPFR_RNDU);
  mpfr_add(out, out, product.value, MPFR_RNDU);
}

}  // namespace

Ball::Ball(mpfr_prec_t bits) {
  mpfr_init2(middle_, bits);
  mpfr_init2(radius_, kRadiusBits);
  mpfr_set_zero(radius_, 1);
}
Ball::Ball(double exact, int bits) : Ball(static_cast<mpfr_prec_t>(bits)) {
  mpfr_set_d(middle_, exact, MPFR_RNDN);
}
// A sum of doubles, each the nearest to what those before left, so that less is left than the last.
// What is left is scaled up by as much as it has become smaller, for it would leave the range of doubles, and
// down at first as long as it is beyond them.
Ball::Ball(const Rational& exact, int bits) : Ball(0.0, bits) {
  constexpr int kStep = 52, kDown = 1000;
  Rational left = exact;
  double part = left.nearest();
  long scale = 0;  // what is left is left * 2^-scale
  for (; std::isinf(part); part = left.nearest(), scale -= kDown) left *= 0x1p-1000;
  const long last = scale + bits;
  for (; left.sign() != Sign::zero && scale <= last; scale += kStep) {
    Ball term(part, bits);
    mpfr_mul_2si(term.middle_, term.middle_, -scale, MPFR_RNDN);
    *this = *this + term;
    left = (left - Rational(part)) * Rational(0x1p52);
    part = left.nearest();
  }
  if (left.sign() == Sign::zero) return;
  Radius size;
  mpfr_set_d(size.value, std::fabs(part) + std::numeric_limits<double>::denorm_min(), MPFR_RNDU);
  mpfr_mul_2si(size.value, size.value, 1 - scale, MPFR_RNDU);
  mpfr_add(radius_, radius_, size.value, MPFR_RNDU);
}
Ball::Ball(const Ball& other) : Ball(other.bits()) { *this = other; }
Ball::Ball(Ball&& other) noexcept : Ball(other.bits()) { *this = std::move(other); }
Ball& Ball::operator=(const Ball& other) {
  if (this == &other) return *this;
  mpfr_set_prec(middle_, other.bits());
  mpfr_set(middle_, other.middle_, MPFR_RNDN);
  mpfr_set(radius_, other.radius_, MPFR_RNDU);
  return *this;
}
Ball& Ball::operator=(Ball&& other) noexcept {
  mpfr_swap(middle_, other.middle_);
  mpfr_swap(radius_, other.radius_);
  return *this;
}
Ball::~Ball() {
  mpfr_clear(middle_);
  mpfr_clear(radius_);
}

// The last operation on the midpoint was off by at most half a unit in its last place.
void Ball::add_rounding(int inexact) {
  if (inexact == 0) return;
  if (!mpfr_regular_p(middle_)) {
    make_unknown();
    return;
  }
  Radius half;
  mpfr_set_ui_2exp(half.value, 1, mpfr_get_exp(middle_) - bits() - 1, MPFR_RNDU);
  mpfr_add(radius_, radius_, half.value, MPFR_RNDU);
}

void Ball::make_unknown() {
  mpfr_set_zero(middle_, 1);
  mpfr_set_inf(radius_, 1);
}

Ball operator+(const Ball& a, const Ball& b) {
  Ball sum(std::max(a.bits(), b.bits()));
  mpfr_add(sum.radius_, a.radius_, b.radius_, MPFR_RNDU);
  sum.add_rounding(mpfr_add(sum.middle_, a.middle_, b.middle_, MPFR_RNDN));
  return sum;
}

Ball operator-(const Ball& a, const Ball& b) { return a + -b; }

Ball Ball::operator-() const {
  Ball negative(*this);
  mpfr_neg(negative.middle_, negative.middle_, MPFR_RNDN);
  return negative;
}

// (a + da)(b + db) - ab
Ball operator*(const Ball& a, const Ball& b) {
  Ball product(std::max(a.bits(), b.bits()));
  add_product_up(product.radius_, a.middle_, b.radius_);
  add_product_up(product.radius_, b.middle_, a.radius_);
  add_product_up(product.radius_, a.radius_, b.radius_);
  product.add_rounding(mpfr_mul(product.middle_, a.middle_, b.middle_, MPFR_RNDN));
  return product;
}

// (a + da)/(b + db) - a/b = (da b - a db) / (b (b + db)), and |b + db| >= |b| - |db|.
Ball operator/(const Ball& a, const Ball& b) {
  Ball quotient(std::max(a.bits(), b.bits()));
  Radius size, least;
  mpfr_abs(size.value, b.middle_, MPFR_RNDD);
  mpfr_sub(least.value, size.value, b.radius_, MPFR_RNDD);
  if (!(mpfr_sgn(least.value) > 0)) {
    quotient.make_unknown();
    return quotient;
  }
  add_product_up(quotient.radius_, b.middle_, a.radius_);
  add_product_up(quotient.radius_, a.middle_, b.radius_);
  mpfr_div(quotient.radius_, quotient.radius_, size.value, MPFR_RNDU);
  mpfr_div(quotient.radius_, quotient.radius_, least.value, MPFR_RNDU);
  quotient.add_rounding(mpfr_div(quotient.middle_, a.middle_, b.middle_, MPFR_RNDN));
  return quotient;
}

// sqrt(a + da) - sqrt(a) is at most da / sqrt(a - da).
Ball square_root(const Ball& a) {
  Ball root(a.bits());
  Radius least;
  mpfr_sub(least.value, a.middle_, a.radius_, MPFR_RNDD);
  if (!(mpfr_sgn(least.value) > 0)) {
    root.make_unknown();
    return root;
  }
  mpfr_sqrt(least.value, least.value, MPFR_RNDD);
  mpfr_div(root.radius_, a.radius_, least.value, MPFR_RNDU);
  root.add_rounding(mpfr_sqrt(root.middle_, a.middle_, MPFR_RNDN));
  return root;
}

Ball either_root(const Ball& a) {
  Ball root(0.0, static_cast<int>(a.bits()));
  Radius size;
  set_size_up(size.value, a.middle_);
  mpfr_add(size.value, size.value, a.radius_, MPFR_RNDU);
  mpfr_sqrt(root.radius_, size.value, MPFR_RNDU);
  return root;
}

std::optional<Sign> Ball::sign() const {
  if (mpfr_nan_p(radius_) || mpfr_nan_p(middle_)) return std::nullopt;
  if (mpfr_zero_p(radius_) && mpfr_zero_p(middle_)) return Sign::zero;
  if (mpfr_cmpabs(middle_, radius_) <= 0) return std::nullopt;
  return mpfr_sgn(middle_) > 0 ? Sign::positive : Sign::negative;
}

// Where it is that to both ends.
std::optional<double> Ball::nearest() const {
  Ball low(*this), high(*this);
  mpfr_sub(low.middle_, middle_, radius_, MPFR_RNDD);
  mpfr_add(high.middle_, middle_, radius_, MPFR_RNDU);
  const double nearest = mpfr_get_d(low.middle_, MPFR_RNDN);
  if (nearest != mpfr_get_d(high.middle_, MPFR_RNDN) || !std::isfinite(nearest))
    return std::nullopt;
  return nearest + 0.0;  // never -0
}

Near near_of(const Ball& x) {
  const double about = mpfr_get_d(x.middle_, MPFR_RNDN);
  Radius off;
  mpfr_sub_d(off.value, x.middle_, about, MPFR_RNDA);
  set_size_up(off.value, off.value);
  mpfr_add(off.value, off.value, x.radius_, MPFR_RNDU);
  return Near::within(about, mpfr_get_d(off.value, MPFR_RNDU));
}

Ball Ball::middle() const {
  Ball exact(*this);
  mpfr_set_zero(exact.radius_, 1);
  return exact;
}
Ball Ball::rest() const {
  Ball about_zero(*this);
  mpfr_set_zero(about_zero.middle_, 1);
  return about_zero;
}

}  // namespace flatray
