#pragma once
#include "base/check.h"
#include "fuzz/target.h"
#include "scene/load.h"

namespace flatray {

/// Loads a scene of any kind and holds the laws of every answer: mistakes have messages that can be
/// printed, warnings too. The folder of the name does not exist, so no import is found.
inline Result<LoadedScene> load_fuzzed(const char* file, std::string text,
                                       const std::vector<Override>& overrides = {},
                                       const LoadLimits& limits = {}) {
  Result<LoadedScene> loaded =
      load_scene_text(std::string("/nonexistent/") + file, std::move(text), overrides, limits);
  const Diagnostics& told = loaded ? loaded->warnings : loaded.error();
  FLATRAY_CHECK(loaded || !told.empty(), "refused without a mistake");
  for (const Diagnostic& one : told) FLATRAY_CHECK(!one.message.empty(), "a mistake says nothing");
  FLATRAY_CHECK(told.empty() || !format(told).empty(), "mistakes print nothing");
  return loaded;
}

}  // namespace flatray
