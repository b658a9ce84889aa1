#include <algorithm>

#include "oracle/catalogue_parts.h"

namespace flatray::oracle {
namespace {

// No tracer, contact or orbit can be asked these.
std::vector<StiffCase> held_elsewhere() {
  constexpr const char *kPicture = "a picture", *kFile = "a file", *kCommand = "the command line";
  const auto held = [](const char* id, const char* words, const char* test, const char* matter) {
    return StiffCase{id, words, test, {}, {}, {}, matter};
  };
  return {
      held("E1", "empty scene", "cli.e1_empty_scene", kPicture),
      held("E2", "sizes", "cli.e2_sizes", kPicture),
      held("E3", "refused sizes", "cli.e3_refused_sizes", kCommand),
      held("E4", "numbers", "scene.StiffCases.E4NumbersAreFiniteOrLocatedErrors", kFile),
      held("E5", "text", "cli.e5_text", kFile),
      held("E6", "includes, repeats", "cli.e6_expansion", kFile),
      held("E7", "output names", "cli.e7_output_names", kCommand),
      held("E8", "crash safety", "cli.e8_crash_safety", kFile),
      held("E9", "stale resume", "cli.e9_stale_resume", kFile),
      held("E10", "pixel counts", "render.StiffCases.E10CentresInsideDiscsOnAPixelCorner",
           kPicture),
      held("E11", "same picture", "render.StiffCases.E11ShiftByWholePixelsShiftsThePicture",
           kPicture),
  };
}

int id_number(const char* id) { return std::atoi(id + 1); }

}  // namespace

std::vector<StiffCase> catalogue() {
  std::vector<StiffCase> all =
      stiff_rays() + stiff_orbits() + stiff_rooms() + stiff_contacts() + held_elsewhere();
  std::sort(all.begin(), all.end(), [](const StiffCase& a, const StiffCase& b) {
    return std::pair(a.id[0], id_number(a.id)) < std::pair(b.id[0], id_number(b.id));
  });
  return all;
}

}  // namespace flatray::oracle
