#pragma once
#include "base/result.h"
#include "scene/reading/args.h"

namespace flatray {

/// A kind of shape: one file in shapes/, registered in CMake.
struct ShapeType {
  const char* name;
  std::span<const KeyInfo> keys;
  Result<Shape> (*build)(Args&);
  /// Whether one number alone may be right at two times and wrong in between.
  bool fails_between = false;
};

/// Registered kinds by name.
std::vector<const ShapeType*> shape_types();
/// "min = [x, y], max = [x, y]"
std::string usage(const ShapeType& type);

}  // namespace flatray
