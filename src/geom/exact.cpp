#include "geom/exact.h"

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

namespace flatray {
namespace {

// A double holds 53 bits from 2^-1074 up to 2^1024.
constexpr int kMantissaBits = 53;
constexpr long kLowestExponent = -1074, kTopExponent = 1024;

// Fractions longer than this are brought to their lowest terms.
constexpr long kLongBits = 4096;

// top * 2^exponent / bottom. Doubles, their sums and products have no bottom and are never divided
// out; where there is one it need not be in lowest terms.
struct Value {
  mpz_class top, bottom;  // bottom > 0, or 0 in place of 1
  long exponent = 0;

  bool is_zero() const { return sgn(top) == 0; }
  bool has_bottom() const { return sgn(bottom) != 0; }
};

Value& value(std::byte* storage) { return *std::launder(reinterpret_cast<Value*>(storage)); }
const Value& value(const std::byte* storage) {
  return *std::launder(reinterpret_cast<const Value*>(storage));
}

// Bits to shift by: none where there are less.
mp_bitcnt_t at_least_0(long bits) { return static_cast<mp_bitcnt_t>(std::max(0L, bits)); }

long length(const mpz_class& z) { return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2)); }
// Factors of two. Needs z != 0.
mp_bitcnt_t twos_of(const mpz_class& z) { return mpz_scan1(z.get_mpz_t(), 0); }

void multiply_bottom(Value& a, const mpz_class& factor) {
  if (a.has_bottom())
    a.bottom *= factor;
  else
    a.bottom = factor;
}

// Makes the top and the bottom coprime.
void reduce(Value& a) {
  if (!a.has_bottom()) return;
  const mpz_class common = gcd(a.top, a.bottom);
  for (mpz_class* part : {&a.top, &a.bottom})
    mpz_divexact(part->get_mpz_t(), part->get_mpz_t(), common.get_mpz_t());
}
// The same, and both odd.
void shorten(Value& a) {
  reduce(a);
  if (a.is_zero()) return;
  const mp_bitcnt_t twos = twos_of(a.top);
  a.top >>= twos;
  a.exponent += static_cast<long>(twos);
}
void shorten_if_long(Value& a) {
  if (length(a.top) + length(a.bottom) > kLongBits) shorten(a);
}

// sum = a + sign * b; `sum` is neither of them.
void add(const Value& a, const Value& b, int sign, Value& sum) {
  if (a.is_zero() || b.is_zero()) {
    sum = a.is_zero() ? b : a;
    if (a.is_zero() && sign < 0) sum.top = -sum.top;
    return;
  }
  sum.exponent = std::min(a.exponent, b.exponent);
  const auto combine = sign < 0 ? mpz_sub : mpz_add;
  const bool one_bottom = a.bottom == b.bottom;
  if (one_bottom && a.exponent == b.exponent) {
    combine(sum.top.get_mpz_t(), a.top.get_mpz_t(), b.top.get_mpz_t());
  } else {
    const auto scaled = [&](const Value& part, const Value& other, mpz_class& top) {
      const mp_bitcnt_t left = at_least_0(part.exponent - sum.exponent);
      if (one_bottom || !other.has_bottom())
        top = part.top << left;
      else
        top = (part.top * other.bottom) << left;
    };
    mpz_class other;
    scaled(a, b, sum.top);
    scaled(b, a, other);
    combine(sum.top.get_mpz_t(), sum.top.get_mpz_t(), other.get_mpz_t());
  }
  sum.bottom = a.bottom;
  if (!one_bottom && b.has_bottom()) multiply_bottom(sum, b.bottom);
  shorten_if_long(sum);
}

// product = a * b; `product` is neither of them.
void multiply(const Value& a, const Value& b, Value& product) {
  product.top = a.top * b.top;
  product.exponent = a.exponent + b.exponent;
  product.bottom = a.bottom;
  if (b.has_bottom()) multiply_bottom(product, b.bottom);
  shorten_if_long(product);
}

void divide(Value& a, const Value& b) {
  const int sign = sgn(b.top);
  const mp_bitcnt_t twos = twos_of(b.top);
  const mpz_class divisor = abs(b.top) >> twos;
  const long exponent = b.exponent + static_cast<long>(twos);
  if (b.has_bottom()) a.top *= b.bottom;
  if (divisor != 1) multiply_bottom(a, divisor);
  a.exponent -= exponent;
  if (sign < 0) a.top = -a.top;
  shorten_if_long(a);
}

