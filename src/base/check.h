#pragma once
#include <string>

#include "flatray/float_mode.h"

namespace flatray {

/// Ends the program on a bug of ours: prints the condition, its place and `values` to stderr, then
/// aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line,
                               const std::string& values = {});

/// Marks a point no input can reach.
[[noreturn]] void unreachable();

}  // namespace flatray

/// Checks an invariant of our own, in every build; never bad input. A second argument is a message
/// with the values.
#define FLATRAY_CHECK(condition, ...) \
  (static_cast<bool>(condition)       \
       ? void()                       \
       : ::flatray::check_failed(#condition, __FILE__, __LINE__ __VA_OPT__(, ) __VA_ARGS__))

/// The same in hot loops: debug builds only.
#ifdef NDEBUG
#define FLATRAY_DCHECK(...) void()
#else
#define FLATRAY_DCHECK(...) FLATRAY_CHECK(__VA_ARGS__)
#endif
