#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace flatray {

void check_failed(const char* condition, const char* file, int line, const std::string& values) {
  std::fprintf(stderr, "flatray: internal error: %s does not hold (%s:%d)%s%s\n", condition, file,
               line, values.empty() ? "" : ": ", values.c_str());
  std::abort();
}

void unreachable() { check_failed("unreachable", __FILE__, __LINE__); }

}  // namespace flatray
