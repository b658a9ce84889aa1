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

Result<double> seconds(const Arguments& arguments, const std::string& text) {
  const auto seconds = parse_seconds(text);
  if (seconds && *seconds > 0 && *seconds <= 1e9) return *seconds;
  return usage_error(arguments.where("max-seconds"), "is not a time above 0", "say 60 or 1.5s");
}

// "2G", of powers of 1024.
Result<double> bytes(const Arguments& arguments, std::string text) {
  constexpr std::string_view kUnits = "KMGT";
  double unit = 1;
  if (const std::size_t at = text.empty() ? kUnits.npos : kUnits.find(text.back());
      at != kUnits.npos) {
    for (std::size_t i = 0; i <= at; ++i) unit *= 1024;
    text.pop_back();
  }
  const auto number = parse_number(text);
  if (number && *number * unit >= kLeastMemory && *number * unit <= 0x1p60) return *number * unit;
  return usage_error(arguments.where("max-memory"), "is not a size of 16M or more",
                     "say 500M, 2G or 2147483648");
}

}  // namespace

Result<void> limit_resources(const Arguments& arguments) {
  if (const auto text = arguments.text("max-memory")) {
    const auto most = bytes(arguments, *text);
    if (!most) return tl::unexpected(most.error());
    rlimit limit{};
    ::getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(*most));
    ::setrlimit(RLIMIT_DATA, &limit);
  }
  if (const auto text = arguments.text("max-seconds")) {
    const auto most = seconds(arguments, *text);
    if (!most) return tl::unexpected(most.error());
    limit_seconds(*most);
  }
  return {};
}

std::uint64_t memory_limit() {
  rlimit limit{};
  ::getrlimit(RLIMIT_DATA, &limit);
  return limit.rlim_cur;
}

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
