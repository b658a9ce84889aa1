#include "base/left_out.h"

#include <fmt/core.h>

#include <algorithm>

namespace flatray {

std::span<const std::string_view> left_out_of_build() {
  static constexpr std::string_view kNames[] = {
#define FLATRAY_LEFT_OUT(name) name,
#include "left_out.inc"
#undef FLATRAY_LEFT_OUT
      ""};
  return std::span(kNames).first(std::size(kNames) - 1);
}

std::optional<Diagnostic> if_left_out(const Place& where, std::string_view kind,
                                      std::string_view word) {
  const auto names = left_out_of_build();
  if (std::ranges::find(names, fmt::format("{}s/{}", kind, word)) == names.end())
    return std::nullopt;
  return Diagnostic{where, fmt::format("the {} '{}' is left out of this build", kind, word),
                    "configure it without FLATRAY_ONLY and FLATRAY_WITHOUT", Trouble::unavailable};
}

}  // namespace flatray
