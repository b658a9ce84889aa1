#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "app/files/manifest.h"
#include "app/files/output_pattern.h"
#include "image/film_file.h"
#include "render/frame.h"
#include "render/light/light_run.h"

namespace flatray {

struct RenderJob;

/// Light as a film keeps it, and back.
FilmFile film_of(const TracedLight& light, std::string setting);
TracedLight light_of(const FilmFile& film);
LightReport report_of(const FilmFile& film);

/// Most bytes of a film that are read unasked.
inline constexpr std::size_t kMostFilmBytes = std::size_t{1} << 34;

/// Error   Trouble::missing; Trouble::invalid: what is no film that flatray render writes.
Result<FilmFile> read_film(const std::filesystem::path& path, std::size_t most_bytes);

/// Adds a film that was read from `name`. Error   Trouble::invalid, with what differs.
Result<void> merge_film(FilmFile& film, const FilmFile& more, const std::string& name);

/// Whether --resume can go on from the films of frames that are there; nothing is written.
/// Error   that of traced_film.
Result<void> expect_films(const RenderJob& job, std::span<const unsigned> frames);

/// The film of a frame: with --resume that which is there, and to it the rays that it lacks. What
/// has been traced is written from time to time, so that a run that is killed loses little; not where it
/// would replace a film that is not resumed.
/// Gives   nullopt where it was stopped.
/// Error   Trouble::output where a film of other light is there; that of read_film.
Result<std::optional<FilmFile>> traced_film(const RenderJob& job, const RenderPlan& plan,
                                            const Timeline& timeline, unsigned frame,
                                            const FrameOptions& options);

/// The file of a picture of the error: of light `error_image`, where .hdr has 0 for no number, of
/// 8-bit values `shown_error`. Needs several scrambles.
std::vector<std::byte> error_picture(const LightReport& report, const PictureFormat& format,
                                     const PixelBox& film, const PixelBox& part);

/// The warning of the frame that lost most, where that is more than a hundredth of its light. What
/// is cut off after as many bounces as the scene asks for is not lost.
std::optional<Diagnostic> lost_light(const Scene& scene, std::span<const FrameRecord> records);
/// The warning of the frame with the largest error, where that is more than was asked for.
std::optional<Diagnostic> missed_error(double asked, std::span<const FrameRecord> records);

}  // namespace flatray