// floor(log2 |q|) or one less. Needs q != 0.
long log2_estimate(const Value& q) {
  return length(q.top) + q.exponent - 1 - (q.has_bottom() ? length(q.bottom) : 1);
}

std::strong_ordering compare(const Value& a, const Value& b) {
  const int sign = sgn(a.top);
  if (sign != sgn(b.top)) return sign <=> sgn(b.top);
  if (sign == 0) return std::strong_ordering::equal;
  const long size_a = log2_estimate(a), size_b = log2_estimate(b);
  if (std::labs(size_a - size_b) > 1) return size_a < size_b ? 0 <=> sign : sign <=> 0;
  mpz_class left = a.top, right = b.top;
  if (b.has_bottom()) left *= b.bottom;
  if (a.has_bottom()) right *= a.bottom;
  left <<= at_least_0(a.exponent - b.exponent);
  right <<= at_least_0(b.exponent - a.exponent);
  return cmp(left, right) <=> 0;
}

// floor(q * 2^shift) into `out`; returns whether that was exact.
bool scaled_floor(const Value& q, long shift, mpz_class& out) {
  shift += q.exponent;
  const mpz_class top = q.top << at_least_0(shift);
  const mp_bitcnt_t down = at_least_0(-shift);
  if (!q.has_bottom()) {
    out = top >> down;
    return mpz_divisible_2exp_p(top.get_mpz_t(), down) != 0;
  }
  const mpz_class bottom = q.bottom << down;
  mpz_class rest;
  mpz_fdiv_qr(out.get_mpz_t(), rest.get_mpz_t(), top.get_mpz_t(), bottom.get_mpz_t());
  return sgn(rest) == 0;
}

