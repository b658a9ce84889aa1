#include "app/options/option_table.h"

#include <fmt/core.h>

#include <bit>
#include <limits>
#include <string>

#include "app/options/option_values.h"
#include "base/number_text.h"

namespace flatray {
namespace {

// Large powers of two as such: nobody reads 1099511627776.
std::string shown(std::uint64_t value) {
  constexpr int kReadable = 20;
  const int power = std::countr_zero(value + 1);
  if (std::has_single_bit(value) && std::countr_zero(value) > kReadable)
    return fmt::format("2^{}", std::countr_zero(value));
  if (std::has_single_bit(value + 1) && power > kReadable) return fmt::format("2^{}-1", power);
  return std::to_string(value);
}

// "-j, --jobs N".
Option option_of(std::string_view spelling, std::string help, Words words) {
  const std::size_t name = spelling.find("--") + 2;
  const std::size_t end = std::min(spelling.find(' ', name), spelling.size());
  const std::string_view metavar = spelling.substr(std::min(end + 1, spelling.size()));
  return {std::string(spelling.substr(name, end - name)),
          name > 2 ? spelling[1] : '\0',
          std::string(metavar),
          std::move(help),
          metavar.empty() ? OptionKind::flag : OptionKind::text,
          words};
}

}  // namespace

std::string range_text(std::uint64_t low, std::uint64_t high, const std::string& otherwise) {
  const bool any = low == 0 && high == std::numeric_limits<std::uint64_t>::max();
  const std::string range = any ? "" : fmt::format("{} to {}", shown(low), shown(high));
  const std::string last = otherwise.empty() ? "" : "default " + otherwise;
  return fmt::format(" ({}{}{})", range, range.empty() || last.empty() ? "" : ", ", last);
}

Result<std::uint64_t> whole_of(const std::string& text, const Place& where, std::uint64_t low,
                               std::uint64_t high) {
  const std::optional<std::uint64_t> value = parse_whole(text);
  // What is larger than the largest is parsed as that.
  const bool is_larger = value == ~std::uint64_t{0} &&
                         text.substr(text.find_first_not_of('0')) != std::to_string(*value);
  if (value && *value >= low && *value <= high && !is_larger) return *value;
  return usage_error(where,
                     value ? fmt::format("{} is out of range", text)
                           : fmt::format("'{}' is not a whole number", text),
                     fmt::format("say a number from {} to {}", low, high));
}

std::string default_text(double value) { return number_text(value); }

std::string OptionTable::operand(std::size_t index) const {
  if (given_ == nullptr || index >= given_->operands().size()) return {};
  return given_->operands()[index];
}

void OptionTable::operator()(const char* spelling, std::string help, Words words) {
  options_.push_back(option_of(spelling, std::move(help), words));
}

void OptionTable::operator()(const char* spelling, std::string help, bool& member) {
  (*this)(spelling, std::move(help));
  member = member || has(options_.back().name);
}

void OptionTable::problem(std::string_view name, std::string message, std::string hint) {
  if (given_ != nullptr)
    keep({{given_->where(name), std::move(message), std::move(hint), Trouble::usage}});
}

void OptionTable::excludes(std::string_view name, std::initializer_list<const char*> others) {
  for (const char* other : others)
    if (has(name) && has(other))
      problem(other, fmt::format("does not go with --{}", name), "leave one of them out");
}

void OptionTable::keep(const Diagnostics& problems) {
  if (problems_ != nullptr) problems_->insert(problems_->end(), problems.begin(), problems.end());
}

}  // namespace flatray
