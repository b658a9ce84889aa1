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

constexpr Isa kAllIsas[] = {Isa::portable, Isa::baseline, Isa::avx2, Isa::avx512};

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

Result<Isa> chosen_isa() {
  const std::vector<Isa> have = available_isas();
  const char* wanted = std::getenv("FLATRAY_ISA");
  if (wanted == nullptr || *wanted == '\0') return have.back();
  std::vector<std::string> names;
  for (const Isa isa : kAllIsas) {
    names.emplace_back(isa_name(isa));
    if (names.back() != wanted) continue;
    if (runs(isa)) return isa;
    return fail(named_place("FLATRAY_ISA"), fmt::format("this machine cannot run '{}'", wanted),
                fmt::format("the fastest here is {}", isa_name(have.back())), Trouble::unavailable);
  }
  return fail(named_place("FLATRAY_ISA"),
              fmt::format("'{}' is not an instruction-set tier", wanted),
              "say portable, baseline, avx2 or avx512", Trouble::usage);
}

Isa active_isa() {
  static const Isa isa = chosen_isa().value_or(available_isas().back());
  return isa;
}

}  // namespace flatray
