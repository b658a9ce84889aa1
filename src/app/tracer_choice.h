#pragma once
#include "app/arguments.h"
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
/// The tracer itself, where this machine has it.
Result<const Tracer*> usable_tracer(const std::string& name, const Place& where);

}  // namespace flatray
