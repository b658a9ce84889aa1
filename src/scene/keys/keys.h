#pragma once
#include <fmt/core.h>

#include <type_traits>

#include "base/counted.h"
#include "scene/keys/builder.h"

namespace flatray {

/// One key of a table that describes a T, and how it is read.
template <class T>
struct Key {
  KeyInfo info;
  void (*read)(Builder&, const Field&, T&);
  bool may_change = false;  ///< with time
};

template <class T>
std::vector<KeyInfo> key_infos(std::span<const Key<T>> keys) {
  std::vector<KeyInfo> infos;
  for (const Key<T>& key : keys) infos.push_back(key.info);
  return infos;
}

/// "film.size"; the keys of the scene itself stand alone.
inline std::string key_path(const std::string& table, const char* key) {
  return table == "scene" ? key : table + "." + key;
}

/// Reads a table whose keys have been checked, for another copy of it.
template <class T>
void read_again(Builder& builder, const Value& table, const std::string& name,
                std::type_identity_t<std::span<const Key<T>>> keys, T& target) {
  const bool in_what_changes = builder.may_change;
  for (const Key<T>& key : keys) {
    const Member* member = table.find(key.info.name);
    if (member == nullptr) continue;
    builder.may_change = in_what_changes || key.may_change;
    key.read(builder, {key_path(name, key.info.name), member->value, key.info.takes}, target);
  }
  builder.may_change = in_what_changes;
}

/// Reads a table into `target`: unknown keys and missing ones are problems, the others are read in
/// the order of `keys`, so that a key may build on those before it.
/// Gives   whether there was no problem.
template <class T>
bool read_keys(Builder& builder, const Value& table, const std::string& name,
               std::type_identity_t<std::span<const Key<T>>> keys, T& target) {
  if (!builder.in.is({name, table, "{ ... }"}, Value::Kind::table, "a table")) return false;
  const std::size_t problems = builder.in.problems.size();
  check_keys(table, name, key_infos<T>(keys), builder.in.problems);
  read_again(builder, table, name, keys, target);
  return builder.in.problems.size() == problems;
}

template <class T, class M>
T owner_of(M T::*);
template <class T, class M>
M type_of(M T::*);
template <class T, class M>
M type_of(std::optional<M> T::*);
template <auto Pointer>
using OwnerOf = decltype(owner_of(Pointer));
template <auto Pointer>
using TypeOf = decltype(type_of(Pointer));

/// Reads a number, point, box, truth value, string or colour into a member, of a T also that of its
/// base.
template <auto Pointer, class T = OwnerOf<Pointer>>
void set(Builder& builder, const Field& field, T& target) {
  if (const auto value = builder.in.as(field, static_cast<const TypeOf<Pointer>*>(nullptr)))
    target.*Pointer = *value;
}

/// What a number must be, and what is said of one that is not: "fps is not above 0".
struct NumberRule {
  bool (*holds)(double);
  const char* broken;  ///< "is not above 0"
  const char* hint;
};

constexpr bool is_above_zero(double number) { return number > 0; }

/// Reads a number of which `rule` holds into a member.
template <auto Pointer, const NumberRule& rule>
void set_number(Builder& builder, const Field& field, OwnerOf<Pointer>& target) {
  const auto number = builder.in.number(field);
  if (number && !rule.holds(*number))
    builder.in.problem(field, rule.broken, rule.hint);
  else if (number)
    target.*Pointer = *number;
}

/// Reads degrees into radians.
template <auto Pointer, class T = OwnerOf<Pointer>>
void set_angle(Builder& builder, const Field& field, T& target) {
  if (const auto degrees = builder.in.number(field)) target.*Pointer = radians(*degrees);
}

/// Reads a whole number in [low, high].
template <auto Pointer, std::int64_t low, std::int64_t high>
void set_integer(Builder& builder, const Field& field, OwnerOf<Pointer>& target) {
  if (const auto value = builder.in.integer(field, low, high))
    target.*Pointer = static_cast<TypeOf<Pointer>>(*value);
}

/// Reads one of a list of words.
template <auto Pointer, const auto& words>
void set_word(Builder& builder, const Field& field, OwnerOf<Pointer>& target) {
  if (const auto value = builder.in.word<TypeOf<Pointer>>(field, words)) target.*Pointer = *value;
}

/// Reads the name of an entity into its number.
template <auto Pointer>
void set_entity(Builder& builder, const Field& field, OwnerOf<Pointer>& target) {
  if (const auto entity = find_entity(builder, field)) target.*Pointer = *entity;
}

/// Calls `read(element i)` for each element of an array of tables.
template <class Read>
void each_table(Builder& builder, const Field& field, const Read& read) {
  const std::size_t limit = builder.limits.max_entities;
  if (!builder.in.is(field, Value::Kind::array, "an array of tables")) return;
  if (field.value.items.size() > limit)
    return builder.in.problem(
        field, fmt::format("has {}", counted(field.value.items.size(), "entry", "entries")),
        fmt::format("the limit is {}; --max-entities raises it", limit));
  for (const Value& item : field.value.items) read(item);
}

}  // namespace flatray
