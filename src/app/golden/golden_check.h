#pragma once
#include <optional>

#include "app/golden/golden.h"
#include "image/compare.h"

namespace flatray {

/// A row drawn again, beside its committed picture.
struct GoldenCheck {
  Image actual, expected;
  std::optional<Difference> difference;  ///< unset where size or channels differ
  bool scene_changed = false;            ///< since the picture was accepted
  std::string options;                   ///< as GoldenScene's
  Tolerance tolerance;                   ///< the row's
  std::string renderer;                  ///< what drew `actual`

  bool passes() const { return difference && tolerance.allows(*difference); }
};

/// Two pictures judged by equality; what is not of pictures stays unset.
GoldenCheck judge(Image actual, Image expected);

/// Error   of the scene or the committed file; also where that file is not the one the row names by
///         its hash.
Result<GoldenCheck> check_golden(const std::filesystem::path& root, const GoldenRow& row);

/// What to print of a check that does not pass: the worst pixel, where to look, how to replay and
/// how to accept it.
std::string golden_report(const GoldenRow& row, const GoldenCheck& check);

/// Leaves actual.png, expected.png and diff_x16.png in the row's folder to look at.
Result<void> write_look(const std::filesystem::path& root, const GoldenRow& row,
                        const GoldenCheck& check, const Outputs& outputs = {});

}  // namespace flatray
