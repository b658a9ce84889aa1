#include "app/options/resource_limits.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include "app/interrupt.h"
#include "app/options/option_values.h"
#include "base/number_text.h"

namespace flatray {
namespace {

// Below the program does not even say what is wrong.
constexpr double kLeastMemory = 0x1p24;

// "2G", of powers of 1024.
Result<double> parse_bytes(std::string text, const Place& where) {
  constexpr std::string_view kUnits = "KMGT";
  double unit = 1;
  if (const std::size_t at = text.empty() ? kUnits.npos : kUnits.find(text.back());
      at != kUnits.npos) {
    for (std::size_t i = 0; i <= at; ++i) unit *= 1024;
    text.pop_back();
  }
  const auto number = parse_number(text);
  if (number && *number * unit >= kLeastMemory && *number * unit <= 0x1p60) return *number * unit;
  return usage_error(where, "is not a size of 16M or more", "say 500M, 2G or 2147483648");
}

rlimit limit_of_data() {
  rlimit limit{};
  ::getrlimit(RLIMIT_DATA, &limit);
  return limit;
}

}  // namespace

void ResourceLimits::rows(OptionTable& row) {
  row("--max-seconds S", "end after S seconds with what is done, exit code 124", seconds,
      time_up_to(1e9));
  row("--max-memory BYTES", "take no more memory, as 500M or 2G, exit code 124 beyond", bytes,
      &parse_bytes);
}

void limit_resources(const ResourceLimits& limits) {
  if (limits.bytes) {
    rlimit limit = limit_of_data();
    limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(*limits.bytes));
    ::setrlimit(RLIMIT_DATA, &limit);
  }
  if (limits.seconds) limit_seconds(*limits.seconds);
}

std::uint64_t memory_limit() { return limit_of_data().rlim_cur; }

Result<void> expect_memory(const Arguments& arguments, double bytes, const std::string& what,
                           const std::string& remedy) {
  if (bytes <= static_cast<double>(memory_limit())) return {};
  return fail(arguments.where("max-memory"), fmt::format("{} takes {:.0f} MB", what, bytes / 1e6),
              "allow more, or " + remedy);
}

int out_of_memory_code() {
  constexpr int kInternalError = 70;
  return memory_limit() == RLIM_INFINITY ? kInternalError : kOverLimit;
}

}  // namespace flatray
