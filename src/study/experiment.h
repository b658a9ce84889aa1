#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// What an experiment is run with.
struct ExperimentContext {
  const Scene& scene;
  std::uint64_t seed = 1;
  std::uint64_t count = 1'000'000;
  unsigned threads = 1;
};

/// Named files (CSV, JSON, SVG) and a text for people; `holds` is whether results agree with the
/// closed form.
struct ExperimentResult {
  struct File {
    std::string name, content;
  };
  std::vector<File> files;
  std::string summary;
  bool holds = true;
};

struct Experiment {
  const char* name;
  const char* question;
  Result<ExperimentResult> (*run)(const ExperimentContext&);
};

/// Registered experiments by name.
std::vector<const Experiment*> experiments();

}  // namespace flatray
