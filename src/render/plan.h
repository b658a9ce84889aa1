#pragma once
#include <string>
#include <vector>

#include "anim/timeline.h"
#include "render/draw_list.h"

namespace flatray {

/// Whether a pass runs on a scene, and why: shown by `flatray explain`.
struct Need {
  bool needed;
  std::string reason;
};
inline Need run(std::string reason) { return {true, std::move(reason)}; }
inline Need skip(std::string reason) { return {false, std::move(reason)}; }

/// One kind of thing drawn. `need` decides once a scene; `draw` adds a frame's items, sorted later by layer.
struct DrawContext;
struct Pass {
  const char* name;
  Need (*need)(const Scene&);
  void (*draw)(DrawContext&);
};

/// Registered passes by name.
std::vector<const Pass*> passes();

/// What runs for a scene.
struct RenderPlan {
  struct Choice {
    std::string part, decision, reason;
  };
  std::vector<const Pass*> passes;
  bool still = false;  ///< all frames are one picture: drawn once
  std::vector<Choice> choices;
};

/// `keep_all` keeps every pass and omits nothing; the pictures must be identical.
RenderPlan make_plan(const Scene& scene, bool keep_all);

}  // namespace flatray
