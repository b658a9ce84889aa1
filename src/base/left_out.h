#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostic.h"

namespace flatray {

/// What this build was configured without: optional packages by the names of their options ("GL",
/// "MPFR", "EMBREE"), registered entries as folder/name ("shapes/circle").
std::span<const std::string_view> left_out_of_build();

/// Of a word that this build does not know, whether others do: where its entry `<kind>s/<word>` is left
/// out, the mistake (Trouble::unavailable) to be told in place of a misspelt word.
std::optional<Diagnostic> if_left_out(const Place& where, std::string_view kind,
                                      std::string_view word);

}  // namespace flatray
