#pragma once
#include <set>

#include "base/result.h"
#include "scene/emitter.h"
#include "scene/reading/args.h"

namespace flatray {

/// How light of a lamp is found by paths that set off from pixels.
enum class LampSeen : std::uint8_t {
  never,   ///< only paths from the lamp know it
  points,  ///< by Emitter::sight: no path meets it by chance
  line     ///< by Emitter::line
};

/// A kind of lamp: one file in lamps/, registered in CMake.
struct LampType {
  const char* name;
  const char* summary;  ///< one line, no full stop
  std::span<const KeyInfo> keys;
  unsigned numbers;  ///< that a ray needs, at most kMostLampNumbers
  Result<std::unique_ptr<const Emitter>> (*build)(Args&);
  LampSeen seen = LampSeen::never;
};

/// Why paths from pixels cannot find all light of a scene; nothing where they can.
std::optional<Diagnostic> why_not_backward(const Scene& scene);

/// All lights that a lamp may have, its own and those of its states.
std::vector<const LampLight*> lights_of(const Lamp& lamp);

/// Why their noise may be beyond all bounds: a wall that scatters alike into all directions shines
/// along itself as bright as one likes, and paths come to it there by chance.
std::optional<Diagnostic> why_noisy_backward(const Scene& scene);

/// The curves of arguments, and the times in seconds at which these have keys.
std::set<CurveId> curves_of(const KeptArguments& kept);
std::set<double> key_times(const Scene& scene, const KeptArguments& kept);

/// Registered kinds by name.
std::vector<const LampType*> lamp_types();

/// Curves of light by the words of light.tone.
inline constexpr Word<ToneCurve> kToneCurves[] = {{"linear", ToneCurve::linear},
                                                  {"soft", ToneCurve::soft},
                                                  {"filmic", ToneCurve::filmic},
                                                  {"gamma", ToneCurve::gamma}};

}  // namespace flatray
