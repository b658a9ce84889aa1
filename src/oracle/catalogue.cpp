#include "oracle/catalogue.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace flatray::oracle {
namespace {

// Statistics of many orbits, starts without an orbit, bodies, pictures, files: no tracer's matter.
std::vector<StiffCase> held_elsewhere() {
  return {
      {"C19", "mean free path", "study.StiffCases.C19MeanFreePath"},
      {"C20", "Lyapunov exponent, stadium", "study.StiffCases.C20LyapunovOfTheStadium"},
      {"C21", "Lyapunov exponent, Sinai torus", "study.StiffCases.C21LyapunovOfTheTorus"},
      {"C22", "box is torus", "study.StiffCases.C22LyapunovOfTheBox"},
      {"C23", "reversal", "transport.StiffCases.C23Reversal"},
      {"C29", "starts badly", "transport.StiffCases.C29StartsBadly"},
      {"C30", "grazing start", "transport.StiffCases.C30GrazingStart"},
      {"D1", "paper boxes", "collide.StiffCases.D1ThePapersBoxesMeetToTheLastBit"},
      {"D2", "bullet", "collide.StiffCases.D2ABulletMeetsAThinWallAtEveryFrameRate"},
      {"D3", "corner to corner", "collide.StiffCases.D3CornerToCorner"},
      {"D4", "slide", "collide.StiffCases.D4SlidingIsAlongAndOneUlpDecides"},
      {"D5", "still", "collide.StiffCases.D5WithoutRelativeMotionTheStartDecidesForAllTime"},
      {"D6", "containment", "collide.StiffCases.D6ContainmentIsOverlapFromTheStart"},
      {"D7", "far", "collide.StiffCases.D7FarAwayIsTheSame"},
      {"D8", "symmetric", "collide.StiffCases.D8ExchangedOrCarriedAlongTheTimesAreTheSame"},
      {"D9", "degenerate", "collide.StiffCases.D9SegmentsAndPointsMeetAsClosedSets"},
      {"E1", "empty scene", "cli.e1_empty_scene"},
      {"E2", "sizes", "cli.e2_sizes"},
      {"E3", "refused sizes", "cli.e3_refused_sizes"},
      {"E4", "numbers", "scene.StiffCases.E4NumbersAreFiniteOrLocatedErrors"},
      {"E5", "text", "cli.e5_text"},
      {"E6", "includes, repeats", "cli.e6_expansion"},
      {"E7", "output names", "cli.e7_output_names"},
      {"E8", "crash safety", "cli.e8_crash_safety"},
      {"E9", "stale resume", "cli.e9_stale_resume"},
      {"E10", "pixel counts", "render.StiffCases.E10CentresInsideDiscsOnAPixelCorner"},
      {"E11", "same picture", "render.StiffCases.E11ShiftByWholePixelsShiftsThePicture"},
  };
}

int number(const char* id) { return std::atoi(id + 1); }

}  // namespace

std::vector<StiffCase> catalogue() {
  std::vector<StiffCase> all = stiff_rays();
  for (std::vector<StiffCase> part : {stiff_orbits(), held_elsewhere()})
    std::move(part.begin(), part.end(), std::back_inserter(all));
  std::sort(all.begin(), all.end(), [](const StiffCase& a, const StiffCase& b) {
    return std::pair(a.id[0], number(a.id)) < std::pair(b.id[0], number(b.id));
  });
  return all;
}

}  // namespace flatray::oracle
