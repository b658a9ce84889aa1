#pragma once
#include <fmt/core.h>

#include "base/counted.h"
#include "scene/keys/builder.h"

namespace flatray {

/// One key of a table that describes a T, and how it is read.
template <class T>
struct Key {
  KeyInfo info;
  void (*read)(Builder&, const Field&, T&);
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
                std::span<const Key<T>> keys, T& target) {
  for (const Key<T>& key : keys)
    if (const Member* member = table.find(key.info.name))
      key.read(builder, {key_path(name, key.info.name), member->value, key.info.takes}, target);
}

/// Reads a table into `target`: unknown keys and missing ones are problems, the others are read in
/// the order of `keys`, so that a key may build on those before it.
template <class T>
void read_keys(Builder& builder, const Value& table, const std::string& name,
               std::span<const Key<T>> keys, T& target) {
  if (!builder.in.is({name, table, "{ ... }"}, Value::Kind::table, "a table")) return;
  check_keys(table, name, key_infos(keys), builder.in.problems);
  read_again(builder, table, name, keys, target);
}

template <class Pointer>
struct MemberOf;
template <class T, class M>
struct MemberOf<M T::*> {
  using Owner = T;
  using Type = M;
};
template <class T, class M>
struct MemberOf<std::optional<M> T::*> {
  using Owner = T;
  using Type = M;
};

/// Reads a number, point, string or colour into a member.
template <auto Pointer>
void set(Builder& builder, const Field& field,
         typename MemberOf<decltype(Pointer)>::Owner& target) {
  using Type = typename MemberOf<decltype(Pointer)>::Type;
  if (const auto value = builder.in.as(field, static_cast<const Type*>(nullptr)))
    target.*Pointer = *value;
}

/// Reads degrees into radians.
template <auto Pointer>
void set_angle(Builder& builder, const Field& field,
               typename MemberOf<decltype(Pointer)>::Owner& target) {
  if (const auto degrees = builder.in.number(field)) target.*Pointer = radians(*degrees);
}

/// Reads a whole number in [low, high].
template <auto Pointer, std::int64_t low, std::int64_t high>
void set_integer(Builder& builder, const Field& field,
                 typename MemberOf<decltype(Pointer)>::Owner& target) {
  using Type = typename MemberOf<decltype(Pointer)>::Type;
  if (const auto value = builder.in.integer(field, low, high))
    target.*Pointer = static_cast<Type>(*value);
}

/// Reads one of a list of words.
template <auto Pointer, const auto& words>
void set_word(Builder& builder, const Field& field,
              typename MemberOf<decltype(Pointer)>::Owner& target) {
  using Type = typename MemberOf<decltype(Pointer)>::Type;
  if (const auto value = builder.in.word<Type>(field, words)) target.*Pointer = *value;
}

/// Calls `read(element i)` for each element of an array of tables.
template <class Read>
void each_table(Builder& builder, const Field& field, const Read& read) {
  const std::size_t limit = builder.limits.max_entities;
  if (!builder.in.is(field, Value::Kind::array, "an array of tables")) return;
  if (field.value.items.size() > limit)
    return builder.in.problem(
        field.value.where,
        fmt::format("{} has {}", field.name, counted(field.value.items.size(), "entry", "entries")),
        fmt::format("the limit is {}; --max-entities raises it", limit));
  for (const Value& item : field.value.items) read(item);
}

}  // namespace flatray
