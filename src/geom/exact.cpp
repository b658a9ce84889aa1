#include "geom/exact.h"

#include <gmp.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>

namespace flatray {
namespace {

// A double holds 53 bits from 2^-1074 up to 2^1024.
constexpr int kMantissaBits = 53;
constexpr long kLowestExponent = -1074, kTopExponent = 1024;

// Fractions longer than this are brought to their lowest terms.
constexpr std::size_t kLongBits = 4096;

// An mpz that frees itself.
struct Integer {
  mpz_t z;
  Integer() { mpz_init(z); }
  Integer(const Integer& other) : Integer() { *this = other; }
  Integer& operator=(const Integer& other) {
    mpz_set(z, other.z);
    return *this;
  }
  ~Integer() { mpz_clear(z); }
};

// top * 2^exponent / bottom. Doubles, their sums and products have no bottom and are never divided
// out; where there is one it need not be in lowest terms.
struct Value {
  Integer top, bottom;  // bottom > 0, or 0 in place of 1
  long exponent = 0;

  bool is_zero() const { return mpz_sgn(top.z) == 0; }
  bool has_bottom() const { return mpz_sgn(bottom.z) != 0; }
};

Value& value(std::byte* storage) { return *std::launder(reinterpret_cast<Value*>(storage)); }
const Value& value(const std::byte* storage) {
  return *std::launder(reinterpret_cast<const Value*>(storage));
}

void shift_left(mpz_t z, long bits) { mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(bits)); }
// floor(z / 2^bits)
void shift_right(mpz_t z, long bits) { mpz_fdiv_q_2exp(z, z, static_cast<mp_bitcnt_t>(bits)); }

void multiply_bottom(Value& a, const mpz_t factor) {
  if (a.has_bottom())
    mpz_mul(a.bottom.z, a.bottom.z, factor);
  else
    mpz_set(a.bottom.z, factor);
}

// Makes the top and the bottom coprime.
void reduce(Value& a) {
  if (!a.has_bottom()) return;
  Integer common;
  mpz_gcd(common.z, a.top.z, a.bottom.z);
  mpz_divexact(a.top.z, a.top.z, common.z);
  mpz_divexact(a.bottom.z, a.bottom.z, common.z);
}
// The same, and both odd.
void shorten(Value& a) {
  reduce(a);
  if (a.is_zero()) return;
  const auto twos = static_cast<long>(mpz_scan1(a.top.z, 0));
  shift_right(a.top.z, twos);
  a.exponent += twos;
}
void shorten_if_long(Value& a) {
  if (mpz_sizeinbase(a.top.z, 2) + mpz_sizeinbase(a.bottom.z, 2) > kLongBits) shorten(a);
}

// top * 2^left over the bottom of a sum or difference, in `out`.
void scale_top(const Value& q, const mpz_t factor, long left, mpz_t out) {
  mpz_srcptr top = q.top.z;
  if (mpz_sgn(factor) != 0) {
    mpz_mul(out, top, factor);
    top = out;
  }
  mpz_mul_2exp(out, top, static_cast<mp_bitcnt_t>(left));
}

// sum = a + sign * b; `sum` is neither of them.
void add(const Value& a, const Value& b, int sign, Value& sum) {
  if (a.is_zero() || b.is_zero()) {
    sum = a.is_zero() ? b : a;
    if (a.is_zero() && sign < 0) mpz_neg(sum.top.z, sum.top.z);
    return;
  }
  sum.exponent = std::min(a.exponent, b.exponent);
  const auto combine = sign < 0 ? mpz_sub : mpz_add;
  const bool one_bottom = mpz_cmp(a.bottom.z, b.bottom.z) == 0;
  if (one_bottom && a.exponent == b.exponent) {
    combine(sum.top.z, a.top.z, b.top.z);
  } else {
    const Value none;
    Integer other;
    scale_top(a, one_bottom ? none.bottom.z : b.bottom.z, a.exponent - sum.exponent, sum.top.z);
    scale_top(b, one_bottom ? none.bottom.z : a.bottom.z, b.exponent - sum.exponent, other.z);
    combine(sum.top.z, sum.top.z, other.z);
  }
  mpz_set(sum.bottom.z, a.bottom.z);
  if (!one_bottom && b.has_bottom()) multiply_bottom(sum, b.bottom.z);
  shorten_if_long(sum);
}

// product = a * b; `product` is neither of them.
void multiply(const Value& a, const Value& b, Value& product) {
  mpz_mul(product.top.z, a.top.z, b.top.z);
  product.exponent = a.exponent + b.exponent;
  if (!a.has_bottom() || !b.has_bottom())
    mpz_set(product.bottom.z, a.has_bottom() ? a.bottom.z : b.bottom.z);
  else
    mpz_mul(product.bottom.z, a.bottom.z, b.bottom.z);
  shorten_if_long(product);
}

void divide(Value& a, const Value& b) {
  Integer divisor = b.top;
  const int sign = mpz_sgn(divisor.z);
  const auto twos = static_cast<long>(mpz_scan1(divisor.z, 0));
  shift_right(divisor.z, twos);
  mpz_abs(divisor.z, divisor.z);
  const long exponent = b.exponent + twos;
  if (b.has_bottom()) mpz_mul(a.top.z, a.top.z, b.bottom.z);
  if (mpz_cmp_ui(divisor.z, 1) != 0) multiply_bottom(a, divisor.z);
  a.exponent -= exponent;
  if (sign < 0) mpz_neg(a.top.z, a.top.z);
  shorten_if_long(a);
}

// floor(log2 |q|) or one less. Needs q != 0.
long log2_estimate(const Value& q) {
  return static_cast<long>(mpz_sizeinbase(q.top.z, 2)) + q.exponent - 1 -
         (q.has_bottom() ? static_cast<long>(mpz_sizeinbase(q.bottom.z, 2)) : 1);
}

std::strong_ordering compare(const Value& a, const Value& b) {
  const int sign = mpz_sgn(a.top.z);
  if (sign != mpz_sgn(b.top.z)) return sign <=> mpz_sgn(b.top.z);
  if (sign == 0) return std::strong_ordering::equal;
  const long size_a = log2_estimate(a), size_b = log2_estimate(b);
  if (std::labs(size_a - size_b) > 1) return size_a < size_b ? 0 <=> sign : sign <=> 0;
  Integer left = a.top, right = b.top;
  if (b.has_bottom()) mpz_mul(left.z, left.z, b.bottom.z);
  if (a.has_bottom()) mpz_mul(right.z, right.z, a.bottom.z);
  shift_left(left.z, std::max(0L, a.exponent - b.exponent));
  shift_left(right.z, std::max(0L, b.exponent - a.exponent));
  return mpz_cmp(left.z, right.z) <=> 0;
}

// floor(q * 2^shift) into `out`; returns whether that was exact.
bool scaled_floor(const Value& q, long shift, mpz_t out) {
  shift += q.exponent;
  Integer top = q.top;
  if (shift >= 0) shift_left(top.z, shift);
  if (!q.has_bottom()) {
    const bool exact = shift >= 0 || mpz_divisible_2exp_p(top.z, static_cast<mp_bitcnt_t>(-shift));
    if (shift < 0) shift_right(top.z, -shift);
    mpz_swap(out, top.z);
    return exact;
  }
  Integer bottom = q.bottom, rest;
  if (shift < 0) shift_left(bottom.z, -shift);
  mpz_fdiv_qr(out, rest.z, top.z, bottom.z);
  return mpz_sgn(rest.z) == 0;
}

// Nearest double to q > 0, halves to even.
double nearest_positive(const Value& q) {
  const long top = log2_estimate(q);
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
  mpz_set_si(made.top.z, digits >> twos);
  made.exponent = exponent - kMantissaBits + twos;
}
Rational::Rational(const Rational& other) { new (storage_) Value(value(other.storage_)); }
Rational::Rational(Rational&& other) noexcept : Rational() { *this = std::move(other); }
Rational& Rational::operator=(const Rational& other) {
  value(storage_) = value(other.storage_);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  Value &a = value(storage_), &b = value(other.storage_);
  mpz_swap(a.top.z, b.top.z);
  mpz_swap(a.bottom.z, b.bottom.z);
  std::swap(a.exponent, b.exponent);
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
  Integer& top = value(opposite.storage_).top;
  mpz_neg(top.z, top.z);
  return opposite;
}

Sign Rational::sign() const { return static_cast<Sign>(mpz_sgn(value(storage_).top.z)); }

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
  scaled_floor(value(storage_), 0, value(whole.storage_).top.z);
  return whole;
}

