#include "app/help/version.h"

#include <fmt/core.h>

#include "app/options/backend_choice.h"
#include "base/isa.h"

namespace flatray {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "clang " __clang_version__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

std::string tiers() {
  std::string names;
  for (const Isa isa : available_isas())
    names += (names.empty() ? "" : ", ") + std::string(isa_name(isa));
  return names;
}

}  // namespace

// The build passes these (CMakeLists.txt of this folder).
const char* const kVersion = FLATRAY_VERSION;

std::string version_text() {
  return fmt::format(
      "flatray {}\n"
      "built with     {}, {}\n"
      "isa            {} running; this machine has {}\n"
      "features       {}\n"
      "libraries      {}\n"
      "back ends      {}\n",
      kVersion, kCompiler, FLATRAY_BUILD_TYPE, isa_name(active_isa()), tiers(), FLATRAY_FEATURES,
      FLATRAY_LIBRARIES, backends_text());
}

}  // namespace flatray
