#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/entry_named.h"
#include "scene/keys/draws.h"
#include "scene/reading/vocabulary.h"
#include "scene/scene.h"

namespace flatray {

/// A value under the name messages give it, "film.size", and what its key takes.
struct Field {
  std::string name;
  const Value& value;
  const char* takes;  ///< "[x, y]", for hints

  /// The same key's part: "film.world[0]".
  Field item(std::size_t index) const;
};

/// What a string may be long.
inline constexpr std::size_t kMostStringBytes = 4096;

template <class E>
using Word = std::pair<const char*, E>;

/// Turns values into numbers, points, colours, words. What is wrong goes to `problems`, what is
/// only doubtful to `warnings`; the answer is then nullopt and reading goes on, so that all
/// mistakes are found in one run.
class Reader {
 public:
  Diagnostics problems, warnings;
  /// Of the table being read; nullptr where nothing may be random.
  const Draws* draws = nullptr;

  void problem(const Place& where, std::string message, std::string hint = {});
  /// "film.size WHAT".
  void problem(const Field& field, const std::string& what, std::string hint = {});
  void warning(const Place& where, std::string message, std::string hint = {});
  void add(Diagnostics more);
  /// Notes a problem, and is the answer of who found it.
  std::nullopt_t refuse(Diagnostic one);
  std::nullopt_t refuse(const Field& field, const std::string& what, std::string hint = {});
  /// "film.size is a string, not two numbers", hint "write size = [w, h]".
  void mismatch(const Field& field, const char* expected);
  /// Whether `field` is of a kind, or an array of two; a mismatch is reported.
  bool is(const Field& field, Value::Kind kind, const char* expected);
  bool is_pair(const Field& field, const char* expected);

  /// Nearest double; warned of where an integer or a small number is lost, refused where not
  /// finite. A distribution is drawn.
  std::optional<double> number(const Field& field);
  /// An integer in [low, high], exact beyond 2^53 too.
  std::optional<std::int64_t> integer(const Field& field, std::int64_t low, std::int64_t high);
  std::optional<Vec2> point(const Field& field);
  /// `[[x0, y0], [x1, y1]]`, lower left and upper right.
  std::optional<Bounds> box(const Field& field);
  std::optional<std::string> string(const Field& field);
  std::optional<bool> flag(const Field& field);
  /// "#rrggbb" or "#rrggbbaa".
  std::optional<Colour> colour(const Field& field);

  /// Reads `{ choice = [...] }` by `read`, a function of Field to std::optional: all of the list, so
  /// that all mistakes are found; gives the one drawn. What is not a choice is read as it is.
  template <class Read>
  auto chosen(const Field& field, const Read& read) -> decltype(read(field)) {
    if (!is_choice(field.value)) return read(field);
    const std::optional<std::size_t> drawn = draw_choice(field);
    if (!drawn) return std::nullopt;
    const Field list{field.name, field.value.members.front().value, field.takes};
    const std::size_t problems_before = problems.size();
    decltype(read(field)) result;
    for (std::size_t i = 0; i < list.value.items.size(); ++i)
      if (auto one = chosen(list.item(i), read); i == *drawn) result = std::move(one);
    if (problems.size() > problems_before) result.reset();
    return result;
  }

  template <class E>
  std::optional<E> word(const Field& field, std::span<const Word<E>> words) {
    const std::optional<std::string> text = string(field);
    if (!text) return std::nullopt;
    for (const auto& [name, value] : words)
      if (*text == name) return value;
    return refuse(unknown_word(field.value.where, field.name, *text, names_of(words)));
  }

  /// As the member functions, chosen by the type wanted.
  std::optional<double> as(const Field& field, const double*) { return number(field); }
  std::optional<Vec2> as(const Field& field, const Vec2*) { return point(field); }
  std::optional<Bounds> as(const Field& field, const Bounds*) { return box(field); }
  std::optional<bool> as(const Field& field, const bool*) { return flag(field); }
  std::optional<std::string> as(const Field& field, const std::string*) { return string(field); }
  std::optional<Colour> as(const Field& field, const Colour*) { return colour(field); }

 private:
  static bool is_choice(const Value& value) {
    return is_distribution(value) && value.members.front().key == "choice";
  }
  /// Refuses a curve where there may be none; whether it was one.
  bool refuse_curve(const Field& field);
  /// Whether something may be drawn here.
  bool may_draw(const Field& field);
  std::optional<std::size_t> draw_choice(const Field& field);
  std::optional<double> draw_number(const Field& field);
  std::optional<double> plain_number(const Field& field);
  std::optional<Vec2> plain_point(const Field& field);
  std::optional<Colour> plain_colour(const Field& field);
};

/// Degrees to radians; multiples of 90 degrees give the doubles nearest to their angles.
double radians(double degrees);

}  // namespace flatray
