#pragma once
#include "base/result.h"
#include "scene/args.h"
#include "scene/emitter.h"

namespace flatray {

/// A kind of lamp: one file in lamps/, registered in CMake.
struct LampType {
  const char* name;
  const char* summary;  ///< one line, no full stop
  std::span<const KeyInfo> keys;
  unsigned numbers;  ///< that a ray needs, at most kMostLampNumbers
  Result<std::unique_ptr<const Emitter>> (*build)(Args&);
};

/// Registered kinds by name.
std::vector<const LampType*> lamp_types();

}  // namespace flatray
