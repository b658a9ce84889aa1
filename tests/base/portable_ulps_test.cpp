// needs: mpfr
// The portable functions against MPFR.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "base/philox.h"
#include "base/portable_math.h"

namespace flatray {
namespace {

constexpr mpfr_prec_t kPrecision = 160;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A number of MPFR that frees itself.
struct Wide {
  mpfr_t value;
  explicit Wide(double x = 0) {
    mpfr_init2(value, kPrecision);
    mpfr_set_d(value, x, MPFR_RNDN);
  }
  Wide(const Wide&) = delete;
  Wide& operator=(const Wide&) = delete;
  ~Wide() { mpfr_clear(value); }
};

// Distance of `got` from the true value, in units of the last place there.
double ulps(double got, const Wide& truth) {
  const double nearest = mpfr_get_d(truth.value, MPFR_RNDN);
  if (std::isinf(nearest) || std::isinf(got)) return got == nearest ? 0 : kInfinity;
  const double size = std::fabs(nearest);
  const double unit = size - std::nextafter(size, 0);
  Wide difference;
  mpfr_sub_d(difference.value, truth.value, got, MPFR_RNDN);
  return std::fabs(mpfr_get_d(difference.value, MPFR_RNDN)) /
         std::max(unit, std::numeric_limits<double>::denorm_min());
}

// Arguments, each named by its number.
double unit(std::uint64_t item, std::uint32_t draw) {
  return unit_double(random_bits(1, Stream::test, 0, item, draw));
}
// +-2^e, e uniform.
double log_uniform(std::uint64_t item, double lowest, double highest, std::uint32_t draw = 0) {
  const double exponent = lowest + (highest - lowest) * unit(item, draw);
  const double whole = std::floor(exponent);
  const double size = std::ldexp(1 + (exponent - whole), static_cast<int>(whole));
  return random_bits(1, Stream::test, 0, item, draw + 1) % 2 == 0 ? size : -size;
}

using MpfrFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
constexpr std::uint64_t kTrials = 20000;

// The worst error over all arguments; NaN would be worse than any.
double worst_ulps(const char* name, double (*function)(double), MpfrFunction truth,
                  const std::function<double(std::uint64_t)>& argument) {
  double worst = 0, worst_at = 0;
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    const double x = argument(i);
    Wide wide(x);
    truth(wide.value, wide.value, MPFR_RNDN);
    const double error = ulps(function(x), wide);
    if (!(error <= worst)) worst = error, worst_at = x;
  }
  std::printf("  %-5s worst %.4f ulp at %a\n", name, worst, worst_at);
  return worst;
}

double worst_ulps(const char* name, double (*function)(double, double),
                  int (*truth)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t),
                  const std::function<std::pair<double, double>(std::uint64_t)>& arguments) {
  double worst = 0, worst_x = 0, worst_y = 0;
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    const auto [x, y] = arguments(i);
    Wide wide(x);
    const Wide second(y);
    truth(wide.value, wide.value, second.value, MPFR_RNDN);
    const double error = ulps(function(x, y), wide);
    if (!(error <= worst)) worst = error, worst_x = x, worst_y = y;
  }
  std::printf("  %-5s worst %.4f ulp at %a, %a\n", name, worst, worst_x, worst_y);
  return worst;
}

TEST(PortableMath, TrigonometryIsWithinOneUlp) {
  const auto angle = [](std::uint64_t i) { return log_uniform(i, -300, 1020); };
  EXPECT_LE(worst_ulps("sin", portable::sin, mpfr_sin, angle), 1);
  EXPECT_LE(worst_ulps("cos", portable::cos, mpfr_cos, angle), 1);
  // Doubles nearest to multiples of pi/2, where the results all but vanish.
  const auto near_zero = [](std::uint64_t i) {
    return static_cast<double>(i) * 0x1.921fb54442d18p+0;
  };
  EXPECT_LE(worst_ulps("sin", portable::sin, mpfr_sin, near_zero), 1);
  EXPECT_LE(worst_ulps("cos", portable::cos, mpfr_cos, near_zero), 1);
}

TEST(PortableMath, InverseTrigonometryIsWithinOneUlp) {
  const auto small = [](std::uint64_t i) { return log_uniform(i, -300, 0) / 2; };
  const auto near_one = [](std::uint64_t i) {
    const double below = 1 - std::fabs(log_uniform(i, -52, -1));
    return i % 2 == 0 ? below : -below;
  };
  EXPECT_LE(worst_ulps("asin", portable::asin, mpfr_asin, small), 1);
  EXPECT_LE(worst_ulps("asin", portable::asin, mpfr_asin, near_one), 1);
  const auto pair = [](std::uint64_t i) {
    return std::pair(log_uniform(i, -300, 300, 0), log_uniform(i, -300, 300, 2));
  };
  const auto alike = [](std::uint64_t i) {
    return std::pair(log_uniform(i, -10, 10, 0), log_uniform(i, -10, 10, 2));
  };
  EXPECT_LE(worst_ulps("atan2", portable::atan2, mpfr_atan2, pair), 1);
  EXPECT_LE(worst_ulps("atan2", portable::atan2, mpfr_atan2, alike), 1);
}

TEST(PortableMath, ExponentialsAreWithinOneUlp) {
  EXPECT_LE(worst_ulps("exp", portable::exp, mpfr_exp,
                       [](std::uint64_t i) { return log_uniform(i, -60, 9.54); }),
            1);
  EXPECT_LE(worst_ulps("log", portable::log, mpfr_log,
                       [](std::uint64_t i) { return std::fabs(log_uniform(i, -1022, 1023)); }),
            1);
  EXPECT_LE(worst_ulps("log", portable::log, mpfr_log,
                       [](std::uint64_t i) { return 1 + log_uniform(i, -52, -1); }),
            1);
  EXPECT_LE(worst_ulps("pow", portable::pow, mpfr_pow,
                       [](std::uint64_t i) {
                         return std::pair(std::fabs(log_uniform(i, -50, 50, 0)),
                                          log_uniform(i, -20, 4.5, 2));
                       }),
            1);
}

}  // namespace
}  // namespace flatray
