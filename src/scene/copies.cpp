#include "scene/copies.h"

#include "scene/keys.h"

namespace flatray {
namespace {

std::string count_text(std::uint64_t count) {
  return count == kUncounted ? std::string("more than 10^18") : std::to_string(count);
}

}  // namespace

std::optional<Copies> read_copies(Builder& builder, const Value& table, const char* what,
                                  std::size_t before) {
  Copies copies;
  const Member* repeat = table.find("repeat");
  if (repeat != nullptr) {
    copies.repeat = read_repeat(builder, {"repeat", repeat->value, "{ KIND = { ... } }"});
    if (!copies.repeat) return std::nullopt;
    copies.each = copy_count(*copies.repeat);
  }
  copies.total = copies.each;
  const std::uint64_t limit = builder.limits.max_entities;
  if (copies.total <= limit && copies.total + before <= limit) return copies;
  builder.in.problem(
      repeat == nullptr ? table.where : repeat->where,
      fmt::format("{} stands for {}, after {} before it", what, count_text(copies.total), before),
      fmt::format("the limit is {}; --max-entities raises it", limit));
  return std::nullopt;
}

}  // namespace flatray
