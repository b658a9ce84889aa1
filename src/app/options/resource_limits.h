#pragma once
#include <cstdint>

#include "app/options/arguments.h"

namespace flatray {

/// What every verb may use at most; on top of what each verb counts by itself (flatray help limits).
inline constexpr Option kMaxSecondsOption = {
    "max-seconds", '\0', "S", "end after S seconds with what is done, exit code 124"};
inline constexpr Option kMaxMemoryOption = {
    "max-memory", '\0', "BYTES", "take no more memory, as 500M or 2G, exit code 124 beyond"};

/// Sets the limits that are given, for the program from now on.
/// Error   Trouble::usage.
Result<void> limit_resources(const Arguments& arguments);

/// Bytes the program may still take as was said, or as the shell says; very many without a limit.
std::uint64_t memory_limit();

/// An error where `what` ("a picture of 4x4") takes more bytes than that.
Result<void> expect_memory(const Arguments& arguments, double bytes, const std::string& what,
                           const std::string& remedy);

/// Exit code where memory has run out: that of an exceeded limit if there is one.
int out_of_memory_code();

}  // namespace flatray
