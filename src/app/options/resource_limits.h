#pragma once
#include <cstdint>

#include "app/options/option_table.h"

namespace flatray {

/// What every verb may use at most; on top of what each verb counts by itself (flatray help
/// limits).
struct ResourceLimits {
  std::optional<double> seconds, bytes;

  void rows(OptionTable& row);
};

/// Sets the limits that are given, for the program from now on.
void limit_resources(const ResourceLimits& limits);

/// Bytes the program may still take as was said, or as the shell says; very many without a limit.
std::uint64_t memory_limit();

/// An error where `what` ("a picture of 4x4") takes more bytes than that.
Result<void> expect_memory(const Arguments& arguments, double bytes, const std::string& what,
                           const std::string& remedy);

/// Exit code where memory has run out: that of an exceeded limit if there is one.
int out_of_memory_code();

}  // namespace flatray
