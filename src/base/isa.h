#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace flatray {

/// Instruction-set tiers of the kernels, slowest first. All of them give the same bits.
enum class Isa { portable, baseline, avx2, avx512 };

const char* isa_name(Isa isa);
/// Tiers this machine can run, slowest first.
std::vector<Isa> available_isas();
/// The tier named by the environment variable FLATRAY_ISA, else the fastest this machine runs.
/// Error   an unknown name, or a tier this machine lacks (Trouble::unavailable).
Result<Isa> chosen_isa();
/// `chosen_isa()` read once; a wrong FLATRAY_ISA counts as unset here (main has refused it before).
Isa active_isa();

}  // namespace flatray
