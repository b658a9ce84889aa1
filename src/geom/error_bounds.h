#pragma once

/// Every tolerance of the geometry, with its derivation; u = 2^-53 is half an ulp of 1.
/// docs/NUMERICS.md has the proofs in full, and tests/geom/error_bounds_test.cpp prints the worst
/// ratios seen.
namespace flatray {

/// One operation on doubles rounds by a factor 1 + e with |e| at most u.
inline constexpr double kDoubleError = 0x1p-53;

/// Filter of (b - a) x (d - c) = L - R in lanes, as Terms (geom/enclosure.h) has it. Each difference and each product
/// is off by a factor 1 + e, |e| <= u, so the rounded products l, r are within (3u + O(u^2)) |l|, |r| of L and
/// R; the last subtraction keeps the sign of l - r. |l - r| > 4u (|l| + |r|) thus proves the sign:
/// the spare u covers the second-order terms and the rounding of the bound itself.
inline constexpr double kDetFilter = 0x1p-51;

/// Below this, |l| + |r| may hide a product that underflowed, which the factors 1 + e do not
/// describe. At it, two such errors of 2^-1075 are under u^2 (|l| + |r|).
inline constexpr double kDetFilterLeast = 0x1p-960;

/// One operation on double-doubles loses at most 2^-102 of its result, or of its operands where
/// they cancel: the neglected product of the low parts is u^2, and no operation rounds more than
/// six terms below 2 u each by u.
inline constexpr double kDoubleDoubleError = 0x1p-100;

/// What underflow may take away in one such operation: no more than eight results are off by
/// 2^-1075.
inline constexpr double kUnderflowError = 0x1p-1070;

/// Products between these lose nothing to two_product: the lowest bit of the tail is 105 below the
/// highest.
inline constexpr double kExactProductLeast = 0x1p-960, kExactProductMost = 0x1p1020;

}  // namespace flatray
