#include "base/isa.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace flatray {
namespace {

bool runs(Isa isa) {
#if defined(__x86_64__)
  switch (isa) {
    case Isa::avx512:
      return runs(Isa::avx2) && __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("avx512bw");
    case Isa::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Isa::baseline:
    case Isa::portable:
      return true;
  }
#endif
  return isa == Isa::portable;
}

}  // namespace

const char* isa_name(Isa isa) {
  static constexpr const char* kNames[] = {"portable", "baseline", "avx2", "avx512"};
  return of_tier(kNames, isa);
}

std::vector<Isa> available_isas() {
  std::vector<Isa> isas;
  std::copy_if(std::begin(kAllIsas), std::end(kAllIsas), std::back_inserter(isas), runs);
  return isas;
}

Result<Isa> usable_isa(std::string_view name, const Place& where) {
  for (const Isa isa : kAllIsas) {
    if (name != isa_name(isa)) continue;
    if (runs(isa)) return isa;
    return fail(where, fmt::format("this machine cannot run '{}'", name),
                fmt::format("the fastest here is {}", isa_name(available_isas().back())),
                Trouble::unavailable);
  }
  return fail(where, fmt::format("'{}' is not an instruction-set tier", name),
              "say portable, baseline, avx2 or avx512", Trouble::usage);
}

Result<Isa> chosen_isa() {
  const char* wanted = std::getenv("FLATRAY_ISA");
  if (wanted == nullptr || *wanted == '\0') return available_isas().back();
  return usable_isa(wanted, named_place("FLATRAY_ISA"));
}

Isa active_isa() {
  static const Isa isa = chosen_isa().value_or(available_isas().back());
  return isa;
}

}  // namespace flatray
