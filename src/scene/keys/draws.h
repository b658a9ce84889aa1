#pragma once
#include <cstdint>
#include <map>
#include <optional>

#include "scene/reading/scene_desc.h"

namespace flatray {

/// Whether a value stands for a number, point or word to be drawn: `{ uniform = [a, b] }`,
/// `{ normal = [mean, sd] }` or `{ choice = [...] }`.
bool is_distribution(const Value& value);
/// Whether one stands anywhere in a value.
bool has_distribution(const Value& value);

/// The random numbers of one table of the scene: what is drawn in it is drawn anew for every copy.
///
/// A draw is named by (seed, Stream::value, table, copy, n): `table` counts the tables of a kind from
/// 0 in the order of the scene, groups from 2^31 on; `copy` the copies of the table from 0; n is
/// twice the number of the distribution among those of the table, from 0 in the order of the text,
/// and one more for the second number a normal distribution needs.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t table, const Value& written);

  bool empty() const { return numbers_.empty(); }
  void set_copy(std::uint64_t copy) { copy_ = copy; }

  /// A double uniform on [0, 1) for a distribution of the table; `second` for another.
  double unit(const Value& distribution, bool second = false) const;
  /// Standard normal, by the method of Box and Muller 1958.
  double normal(const Value& distribution) const;

  /// Two doubles uniform on [0, 1), of the copy's place: draws 0 and 1 of Stream::scatter.
  std::pair<double, double> place() const;

 private:
  void number(const Value& value);

  std::uint64_t seed_;
  std::uint32_t table_;
  std::uint64_t copy_ = 0;
  std::map<const Value*, std::uint32_t> numbers_;
};

}  // namespace flatray
