#pragma once
#include <fmt/core.h>

#include <concepts>
#include <string>
#include <string_view>

namespace flatray {

/// "1 ray", "3 rays", "0 rays": a number of things as a reader says it. A word whose plural does
/// not end in s alone needs both forms: counted(n, "entry", "entries").
inline std::string counted(std::integral auto count, std::string_view one,
                           std::string_view several = {}) {
  if (count == 1) return fmt::format("1 {}", one);
  if (!several.empty()) return fmt::format("{} {}", count, several);
  return fmt::format("{} {}s", count, one);
}

}  // namespace flatray
