#pragma once
#include <optional>

#include "app/options/arguments.h"
#include "render/view.h"

namespace flatray {

/// What --view may begin with.
std::vector<std::string> view_names();
inline constexpr Option kViewOption = {
    "view",
    '\0',
    "VIEW",
    "instead of a picture one ray a pixel: hits, depth, intervals, visibility:x,y",
    OptionKind::text,
    &view_names};
/// The view that --view names and the tracer that --tracer does; nullopt without --view.
/// Error   Trouble::usage.
Result<std::optional<ViewRequest>> chosen_view(const Arguments& arguments);

}  // namespace flatray
