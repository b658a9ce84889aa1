#pragma once
#include <memory>

#include "app/options/option_table.h"
#include "render/backend.h"

namespace flatray {

/// What --backend may be: the default first.
std::vector<std::string> backend_names();

/// --backend and --samples.
struct BackendOptions {
  std::string name = "software";
  unsigned samples = 4;

  void rows(OptionTable& row);
};

/// The renderer that they name, opened; null for the software back end, which needs none. `auto`:
/// GL where it is to be had.
/// Error   Trouble::unavailable, and what to install.
Result<std::shared_ptr<const Renderer>> chosen_renderer(const BackendOptions& options,
                                                        unsigned threads);

/// A registered back end by its name, opened.
/// Error   Trouble::unavailable.
Result<std::unique_ptr<Renderer>> open_backend(const std::string& name,
                                               const BackendChoice& choice);

/// What `flatray --version` says of the back ends: "software, gl (OSMesa, Mesa 22.3.6, ...)".
std::string backends_text();

}  // namespace flatray
