#pragma once
#include <array>
#include <span>
#include <vector>

#include "image/image.h"
#include "render/draw_list.h"

namespace flatray {

/// Place in a pixel, from its top left corner.
using SamplePlace = std::array<double, 2>;

/// Places at which the GL back ends take `count` samples (4, 16 or 64): those of Mesa's four, moved
/// as they move the picture. One, the centre, for scenes that ask for pixel centres.
std::vector<SamplePlace> sample_places(Coverage coverage, unsigned count);

/// Mean light of samples at these places, each seen by the software back end's rule for centres.
LinearImage mean_light(const DrawList& list, std::span<const SamplePlace> places, unsigned threads);

/// What samples see, drawn by the software back end's exact rule for centres.
struct PointSampled {
  Image picture;           ///< the mean light of the samples
  std::vector<bool> near;  ///< by pixel: a sample lies so near an edge that rounding may decide it
};

/// Needs   places as above.
/// Gives   a sample is near where it sees something else 1/128 of a pixel away, or has a straight
///         edge so near: twice what the GL back ends may move an edge, whose corners they round to
///         1/256.
PointSampled point_sampled(const DrawList& list, std::span<const SamplePlace> places,
                           unsigned threads);

/// By pixel: whether an outline passes through it, so that coverage decides its colour.
std::vector<bool> edge_pixels(const DrawList& list);

/// Pixels of a picture of samples by why they differ from the exact one.
struct DifferenceCauses {
  std::uint64_t edge = 0;         ///< an outline passes through
  std::uint64_t sampled = 0;      ///< of these, what exact samples see, within one level
  std::uint64_t rounded = 0;      ///< not that, but a sample is near an edge
  std::uint64_t unexplained = 0;  ///< neither
  int flat_worst = 0;             ///< largest difference where every item covers all or nothing

  /// Whether areas against samples explain every difference, to one level of rounding.
  bool coverage_alone() const { return unexplained == 0 && flat_worst <= 1; }
};

/// Needs   pictures of one size and channel count, `exact` by the software back end.
DifferenceCauses difference_causes(const Image& drawn, const Image& exact,
                                   const PointSampled& sampled, const std::vector<bool>& edges);

}  // namespace flatray
