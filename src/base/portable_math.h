#pragma once

/// The transcendental functions that may reach a decision or a pixel: the same bits on every
/// machine, tier and compiler, at most 1 ulp from the true value. Angles in radians. `sqrt` is not
/// among them: every machine rounds it correctly.
///
/// Source  SLEEF's purec functions without fused multiply-add. A test forbids <cmath>'s elsewhere.
namespace flatray::portable {

double sin(double x);
double cos(double x);
double asin(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double pow(double base, double exponent);

}  // namespace flatray::portable
