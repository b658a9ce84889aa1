#include "precise/certain.h"

#include <cmath>

namespace flatray {

std::optional<double> Certain::nearest() const {
  if (!exact()) return ball().nearest();
  const double value = exact()->nearest();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Ball Certain::ball() const {
  if (!exact()) return std::get<Ball>(value_);
  return exact()->in([this](const Rational& x) { return Ball(x, bits_); });
}

}  // namespace flatray
