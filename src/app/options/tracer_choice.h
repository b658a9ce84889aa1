#pragma once
#include "app/options/arguments.h"
#include "precise/certified_orbit.h"
#include "render/view.h"
#include "trace/tracer.h"

namespace flatray {

/// What --tracer may be.
std::vector<std::string> tracer_names();

inline constexpr Option kTracerOption = {
    "tracer",         '\0',         "NAME", "what finds hits; the exact ones give the same",
    OptionKind::text, &tracer_names};

/// The tracer that --tracer names, nullptr without it.
/// Error   Trouble::usage for a name unknown, Trouble::unavailable where this machine lacks it.
Result<const Tracer*> chosen_tracer(const Arguments& arguments);

/// How nearest walls are found and orbits followed.
struct Precision {
  bool certified = false;
  unsigned most_bits = kMostBits;  ///< of a certified one
  const Tracer* tracer = nullptr;  ///< what finds the walls; null: the one of choice
};
inline constexpr Option kBitsOption = {"bits", '\0', "N",
                                       "most bits of a certified orbit (default 65536)"};
/// What --precision, --bits and --tracer say. Error   that of `chosen_tracer`, or Trouble::usage.
Result<Precision> chosen_precision(const Arguments& arguments);

/// Whether --tracer can tell what --view asks. Error   Trouble::usage.
Result<void> check_tracer_of_view(const Arguments& arguments, const Tracer* tracer,
                                  const View& view);
/// The tracer itself, where this machine has it.
Result<const Tracer*> usable_tracer(const std::string& name, const Place& where);

}  // namespace flatray
