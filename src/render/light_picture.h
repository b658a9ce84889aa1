#pragma once
#include "render/draw_list.h"
#include "transport/light/forward.h"

namespace flatray {

/// What a film shows: its fluence as it is, or exposed and toned for the eye.
LightPicture light_picture(const TracedLight& traced, const LightSettings& light, bool raw);

/// The exposure at which one of a hundred pixels that light crosses is 1 or brighter; 1 where none is.
double automatic_exposure(const std::vector<double>& fluence);

/// A channel of exposed light as it is shown, from 0 to 1 where the curve ends there.
float toned(ToneCurve curve, double light);

/// Memory that the light of a frame takes at its peak.
std::uint64_t light_bytes(const Scene& scene, unsigned threads);

/// The light of a frame, traced.
TracedLight trace_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                              std::uint64_t seed, unsigned threads, bool (*stop)());

}  // namespace flatray
