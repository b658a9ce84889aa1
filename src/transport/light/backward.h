#pragma once
#include "transport/light/forward.h"

namespace flatray {

/// The light of a frame, gathered pixel by pixel.
struct GatheredLight {
  std::vector<double> fluence;  ///< power per world length; row by row from the top, 3 a pixel
  std::vector<double> error;    ///< its standard error, of 16 independent parts
  std::uint64_t paths = 0;
  bool whole = true;  ///< not stopped
};

/// Paths of a pixel: all of them together are `rays` or a little more.
std::uint64_t paths_a_pixel(std::uint64_t rays, std::uint64_t pixels);

/// Follows paths from places and directions in every pixel back to the lamps.
///
/// Needs   lamps that can be seen (LampType::seen); no mirror or glass where one of them is seen as
///         points; no body that disperses. LightRules::light says how many rays and bounces.
/// Gives   what trace_light() gives, but for noise; the same bytes for any number of threads, tier and
///         exact tracer.
/// Error   unbiased. Light that would come through a corner is lost. At walls that scatter alike into
///         all directions the variance is infinite: their radiance along the wall is without bounds.
/// Source  Jarosz et al. 2012, "Theory, analysis and applications of 2D global illumination".
/// Cost    a pixel costs the same whether much light crosses it or little: for views of a small part
///         of a scene.
GatheredLight gather_light(const World& world, std::span<const Scatterer* const> scatterers,
                           std::span<const LampState> lamps, const FilmPlace& place,
                           const LightRules& rules);

}  // namespace flatray
