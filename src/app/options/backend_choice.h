#pragma once
#include <memory>

#include "app/options/arguments.h"
#include "render/backend.h"

namespace flatray {

/// What --backend may be: the default first.
std::vector<std::string> backend_names();

inline constexpr Option kBackendOption = {
    "backend",        '\0',
    "NAME",           "what draws: software (default), gl, osmesa, egl, auto",
    OptionKind::text, &backend_names};
inline constexpr Option kSamplesOption = {"samples", '\0', "4|16|64",
                                          "samples of a pixel, for the GL back ends (default 4)"};

/// The renderer that --backend and --samples name, opened; null for the software back end, which
/// needs none. `auto`: GL where it is to be had.
/// Error   Trouble::usage; Trouble::unavailable, and what to install.
Result<std::shared_ptr<const Renderer>> chosen_renderer(const Arguments& arguments,
                                                        unsigned threads);

/// A registered back end by its name, opened.
/// Error   Trouble::unavailable.
Result<std::unique_ptr<Renderer>> open_backend(const std::string& name,
                                               const BackendChoice& choice);

/// What `flatray --version` says of the back ends: "software, gl (OSMesa, Mesa 22.3.6, ...)".
std::string backends_text();

}  // namespace flatray
