#pragma once
#include "oracle/families.h"

namespace flatray::oracle {

/// Makers of scenes of circles, arcs and ellipses, for the table of families.
AimedScene circles(Draw& draw);
AimedScene tangents(Draw& draw);
AimedScene from_circles(Draw& draw);
AimedScene arc_ends(Draw& draw);
AimedScene ellipses(Draw& draw);
AimedScene round_scaled(Draw& draw);
AimedScene round_offset(Draw& draw);
AimedScene round_magnitudes(Draw& draw);

}  // namespace flatray::oracle
