#pragma once
#include <cstdint>
#include <span>

#include "render/draw_list.h"
#include "scene/scene.h"

namespace flatray {

/// What a film shows, given in units of fluence: as it is, or exposed and toned for the eye.
LightPicture light_picture(std::span<const double> counts, double unit, const LightSettings& light,
                           bool raw);

/// The exposure at which one of a hundred pixels that light crosses is 1 or brighter; 1 where none is.
double automatic_exposure(std::span<const double> fluence);

inline constexpr ToneCurve kToneCurves[] = {ToneCurve::linear, ToneCurve::soft, ToneCurve::filmic};
const char* name(ToneCurve curve);

/// A channel of exposed light as it is shown, from 0 to 1 where the curve ends there.
float toned(ToneCurve curve, double light);

/// 1 where all light is grey, as that of every lamp and after every wall: its channels are alike.
int light_channels(const Scene& scene);

/// Memory that the light of a frame takes at its peak.
std::uint64_t light_bytes(const Scene& scene, unsigned threads);

}  // namespace flatray
