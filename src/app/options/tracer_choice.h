#pragma once
#include "app/options/option_table.h"
#include "precise/certified_orbit.h"
#include "render/view.h"
#include "trace/tracer.h"

namespace flatray {

/// What --tracer may be.
std::vector<std::string> tracer_names();

/// A tracer by its name.
/// Error   Trouble::usage for a name unknown, Trouble::unavailable where this machine lacks it.
Result<const Tracer*> usable_tracer(const std::string& name, const Place& where);

/// --tracer: the one that is named; null without it.
void row_of_tracer(OptionTable& row, const Tracer*& tracer);

/// How nearest walls are found and orbits followed.
struct Precision {
  bool certified = false;
  unsigned most_bits = kMostBits;  ///< of a certified one
  const Tracer* tracer = nullptr;  ///< what finds the walls; null: the one of choice

  void rows(OptionTable& row);
};

/// Refuses a --tracer that cannot tell what --view asks.
void expect_tracer_of_view(OptionTable& row, const Tracer* tracer, const View& view);

}  // namespace flatray
