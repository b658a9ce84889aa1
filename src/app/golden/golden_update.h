#pragma once
#include <optional>

#include "app/golden/golden.h"
#include "app/options/option_values.h"

namespace flatray {

/// What is to be accepted.
struct GoldenRequest {
  std::string scene;  ///< as `find_scene` gives it
  std::string why;
  std::optional<std::vector<unsigned>>
      frames;  ///< the scene's goldens from now on; unset: those it has, or frame 1
  std::optional<FilmSize>
      size;  ///< unset: the scene's own, or where that is too large that of its goldens
  std::string backend = "software";  ///< or "gl"
};

/// What accepting would do. Nothing is written yet.
struct GoldenUpdate {
  struct Picture {
    GoldenRow row;
    std::optional<Image> before;
    Image after;
    std::vector<std::byte> png;
    bool same() const { return before && *before == after; }
    std::string sheet() const { return row.look() + "/sheet.png"; }
  };
  std::vector<Picture> pictures;   ///< by frame
  std::vector<GoldenRow> removed;  ///< goldens of the scene no longer wanted
  std::vector<GoldenRow> rows;     ///< of the manifest afterwards
};

/// Draws the scene's goldens, each twice, and measures their drift; for a GL back end between
/// OSMesa and EGL, too, and allows what it measured.
///
/// Gives   rows in which pictures that stay the same keep their `why`.
/// Error   of the scene; Trouble::usage, all together, for pictures above 320 x 200, more than
///         three frames, more than 2 MB in all, two scenes of one folder, and for pictures that
///         drift.
Result<GoldenUpdate> plan_update(const std::filesystem::path& root,
                                 const std::vector<GoldenRow>& rows, const GoldenRequest& request);

/// Writes pictures that changed and their sheets, then the manifest, then removes what is no longer
/// wanted; each file atomically.
Result<void> write_update(const std::filesystem::path& root, const GoldenUpdate& update,
                          const Outputs& outputs = {});

/// Before, after and difference x16 side by side; only the picture where there was none, or none of
/// its size.
Image golden_sheet(const GoldenUpdate::Picture& picture);

}  // namespace flatray
