#include "geom/enclosure.h"

namespace flatray {
namespace {

Bounded exactly(const DoubleDouble& value) { return {value, 0}; }

// What is left of a number, and 0 only where nothing is.
double left_of(const Bounded& rest) {
  if (rest.hi() == 0 && rest.error() == 0) return 0;
  // What underflows is divided later: it is added before.
  return std::fabs(rest.hi()) * (1 + 0x1p-50) + rest.error() + kUnderflowError;
}

}  // namespace

Lossy<DoubleDouble> SharpDoubleDoubles::quotient(const Value& a, const Value& b) {
  const double first = a.hi / b.hi;
  const Bounded rest = exactly(a) - exactly(b) * first;
  const double second = rest.hi() / b.hi;
  return {two_sum(first, second), left_of(rest - exactly(b) * second)};
}

Lossy<DoubleDouble> SharpDoubleDoubles::root(const Value& a) {
  const double first = std::sqrt(a.hi);
  const Bounded rest = exactly(a) - Bounded(first) * first;
  const DoubleDouble value = two_sum(first, rest.hi() / (2 * first));
  return {value, left_of(exactly(a) - exactly(value) * exactly(value))};
}

}  // namespace flatray
