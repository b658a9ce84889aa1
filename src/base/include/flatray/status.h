#pragma once
#include <cstddef>
#include <cstdint>

#include "flatray/float_mode.h"

/// What other programs call: `<flatray/trace.h>`, `<flatray/collide.h>`,
/// `<flatray/transport.h>` and `<flatray/picture.h>`.
///
/// Needs   of each thread the floating-point mode in which programs begin: rounding to nearest, and numbers near
///         0 as they are. In another (fesetround, denormals flushed to 0) answers are wrong, and nothing tells it.
namespace flatray::api {

/// What is wrong with what a caller gave.
enum class Fault : std::uint8_t {
  none,
  sizes,       ///< arrays that go together differ in length
  not_finite,  ///< a coordinate is NaN or infinite, or a limit of t is NaN
  radius,      ///< a radius is negative
  degenerate,  ///< the numbers make no ellipse, arc, conic or Bezier curve, as Walls says
  empty,       ///< a polygon without a vertex
  not_convex,  ///< a polygon turns the other way at this vertex, or winds round twice
  no_such,     ///< no wall or body has the number given
  direction,   ///< a direction is zero where a ray must lead somewhere
  full         ///< no number is left for another wall or body
};

/// The fault in words: "a coordinate is NaN or infinite".
const char* words(Fault fault);

/// Whether a call did what was asked.
///
/// Gives   the fault, and the first entry that has it; of `sizes` and `full` the entry is 0. A call
///         with a fault has written nothing and changed nothing.
/// Error   std::bad_alloc is thrown where memory runs out. The object that the call was changing
///         may then only be destroyed or assigned to.
struct [[nodiscard]] Status {
  Fault fault = Fault::none;
  std::size_t entry = 0;

  explicit operator bool() const { return fault == Fault::none; }
};

}  // namespace flatray::api
