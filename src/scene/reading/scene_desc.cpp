#include "scene/reading/scene_desc.h"

#include <algorithm>

#include "base/check.h"
#include "base/number_text.h"

namespace flatray {

const Member* Value::find(std::string_view key) const {
  for (const Member& member : members)
    if (member.key == key) return &member;
  return nullptr;
}

Member* Value::find(std::string_view key) {
  return const_cast<Member*>(static_cast<const Value*>(this)->find(key));
}

bool is_curve(const Value& value) {
  return value.kind == Value::Kind::table && value.find("keys") != nullptr;
}

bool has_curve(const Value& value) {
  return is_curve(value) || std::ranges::any_of(value.items, &has_curve) ||
         std::ranges::any_of(value.members,
                             [](const Member& member) { return has_curve(member.value); });
}

const char* kind_name(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::boolean:
      return "a truth value";
    case Value::Kind::number:
      return "a number";
    case Value::Kind::string:
      return "a string";
    case Value::Kind::array:
      return "an array";
    case Value::Kind::table:
      return "a table";
    case Value::Kind::date:
      return "a date";
  }
  unreachable();
}

std::string_view source_text(const Value& value) {
  if (!value.where) return {};
  const std::string_view text = value.where.source->text();
  return text.substr(std::min(value.where.offset, text.size()), value.where.length);
}

Value built_in_number(double finite) {
  std::string digits = number_text(finite);
  const std::size_t length = digits.size();
  return {Value::Kind::number,
          {std::make_shared<const SourceText>("built in", std::move(digits)), 0, length},
          {},
          {},
          {}};
}

Value string_value(Place where, std::string text) {
  return {Value::Kind::string, std::move(where), std::move(text), {}, {}};
}

Value table_value(Place where, std::vector<Member> members) {
  return {Value::Kind::table, std::move(where), {}, {}, std::move(members)};
}

Value array_value(Place where, std::vector<Value> items) {
  return {Value::Kind::array, std::move(where), {}, std::move(items), {}};
}

TextOrder::TextOrder(const SceneDesc& desc) : replaced_(desc.replaced) {
  for (const SourcePtr& source : desc.sources) {
    before_.emplace(source.get(), end_);
    end_ += source->text().size() + 1;
  }
}

std::uint64_t TextOrder::at(const Place& place) const {
  const SourceText* const source = place.source.get();
  if (source != nullptr && source->kind() == SourceText::Kind::option) {
    const auto replaced = replaced_.find(source);
    return replaced == replaced_.end() ? end_ : at(replaced->second);
  }
  const auto before = before_.find(source);
  return place.offset + (before == before_.end() ? 0 : before->second);
}

}  // namespace flatray
