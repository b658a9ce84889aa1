#include "geom/exact.h"

#include <gmp.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>

namespace flatray {
namespace {

static_assert(sizeof(__mpq_struct) <= 32);

// A double holds 53 bits from 2^-1074 up to 2^1024.
constexpr long kMantissaBits = 53, kLowestExponent = -1074, kTopExponent = 1024;

__mpq_struct* number(std::byte* storage) {
  return std::launder(reinterpret_cast<__mpq_struct*>(storage));
}
const __mpq_struct* number(const std::byte* storage) {
  return std::launder(reinterpret_cast<const __mpq_struct*>(storage));
}

// An mpz that frees itself.
struct Integer {
  mpz_t z;
  Integer() { mpz_init(z); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { mpz_clear(z); }
};

// floor(log2 |q|) or one less. Needs q != 0.
long log2_estimate(const __mpq_struct* q) {
  return static_cast<long>(mpz_sizeinbase(mpq_numref(q), 2)) -
         static_cast<long>(mpz_sizeinbase(mpq_denref(q), 2)) - 1;
}

// floor(q * 2^shift) into `out`; returns whether that was exact.
bool scaled_floor(const __mpq_struct* q, long shift, mpz_t out) {
  Integer numerator, denominator, rest;
  mpz_set(numerator.z, mpq_numref(q));
  mpz_set(denominator.z, mpq_denref(q));
  if (shift >= 0)
    mpz_mul_2exp(numerator.z, numerator.z, static_cast<mp_bitcnt_t>(shift));
  else
    mpz_mul_2exp(denominator.z, denominator.z, static_cast<mp_bitcnt_t>(-shift));
  mpz_fdiv_qr(out, rest.z, numerator.z, denominator.z);
  return mpz_sgn(rest.z) == 0;
}

// Nearest double to q > 0, halves to even.
double nearest_positive(const __mpq_struct* q) {
  long top = log2_estimate(q);
  if (top > kTopExponent) return std::numeric_limits<double>::infinity();
  // One bit beyond the last of the result, taken as the half; what is below it is the sticky bit.
  const long last = std::max(top - kMantissaBits, kLowestExponent - 1);
  Integer digits;
  const bool exact = scaled_floor(q, -(last - 2), digits.z);  // two more bits than the half
  if (!exact) mpz_setbit(digits.z, 0);
  // `digits` has weight 2^(last-2). Round to the weight of the result's last bit.
  const long bits = static_cast<long>(mpz_sizeinbase(digits.z, 2));
  const long drop = std::max(bits - kMantissaBits, kLowestExponent - (last - 2));
  Integer kept, half, rest;
  const auto cut = static_cast<mp_bitcnt_t>(drop);
  mpz_fdiv_q_2exp(kept.z, digits.z, cut);
  mpz_fdiv_r_2exp(rest.z, digits.z, cut);
  mpz_setbit(half.z, cut - 1);
  const int compared = mpz_cmp(rest.z, half.z);
  if (compared > 0 || (compared == 0 && mpz_odd_p(kept.z))) mpz_add_ui(kept.z, kept.z, 1);
  return std::ldexp(mpz_get_d(kept.z), static_cast<int>(last - 2 + drop));
}

// The double nearest to p + s sqrt(q), given one of its neighbours.
double nearest_to_root_sum(const Rational& p, int s, const Rational& q, double close) {
  if (std::isinf(close)) return close;
  for (const double direction : {-kInfinity, kInfinity}) {
    const double next = std::nextafter(close, direction);
    if (std::isinf(next)) continue;
    const Rational middle = (Rational(close) + next) / 2;
    const int beyond = static_cast<int>(Rational::root_sign(p - middle, s, q));
    if (beyond == 0) return (std::bit_cast<std::uint64_t>(close) & 1) == 0 ? close : next;
    if ((beyond > 0) == (next > close)) return next;
  }
  return close;
}

}  // namespace

Rational::Rational(double finite) {
  new (storage_) __mpq_struct;
  mpq_init(number(storage_));
  mpq_set_d(number(storage_), finite);
}
Rational::Rational(const Rational& other) {
  new (storage_) __mpq_struct;
  mpq_init(number(storage_));
  mpq_set(number(storage_), number(other.storage_));
}
Rational::Rational(Rational&& other) noexcept : Rational() { *this = std::move(other); }
Rational& Rational::operator=(const Rational& other) {
  mpq_set(number(storage_), number(other.storage_));
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  mpq_swap(number(storage_), number(other.storage_));
  return *this;
}
Rational::~Rational() { mpq_clear(number(storage_)); }

Rational& Rational::operator+=(const Rational& b) {
  mpq_add(number(storage_), number(storage_), number(b.storage_));
  return *this;
}
Rational& Rational::operator-=(const Rational& b) {
  mpq_sub(number(storage_), number(storage_), number(b.storage_));
  return *this;
}
Rational& Rational::operator*=(const Rational& b) {
  mpq_mul(number(storage_), number(storage_), number(b.storage_));
  return *this;
}
Rational& Rational::operator/=(const Rational& b) {
  mpq_div(number(storage_), number(storage_), number(b.storage_));
  return *this;
}

Sign Rational::sign() const { return static_cast<Sign>(mpq_sgn(number(storage_))); }

std::strong_ordering Rational::operator<=>(const Rational& b) const {
  return mpq_cmp(number(storage_), number(b.storage_)) <=> 0;
}
bool Rational::operator==(const Rational& b) const {
  return mpq_equal(number(storage_), number(b.storage_)) != 0;
}

double Rational::nearest() const {
  switch (sign()) {
    case Sign::zero:
      return 0;
    case Sign::positive:
      return nearest_positive(number(storage_));
    case Sign::negative:
      break;
  }
  const Rational opposite = -*this;
  return -nearest_positive(number(opposite.storage_));
}

Rational Rational::floor() const {
  Rational whole;
  mpz_fdiv_q(mpq_numref(number(whole.storage_)), mpq_numref(number(storage_)),
             mpq_denref(number(storage_)));
  return whole;
}

std::string Rational::text() const {
  const __mpq_struct* q = number(storage_);
  std::string digits(mpz_sizeinbase(mpq_numref(q), 10) + mpz_sizeinbase(mpq_denref(q), 10) + 3,
                     '\0');
  mpq_get_str(digits.data(), 10, q);
  digits.resize(digits.find('\0'));
  return digits;
}

Sign Rational::root_sign(const Rational& p, int s, const Rational& q) {
  if (s == 0 || q.sign() == Sign::zero) return p.sign();
  const Sign root = static_cast<Sign>(s);
  if (p.sign() == Sign::zero || p.sign() == root) return root;
  const auto larger = p * p <=> q;  // they differ in sign: the larger one decides
  return larger > 0 ? p.sign() : larger < 0 ? root : Sign::zero;
}

double Rational::root_sum(const Rational& p, int s, const Rational& q) {
  if (root_sign(p, s, q) == Sign::zero) return 0;
  if (s == 0 || q.sign() == Sign::zero) return p.nearest();
  // 96 bits of the root: floor(sqrt(q) 2^k), relative error 2^-95.
  const long k = 96 - log2_estimate(number(q.storage_)) / 2;
  Integer square, root;
  scaled_floor(number(q.storage_), 2 * k, square.z);
  mpz_sqrt(root.z, square.z);
  Rational r;
  mpq_set_z(number(r.storage_), root.z);
  if (k >= 0)
    mpq_div_2exp(number(r.storage_), number(r.storage_), static_cast<mp_bitcnt_t>(k));
  else
    mpq_mul_2exp(number(r.storage_), number(r.storage_), static_cast<mp_bitcnt_t>(-k));
  if (s < 0) r = -r;
  // Where p and the root differ in sign they may cancel: p + r = (p^2 - q) / (p - r).
  const bool cancels = static_cast<int>(p.sign()) == -s;
  const double close = (cancels ? (p * p - q) / (p - r) : p + r).nearest();
  return nearest_to_root_sum(p, s, q, close);
}

}  // namespace flatray