std::size_t Rational::bits() const {
  Rational copied = *this;
  Value& q = value(copied.storage_);
  shorten(q);
  return std::max(mpz_sizeinbase(q.top.z, 2), mpz_sizeinbase(q.bottom.z, 2));
}

std::string Rational::text() const {
  Rational copied = *this;
  Value& q = value(copied.storage_);
  Integer bottom;
  mpz_set_ui(bottom.z, 1);
  shift_left(bottom.z, std::max(0L, -q.exponent));
  shift_left(q.top.z, std::max(0L, q.exponent));
  multiply_bottom(q, bottom.z);
  reduce(q);
  std::string digits(mpz_sizeinbase(q.top.z, 10) + mpz_sizeinbase(q.bottom.z, 10) + 3, '\0');
  mpz_get_str(digits.data(), 10, q.top.z);
  digits.resize(digits.find('\0'));
  if (mpz_cmp_ui(q.bottom.z, 1) == 0) return digits;
  std::string below(mpz_sizeinbase(q.bottom.z, 10) + 2, '\0');
  mpz_get_str(below.data(), 10, q.bottom.z);
  return digits + "/" + below.c_str();
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
  const bool square = shortest.exponent % 2 == 0 && mpz_perfect_square_p(shortest.top.z) != 0 &&
                      mpz_perfect_square_p(shortest.bottom.z) != 0;
  if (!square) return std::nullopt;
  mpz_sqrt(shortest.top.z, shortest.top.z);
  mpz_sqrt(shortest.bottom.z, shortest.bottom.z);
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
  scaled_floor(value(q.storage_), 2 * k, root.top.z);
  mpz_sqrt(root.top.z, root.top.z);
  root.exponent = -k;
  if (s < 0) r = -r;
  // Where p and the root differ in sign they may cancel: p + r = (p^2 - q) / (p - r).
  const bool cancels = static_cast<int>(p.sign()) == -s;
  const double close = (cancels ? (p * p - q) / (p - r) : p + r).nearest();
  return nearest_to_root_sum(p, s, q, close);
}

}  // namespace flatray
