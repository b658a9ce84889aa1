#pragma once
#include <array>
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

const char* name(ToneCurve curve);

/// A channel of exposed light as it is shown, from 0 to 1 where the curve ends there.
float toned(ToneCurve curve, double light);

/// ToneCurve::gamma: light that is shown as the level 255 light^(1 / gamma), from 0 to 1.
///
/// Error   4e-6 of it, by straight lines between 256 knots an octave; light below 2^-126 is dark.
/// Source  what HQZ makes of its picture.
class GammaCurve {
 public:
  /// Needs   a gamma above 0.
  explicit GammaCurve(double gamma);
  float operator()(double light) const;

 private:
  static constexpr std::uint32_t kShift = 15, kRest = (1U << kShift) - 1;  // of a float's bits
  static constexpr std::uint32_t kFirst = 1U << (23 - kShift), kLast = 127U << (23 - kShift);
  std::array<float, kLast - kFirst + 1> shown_;  // at 2^-126 ... 1
};

/// 1 where all light is grey, as that of every lamp and after every wall: its channels are alike.
int light_channels(const Scene& scene);

/// Memory that the light of a frame takes at its peak.
std::uint64_t light_bytes(const Scene& scene, unsigned threads);

}  // namespace flatray
