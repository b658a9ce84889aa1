// Coverage against exact clipping on many seeded polygons: coverage_check --count N --seed S.
// Exit 0: every pixel within what PixelArea says. N polygons are spread over the families.
#include <cstring>
#include <string>

#include "base/number_text.h"
#include "base/parallel.h"
#include "render/coverage_families.h"

using namespace flatray;
using namespace flatray::coverage_check;

namespace {

std::uint64_t option(int argc, char** argv, const char* name, std::uint64_t fallback) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], name) == 0)
      return static_cast<std::uint64_t>(parse_number(argv[i + 1]).value_or(0));
  return fallback;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t count = option(argc, argv, "--count", 700);
  const std::uint64_t seed = option(argc, argv, "--seed", 1);
  std::array<Tally, kFamilies.size()> tallies;
  parallel_for(kFamilies.size(), hardware_threads(), [&](std::size_t i) {
    tallies[i] = run_family(kFamilies[i], seed, share_of(kFamilies[i], count));
  });
  bool right = true;
  for (std::size_t i = 0; i < kFamilies.size(); ++i) {
    fmt::print("{}\n", line(kFamilies[i], tallies[i]));
    if (!tallies[i].first_mismatch.empty()) fmt::print("  {}\n", tallies[i].first_mismatch);
    right = right && tallies[i].mismatches == 0;
  }
  fmt::print("seed {}: {}\n", seed, right ? "every pixel right" : "DIFFERENT");
  return right ? 0 : 1;
}