// Nearest double to q > 0, halves to even.
double nearest_positive(const Value& q) {
  const long top = log2_estimate(q);
  if (top > kTopExponent) return std::numeric_limits<double>::infinity();
  // One bit beyond the last of the result, taken as the half; what is below it is the sticky bit.
  const long last = std::max(top - kMantissaBits, kLowestExponent - 1);
  mpz_class digits;
  const bool exact = scaled_floor(q, -(last - 2), digits);  // two more bits than the half
  if (!exact) mpz_setbit(digits.get_mpz_t(), 0);
  // `digits` has weight 2^(last-2). Round to the weight of the result's last bit.
  const long drop = std::max(length(digits) - kMantissaBits, kLowestExponent - (last - 2));
  const mp_bitcnt_t half = at_least_0(drop - 1);
  mpz_class kept = digits >> at_least_0(drop);
  const bool beyond_half = twos_of(digits) < half || mpz_odd_p(kept.get_mpz_t()) != 0;
  if (mpz_tstbit(digits.get_mpz_t(), half) != 0 && beyond_half) ++kept;
  return std::ldexp(kept.get_d(), static_cast<int>(last - 2 + drop));
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

// Of malloc and its like.
void* given(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void throw_where_numbers_lack_memory() {
  mp_set_memory_functions(
      [](std::size_t bytes) { return given(std::malloc(bytes)); },
      [](void* old, std::size_t, std::size_t bytes) { return given(std::realloc(old, bytes)); },
      [](void* old, std::size_t) { std::free(old); });
}

static_assert(sizeof(Value) <= Rational::kBytes && alignof(Value) <= alignof(std::max_align_t));

Rational::Rational(double finite) {
  Value& made = *new (storage_) Value;
  if (finite == 0) return;
  int exponent = 0;
  const auto digits =
      static_cast<std::int64_t>(std::ldexp(std::frexp(finite, &exponent), kMantissaBits));
  const int twos = std::countr_zero(static_cast<std::uint64_t>(digits));
  made.top = static_cast<long>(digits >> twos);
  made.exponent = exponent - kMantissaBits + twos;
}
Rational::Rational(const Rational& other) { new (storage_) Value(value(other.storage_)); }
Rational::Rational(Rational&& other) noexcept {
  new (storage_) Value(std::move(value(other.storage_)));
}
Rational& Rational::operator=(const Rational& other) {
  value(storage_) = value(other.storage_);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  value(storage_) = std::move(value(other.storage_));
  return *this;
}
Rational::~Rational() { value(storage_).~Value(); }

Rational operator+(const Rational& a, const Rational& b) {
  Rational sum;
  add(value(a.storage_), value(b.storage_), 1, value(sum.storage_));
  return sum;
}
Rational operator-(const Rational& a, const Rational& b) {
  Rational difference;
  add(value(a.storage_), value(b.storage_), -1, value(difference.storage_));
  return difference;
}
Rational operator*(const Rational& a, const Rational& b) {
  Rational product;
  multiply(value(a.storage_), value(b.storage_), value(product.storage_));
  return product;
}
Rational& Rational::operator/=(const Rational& b) {
  divide(value(storage_), value(b.storage_));
  return *this;
}
Rational Rational::operator-() const {
  Rational opposite = *this;
  mpz_class& top = value(opposite.storage_).top;
  top = -top;
  return opposite;
}

Sign Rational::sign() const { return static_cast<Sign>(sgn(value(storage_).top)); }

std::strong_ordering Rational::operator<=>(const Rational& b) const {
  return compare(value(storage_), value(b.storage_));
}
bool Rational::operator==(const Rational& b) const { return *this <=> b == 0; }

double Rational::nearest() const {
  if (sign() == Sign::zero) return 0;
  if (sign() == Sign::positive) return nearest_positive(value(storage_));
  const Rational opposite = -*this;
  return 0.0 - nearest_positive(value(opposite.storage_));
}

Rational Rational::floor() const {
  Rational whole;
  scaled_floor(value(storage_), 0, value(whole.storage_).top);
  return whole;
}

std::size_t Rational::bits() const {
  Value q = value(storage_);
  shorten(q);
  return static_cast<std::size_t>(std::max(length(q.top), length(q.bottom)));
}

std::string Rational::text() const {
  Value q = value(storage_);
  multiply_bottom(q, mpz_class(1) << at_least_0(-q.exponent));
  q.top <<= at_least_0(q.exponent);
  reduce(q);
  return q.bottom == 1 ? q.top.get_str() : q.top.get_str() + "/" + q.bottom.get_str();
}

Sign Rational::root_sign(const Rational& p, int s, const Rational& q) {
  if (s == 0 || q.sign() == Sign::zero) return p.sign();
  const Sign root = static_cast<Sign>(s);
  if (p.sign() == Sign::zero || p.sign() == root) return root;
  const auto larger = p * p <=> q;  // they differ in sign: the larger one decides
  return larger > 0 ? p.sign() : larger < 0 ? root : Sign::zero;
}

Sign Rational::two_root_sign(const Rational& a, int s1, const Rational& q1, int s2,
                             const Rational& q2) {
  if (s1 == 0 || q1.sign() == Sign::zero) return root_sign(a, s2, q2);
  if (s2 == 0 || q2.sign() == Sign::zero) return root_sign(a, s1, q1);
  const auto larger = q1 <=> q2;
  const Sign roots = static_cast<Sign>(s1 == s2 || larger > 0 ? s1 : larger < 0 ? s2 : 0);
  if (roots == Sign::zero) return a.sign();
  if (a.sign() == Sign::zero || a.sign() == roots) return roots;
  // They differ in sign: compare a^2 with the square of the roots' sum.
  return a.sign() * root_sign(a * a - q1 - q2, -s1 * s2, Rational(4) * q1 * q2);
}

std::optional<Rational> Rational::exact_root(const Rational& q) {
  Rational root = q;
  Value& shortest = value(root.storage_);
  shorten(shortest);  // the bottom is always odd
  if (shortest.is_zero()) return Rational(0);
  const auto is_square = [](const mpz_class& z) {
    return mpz_perfect_square_p(z.get_mpz_t()) != 0;
  };
  if (shortest.exponent % 2 != 0 || !is_square(shortest.top) || !is_square(shortest.bottom))
    return std::nullopt;
  shortest.top = sqrt(shortest.top);
  shortest.bottom = sqrt(shortest.bottom);
  shortest.exponent /= 2;
  return root;
}

double Rational::root_sum(const Rational& p, int s, const Rational& q) {
  if (root_sign(p, s, q) == Sign::zero) return 0;
  if (s == 0 || q.sign() == Sign::zero) return p.nearest();
  // 96 bits of the root: floor(sqrt(q) 2^k), relative error 2^-95.
  const long k = 96 - log2_estimate(value(q.storage_)) / 2;
  Rational r;
  Value& root = value(r.storage_);
  scaled_floor(value(q.storage_), 2 * k, root.top);
  root.top = sqrt(root.top);
  root.exponent = -k;
  if (s < 0) r = -r;
  // Where p and the root differ in sign they may cancel: p + r = (p^2 - q) / (p - r).
  const bool cancels = static_cast<int>(p.sign()) == -s;
  const double close = (cancels ? (p * p - q) / (p - r) : p + r).nearest();
  return nearest_to_root_sum(p, s, q, close);
}

}  // namespace flatray
