#include "scene/reading/scene_desc.h"

#include <algorithm>
#include <iterator>

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
  static constexpr const char* kNames[] = {"a truth value", "a number", "a string",
                                           "an array",      "a table",  "a date"};
  static_assert(std::size(kNames) == static_cast<std::size_t>(Value::Kind::date) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view source_text(const Value& value) {
  if (!value.where) return {};
  const std::string_view text = value.where.source->text();
  return text.substr(std::min(value.where.offset, text.size()), value.where.length);
}

Value built_in_number(double finite) { return built_in_numbers({&finite, 1}).front(); }

std::vector<Value> built_in_numbers(std::span<const double> finite) {
  std::string digits;
  std::vector<std::size_t> ends;
  for (const double number : finite) ends.push_back((digits += number_text(number)).size());
  const auto source = std::make_shared<const SourceText>("built in", std::move(digits));
  std::vector<Value> values;
  values.reserve(finite.size());
  for (std::size_t begin = 0; const std::size_t end : ends) {
    values.push_back({Value::Kind::number, {source, begin, end - begin}, {}, {}, {}});
    begin = end;
  }
  return values;
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

TextOrder::TextOrder(const SceneDesc& desc) {
  std::uint64_t end = 0;
  for (const SourcePtr& source : desc.sources) {
    before_.emplace(source.get(), end);
    end += source->text().size() + 1;
  }
  for (const OptionText& option : desc.options) {
    const Inserted* other = find(option.replaces.source.get());
    const std::uint64_t at = other != nullptr  ? other->at
                             : option.replaces ? in_files(option.replaces)
                                               : end++;
    options_.push_back({option, at});
  }
}

const TextOrder::Inserted* TextOrder::find(const SourceText* option) const {
  const auto found = std::ranges::find_if(
      options_, [&](const Inserted& one) { return one.text.source.get() == option; });
  return found == options_.end() ? nullptr : &*found;
}

std::uint64_t TextOrder::in_files(const Place& place) const {
  const auto before = before_.find(place.source.get());
  return place.offset + (before == before_.end() ? 0 : before->second);
}

// As if each option's text stood in the files: what follows comes so much later.
std::uint64_t TextOrder::at(const Place& place) const {
  const Inserted* option = find(place.source.get());
  if (option != nullptr && option->text.replaces)
    return at(option->text.replaces) + place.offset - option->text.begin;
  const std::uint64_t first = option != nullptr ? option->at : in_files(place);
  std::uint64_t at = option != nullptr ? first + place.offset : first;
  for (const Inserted& other : options_)
    if (other.at < first) at += other.size();
  return at;
}

}  // namespace flatray
