#pragma once
#include <string>
#include <vector>

#include "render/pass.h"

namespace flatray {

/// What runs for a scene, and why.
struct RenderPlan {
  struct Choice {
    std::string part, decision, reason;
  };
  std::vector<const Pass*> passes;
  const Tracer* tracer = nullptr;          ///< of the rays; null: the one of choice
  bool still = false;                      ///< all frames are one picture: drawn once
  bool still_light = false;                ///< all frames have one light: traced once
  bool raw_light = false;                  ///< LightRun::raw
  const LightGoal* light_goal = nullptr;   ///< LightRun::goal
  const ShownLight* kept_light = nullptr;  ///< LightRun::kept
  std::vector<Choice> choices;
};

/// `keep_all` keeps every pass and omits nothing; the pictures must be identical.
RenderPlan make_plan(const Scene& scene, bool keep_all, const Tracer* tracer = nullptr);

}  // namespace flatray
