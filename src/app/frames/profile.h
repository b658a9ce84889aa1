#pragma once
#include <span>
#include <string>

#include "app/options/arguments.h"
#include "study/accuracy/accuracy.h"

namespace flatray {

/// What `accuracy --profile` writes, for `render --error` and `--time` to choose from: a line of JSON
/// about the scene, then one for each measured way to draw it.
std::string profile_text(const Scene& scene, std::span<const ChoiceReport> reports);

inline constexpr Option kProfileOption = {"profile", '\0', "FILE",
                                          "written by flatray accuracy: choose by it how to draw"};
inline constexpr Option kErrorOption = {
    "error", '\0', "E",
    "light: rays until its relative error is E; with --profile: the cheapest way to draw so"};
inline constexpr Option kTimeOption = {
    "time", '\0', "S",
    "light: rays for S seconds a frame; with --profile: the nearest way to draw that takes S"};

/// The arguments with --backend, --samples and -D as the profile they name says; as they are
/// without one. Says on standard error what it has chosen, unless --quiet.
///
/// Error   Trouble::usage where options do not go together; Trouble::invalid, with the line of the
///         profile, where that is none, is of another scene, or has nothing so good.
Result<Arguments> with_profile(const Arguments& arguments);

}  // namespace flatray
