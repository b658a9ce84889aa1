#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace flatray {

/// Instruction-set tiers of the kernels, slowest first. All of them give the same bits.
enum class Isa { portable, baseline, avx2, avx512 };

inline constexpr Isa kAllIsas[] = {Isa::portable, Isa::baseline, Isa::avx2, Isa::avx512};

const char* isa_name(Isa isa);
/// Tiers this machine can run, slowest first.
std::vector<Isa> available_isas();
/// The tier of a name.
/// Error   an unknown name, or a tier this machine lacks (Trouble::unavailable).
Result<Isa> usable_isa(std::string_view name, const Place& where);
/// The tier named by the environment variable FLATRAY_ISA, else the fastest this machine runs.
/// Error   as of usable_isa.
Result<Isa> chosen_isa();
/// `chosen_isa()` read once; a wrong FLATRAY_ISA counts as unset here (main has refused it before).
Isa active_isa();

/// The entry of a tier in a table of all tiers, slowest first; of portable where the build lacks it.
template <class Entry, std::size_t count>
constexpr Entry of_tier(const Entry (&table)[count], Isa isa) {
  const auto tier = static_cast<std::size_t>(isa);
  return table[tier < count ? tier : 0];
}

}  // namespace flatray
