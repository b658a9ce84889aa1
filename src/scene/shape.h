#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/imports.h"
#include "scene/load.h"
#include "scene/reader.h"

namespace flatray {

/// The arguments of a shape, read by name. A wrong or missing one is noted and stands in as 0 or
/// empty: the shape is then refused for that alone, whatever `build` says.
class Args {
 public:
  Args(Field field, std::span<const KeyInfo> keys, Reader& in, Imports& imports);

  const Place where;  ///< of the table of arguments

  Vec2 point(const char* key);
  double number(const char* key, double fallback = 0);
  /// Above 0 and at most kFarthest.
  double size(const char* key);
  std::int64_t integer(const char* key, std::int64_t fallback, std::int64_t low, std::int64_t high);
  std::string string(const char* key, std::string fallback = {});
  bool flag(const char* key, bool fallback = false);
  std::vector<Vec2> points(const char* key);
  template <class E>
  E word(const char* key, E fallback, std::span<const Word<E>> words) {
    const std::optional<Field> field = find(key);
    return field ? in_->word(*field, words).value_or(fallback) : fallback;
  }
  /// Place of an argument, or of all of them where it is not given.
  Place place(const char* key) const;
  /// Place of entry `index` of an array argument.
  Place place(const char* key, std::size_t index) const;

  void warning(const Place& at, std::string message, std::string hint = {}) {
    in_->warning(at, std::move(message), std::move(hint));
  }
  void warnings(Diagnostics more);
  Imports& imports() { return *imports_; }

  /// Warns of points read so far that were written differently but are the same doubles.
  void check_lost_features();

 private:
  std::optional<Field> find(const char* key) const;

  Field field_;
  std::span<const KeyInfo> keys_;
  Reader* in_;
  Imports* imports_;
  struct ReadPoint {
    Vec2 point;
    const Value* value;
  };
  std::vector<ReadPoint> read_;
};

/// A kind of shape: one file in shapes/, registered in CMake.
struct ShapeType {
  const char* name;
  std::span<const KeyInfo> keys;
  Result<Shape> (*build)(Args&);
};

/// Registered kinds by name.
std::vector<const ShapeType*> shape_types();
/// "min = [x, y], max = [x, y]"
std::string usage(const ShapeType& type);

}  // namespace flatray
