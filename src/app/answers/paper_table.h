#pragma once
#include <array>
#include <optional>
#include <string>

#include "app/report/value.h"
#include "base/result.h"
#include "base/source_text.h"
#include "scene/scene.h"

namespace flatray {

/// The paper's tables 4 and 5 (box against box) recomputed beside what is printed there.
struct PaperTable {
  struct Ray {  ///< of table 4, one edge of each box
    Segment one, two;
  };
  /// Of table 5: the first ray of box 1 against one edge of box 2. `printed_t` there is none.
  struct Hit {
    std::string printed_tmp, printed_status;
    int printed_numer, printed_denom;
    Vec2 tmp;
    double numer, denom;
    std::string status;
    std::optional<double> t;  ///< none of what is parallel
  };
  std::array<Ray, 4> rays;
  std::array<Hit, 4> hits;
  int misses_of_one, misses_of_two;  ///< of four sides each, at rest
  double t_first, t_last;            ///< box 1 moving (635, 178)

  std::string text() const;
  JsonValue json() const;
};

/// Needs   a scene with the paper's two boxes, as scenes/paper/case_two.toml has them.
/// Error   one without, Trouble::usage at `where`.
Result<PaperTable> paper_table(const Scene& scene, const Place& where);

}  // namespace flatray
