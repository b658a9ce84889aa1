#pragma once
#include "scene/keys/keys.h"
#include "scene/repeat.h"

namespace flatray {

/// What one table of the scene stands for: copies by its `repeat`, in every copy of its group.
struct Copies {
  std::optional<Repeat> repeat;
  std::vector<std::uint32_t> groups;  ///< Scene::groups it stands in; empty: in none
  std::uint64_t each = 1;             ///< by its own repeat
  std::uint64_t total = 1;
};

/// A table that may be copied.
struct CopiedTable {
  const char* name;      ///< "entity"
  std::uint32_t number;  ///< in the names of its draws
  std::size_t before;    ///< how many things it adds to
};

/// Reads `repeat` and `group`; nothing is made yet.
/// Error   a total over LoadLimits::max_entities, among others.
std::optional<Copies> read_copies(Builder& builder, const Value& table, const CopiedTable& what);

/// What is added to the name of a copy: for each repeat it stands in, outermost first, a point and
/// the number of the copy from 0.
std::string copy_suffix(const Builder& builder, const Copies& copies, std::uint64_t number);

/// Reads a table into a T, with `name`, `at`, `angle`, `group` and `where`, and gives each copy of
/// it to `add(T&&, suffix of its name)`. What is wrong is told of one copy, and one is made all the
/// same.
template <class T, class Add>
void make_copies(Builder& builder, const Value& table, const CopiedTable& what,
                 std::span<const Key<T>> keys, const Add& add) {
  Reader& in = builder.in;
  const std::size_t before = in.problems.size();
  const Copies copies = read_copies(builder, table, what).value_or(Copies{});
  Draws draws(builder.scene.seed, what.number, table);
  in.draws = &draws;
  T first;
  first.where = table.where;
  const T blank = first;
  read_keys(builder, table, what.name, keys, first);
  const std::size_t problems = in.problems.size();
  std::size_t warnings = in.warnings.size();  // with those of the first copy
  const std::uint64_t total = problems == before && !builder.full ? copies.total : 1;
  for (std::uint64_t i = 0; i < total && in.problems.size() == problems; ++i) {
    draws.set_copy(i);
    T thing = draws.empty() || i == 0 ? first : blank;
    if (!draws.empty() && i > 0) read_again(builder, table, what.name, keys, thing);
    if (!copies.groups.empty()) thing.group = copies.groups[i / copies.each];
    if (copies.repeat) {
      const Copy copy = copy_of(*copies.repeat, i % copies.each, draws);
      thing.at += copy.at;
      thing.angle += copy.angle;
    }
    std::string suffix = copy_suffix(builder, copies, i);
    if (!thing.name.empty()) thing.name += suffix;
    add(std::move(thing), i, std::move(suffix));
    if (i == 0) warnings = in.warnings.size();
  }
  in.warnings.resize(warnings);
  in.draws = nullptr;
}

/// The keys that are read before the others, by `read_copies`.
template <class T>
void read_before(Builder&, const Field&, T&) {}
template <class T>
inline constexpr Key<T> kRepeatKey = {
    {"repeat", "{ grid = { count = [nx, ny], step = [dx, dy] } }", "none"}, &read_before<T>};
template <class T>
inline constexpr Key<T> kGroupKey = {{"group", "\"GROUP\"", "none"}, &read_before<T>};

}  // namespace flatray
