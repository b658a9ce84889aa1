#include "scene/keys/copies.h"

#include "scene/reading/overrides.h"

namespace flatray {
namespace {

std::string count_text(std::uint64_t count) {
  return count == kUncounted ? std::string("more than 10^18") : std::to_string(count);
}

// The copies of a group by its name in the file; an unknown one is a problem.
std::optional<std::vector<std::uint32_t>> copies_of_group(Builder& builder, const Field& field) {
  const auto name = builder.in.string(field);
  if (!name) return std::nullopt;
  if (const auto found = builder.groups.find(*name); found != builder.groups.end())
    return found->second.empty() ? std::nullopt : std::optional(found->second);
  return builder.in.refuse(
      unknown_word(field.value.where, "group", *name, some_names(builder.groups)));
}

}  // namespace

std::optional<Copies> read_copies(Builder& builder, const Value& table, const CopiedTable& what) {
  Copies copies;
  const Member *repeat = table.find("repeat"), *group = table.find("group");
  if (group != nullptr) {
    auto groups =
        copies_of_group(builder, {key_path(what.name, "group"), group->value, "\"GROUP\""});
    if (!groups) return std::nullopt;
    copies.groups = std::move(*groups);
  }
  if (repeat != nullptr) {
    copies.repeat = read_repeat(builder, {"repeat", repeat->value, "{ grid = { ... } }"});
    if (!copies.repeat) return std::nullopt;
    copies.each = copy_count(*copies.repeat);
  }
  copies.total = saturating_product(copies.each, std::max<std::uint64_t>(copies.groups.size(), 1));
  const std::uint64_t limit = builder.limits.max_entities;
  if (copies.total <= limit && copies.total + what.before <= limit) return copies;
  const Member* cause = repeat != nullptr ? repeat : group;
  return builder.in.refuse(
      {cause == nullptr ? table.where : place_of_change(cause->value, cause->where),
       fmt::format("{} stands for {}, after {} before it", what.name, count_text(copies.total),
                   what.before),
       fmt::format("the limit is {}; --max-entities raises it", limit)});
}

std::string copy_suffix(const Builder& builder, const Copies& copies, std::uint64_t number) {
  std::string suffix;
  if (!copies.groups.empty()) suffix = builder.group_suffixes[copies.groups[number / copies.each]];
  if (copies.repeat) suffix += fmt::format(".{}", number % copies.each);
  return suffix;
}

}  // namespace flatray
