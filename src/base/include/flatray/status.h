#pragma once
#include <cstddef>
#include <cstdint>

/// What programs of others call: `<flatray/trace.h>`, `<flatray/collide.h>`,
/// `<flatray/transport.h>` and `<flatray/picture.h>`.
namespace flatray::api {

/// What is wrong with what a caller gave.
enum class Fault : std::uint8_t {
  none,
  sizes,       ///< arrays that go together differ in length
  not_finite,  ///< a coordinate is NaN or infinite, or a limit of t is NaN
  radius,      ///< a radius is negative
  degenerate,  ///< an ellipse, arc or Bezier curve that is none, as Walls says
  empty,       ///< a polygon without a vertex
  not_convex,  ///< a polygon turns the other way at this vertex, or winds round twice
  no_such,     ///< the number of a wall or body that is not there
  direction,   ///< a direction is zero where a ray must lead somewhere
  full         ///< more walls or bodies than numbers
};

/// A fault in words, as "a coordinate is NaN or infinite".
const char* words(Fault fault);

/// Whether a call did what was asked.
///
/// Gives   where there is a fault, the first entry that has it (0 of `sizes` and `full`). Such a call
///         has written nothing and changed nothing.
/// Error   memory that ends is thrown as std::bad_alloc; what was being changed may then only be
///         destroyed or assigned to.
struct [[nodiscard]] Status {
  Fault fault = Fault::none;
  std::size_t entry = 0;

  explicit operator bool() const { return fault == Fault::none; }
};

}  // namespace flatray::api
