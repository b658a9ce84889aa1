#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/builder.h"

namespace flatray {

/// The arguments of a shape, a lamp's source or a material, read by name. A wrong or missing one is
/// noted and stands in as 0 or empty: the thing is then refused for that alone, whatever `build` says.
///
/// Those of a shape that changes are read once and kept, and have the values of the time that is set.
class Args {
 public:
  Args(Builder& builder, Field field, std::span<const KeyInfo> keys,
       KeptArguments* changing = nullptr);
  /// Of a shape that was read, at a time; there are no places.
  Args(const Scene& scene, const KeptArguments& changing, double time);
  Args(const Args&) = delete;

  const Place where;  ///< of the table of arguments

  Vec2 point(const char* key);
  double number(const char* key, double fallback = 0);
  /// A number for all of red, green and blue, or one each, of what does not change.
  std::array<double, 3> channels(const char* key, double fallback);
  /// A number, twice, or `[low, high]` in any order, of what may change; 0 where it is not given.
  Vec2 range(const char* key);
  /// Above 0 and at most kFarthest. What changes may come to 0: the shape is then not there.
  double size(const char* key);
  std::int64_t integer(const char* key, std::int64_t fallback, std::int64_t low, std::int64_t high);
  std::string string(const char* key, std::string fallback = {});
  /// Of what does not change.
  Colour colour(const char* key, const Colour& fallback);
  bool flag(const char* key, bool fallback = false);
  std::vector<Vec2> points(const char* key);
  template <class E>
  E word(const char* key, E fallback, std::span<const Word<E>> words) {
    return plain(key, fallback,
                 [&](const Field& field) { return builder_->in.word(field, words); });
  }
  /// Place of an argument, or of all of them where it is not given; of an array that of entry
  /// `index`, if asked for.
  Place place(const char* key, std::size_t index = ~std::size_t{0}) const;

  /// "circle.radius MESSAGE", of what was read and means nothing.
  void problem(const char* key, const std::string& message, std::string hint);
  void warning(const Place& at, std::string message, std::string hint = {});
  void warnings(Diagnostics more);
  Imports& imports() { return builder_->imports; }

  /// Says that nothing is left of the shape: one that changes is then not there, whatever `build`
  /// says, which then need not make its corners.
  void vanish(bool nothing_is_left = true) { gone_ |= nothing_is_left; }
  bool gone() const { return gone_ && changes(); }
  void set_time(double time);

  /// Warns of points read so far that were written differently but are the same doubles.
  void check_lost_features();

 private:
  using Argument = KeptArguments::Argument;

  bool changes() const { return known_ != nullptr; }
  std::optional<Field> find(const char* key) const;
  /// An argument until the next is asked for, read by `read(field, argument)` where it is not known; nullptr where
  /// it is not given.
  template <class Read>
  const Argument* noted(const char* key, const Read& read) {
    if (changes())
      for (const Argument& argument : known_->arguments)
        if (std::string_view(argument.key) == key) return &argument;
    const std::optional<Field> field = find(key);
    if (!field) return nullptr;
    Argument& argument = changes() ? noting_->arguments.emplace_back() : last_;
    argument.key = key;
    argument.numbers.clear();
    argument.text.clear();
    read(*field, argument);
    return &argument;
  }
  /// What cannot change: a word, whole number or truth value, which is kept as a number.
  template <class Plain, class Read>
  Plain plain(const char* key, Plain fallback, const Read& read) {
    const Argument* argument = noted(key, [&](const Field& field, Argument& made) {
      if (const auto value = read(field)) made.numbers.push_back({static_cast<double>(*value), {}});
    });
    return argument == nullptr || argument->numbers.empty()
               ? fallback
               : static_cast<Plain>(argument->numbers.front().value);
  }
  const Moving* kept_number(const char* key);
  void note_point(const Field& field, Argument& argument);
  /// Points of an argument from number `i` on, at the time.
  Vec2 point_now(const Argument& argument, std::size_t i) const;

  Builder* builder_ = nullptr;  ///< where there is something to read
  const Scene* scene_;
  std::optional<Field> field_;
  std::span<const KeyInfo> keys_;
  KeptArguments* noting_ = nullptr;
  const KeptArguments* known_;  ///< of what changes
  Argument last_{};             ///< of what does not change
  double time_ = 0;
  bool gone_ = false, warns_ = true;
  struct ReadPoint {
    Vec2 point;
    const Value* value;
  };
  std::vector<ReadPoint> read_;
};

}  // namespace flatray
