#pragma once
#include "app/arguments.h"
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
/// Whether --tracer can tell what --view asks. Error   Trouble::usage.
Result<void> check_tracer_of_view(const Arguments& arguments, const Tracer* tracer,
                                  const View& view);
/// The tracer itself, where this machine has it.
Result<const Tracer*> usable_tracer(const std::string& name, const Place& where);

}  // namespace flatray
