#pragma once
#include "scene/curve.h"
#include "scene/keys/builder.h"

namespace flatray {

/// Numbers, points and colours that may be curves. Where `change` is given, a function of double
/// that may change units, it is applied to what is read. Where it may not be a curve, one is refused.
std::optional<Moving> read_moving(Builder& builder, const Field& field,
                                  double (*change)(double) = nullptr, bool may_be_curve = true);

/// The smallest and the largest value that a number ever has.
double lowest(const Scene& scene, const Moving& number);
double highest(const Scene& scene, const Moving& number);
/// Whether it is never below `low` and never above `high`.
bool lies_between(const Scene& scene, const Moving& number, double low, double high);

std::optional<MovingPoint> read_moving_point(Builder& builder, const Field& field,
                                             bool may_be_curve = true);

/// A colour, or a curve where Builder::may_change says so.
std::optional<Paint> read_moving_colour(Builder& builder, const Field& field);

std::vector<TableInfo> curve_tables();

}  // namespace flatray
