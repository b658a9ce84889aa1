#pragma once
#include "scene/keys.h"
#include "scene/repeat.h"

namespace flatray {

/// What one table of the scene stands for: copies by its `repeat`, in every copy of its group.
struct Copies {
  std::optional<Repeat> repeat;
  std::vector<std::uint32_t> groups;  ///< Scene::groups it stands in; empty: in none
  std::uint64_t each = 1;             ///< by its own repeat
  std::uint64_t total = 1;
};

/// Reads `repeat` and `group` of a table; `what` and `before` say what it adds to, and how many
/// there are. Nothing is made yet. Error   a total over LoadLimits::max_entities, among others.
std::optional<Copies> read_copies(Builder& builder, const Value& table, const char* what,
                                  std::size_t before);

/// Places copy `number` of a thing that has a name, `at`, `angle`, and gives it its name: that of
/// the table, then for each repeat it stands in, outermost first, a point and the number of the
/// copy from 0.
template <class T>
void place_copy(const Copies& copies, std::uint64_t number, const std::string& outer,
                const Draws& draws, T& thing) {
  if (!thing.name.empty()) thing.name += outer;
  if (!copies.repeat) return;
  const std::uint64_t own = number % copies.each;
  const Copy copy = copy_of(*copies.repeat, own, draws);
  thing.at += copy.at;
  thing.angle += copy.angle;
  if (!thing.name.empty()) thing.name += fmt::format(".{}", own);
}

/// The keys `repeat` and `group` are read before the others.
template <class T>
void read_before(Builder&, const Field&, T&) {}
template <class T>
inline constexpr Key<T> kRepeatKey = {{"repeat", "{ KIND = { ... } }", "none"}, &read_before<T>};

}  // namespace flatray
