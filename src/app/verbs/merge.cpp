#include <fmt/core.h>

#include <filesystem>

#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/frames/light_files.h"
#include "app/options/light_wish.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/number_text.h"
#include "image/hdr.h"
#include "render/light/light_picture.h"
#include "scene/lamp.h"

namespace flatray::merge_verb {
namespace {

struct Exposure {
  std::optional<double> value;  ///< nullopt: auto
};
Result<Exposure> parse_exposure(const std::string& text, const Place& where) {
  const auto value = parse_number(text);
  if (text == "auto" || (value && *value > 0 && *value <= 1e30)) return Exposure{value};
  return usage_error(where, "is not above 0 and at most 1e30",
                     "say what light of 1 is to be shown as, or auto");
}

// A file of that name.
struct Target {
  std::filesystem::path path;
  const PictureFormat* format = nullptr;
};
Result<Target> parse_target(const std::string& text, const Place& where) {
  FLATRAY_TRY(output, OutputPattern::parse(text, std::nullopt, where));
  if (output->has_scene() || output->is_stdout())
    return usage_error(where, "is not the name of one file", "say all.film");
  if (output->format().is_video())
    return usage_error(where, "is a video, and light of one frame a picture",
                       "say .film, .png, .hdr or .pfm");
  return Target{text, &output->format()};
}

struct Options : Arguments {
  Target output;
  std::optional<Target> error_image;
  std::optional<Exposure> exposure;
  std::optional<ToneCurve> tone;
  std::uint64_t max_bytes = kMostFilmBytes;

  void rows(OptionTable& row) {
    row("-o, --output OUT.film", "where to: all.film, or a picture .png, .hdr, .pfm", output,
        &parse_target, &endings_of_frames);
    row("--exposure E", "of a .png: what light of 1 is shown as, or auto, instead of the scene's",
        exposure, &parse_exposure);
    row("--tone", "of a .png, instead of the scene's", tone, kToneCurves);
    row(kErrorImageRow);
    row("--max-bytes N", "most bytes of a film", max_bytes, 1, std::uint64_t{1} << 40);
    row(kForceRow);
    row(kJsonRow);
    row(kQuietRow);
    row.read("error-image", error_image, &parse_target);
    if (!row.has("output"))
      row.problem("output", "is missing", "say -o all.film, or -o picture.png");
    for (const char* option : {"exposure", "tone"})
      if (row.has(option) && output.format != nullptr && output.format->of_picture == nullptr)
        row.problem(option,
                    fmt::format("is of a .png: a .{} keeps light as it is", output.format->name),
                    "leave it out, or say -o picture.png");
    if (!error_image) return;
    if (error_image->format->of_film != nullptr)
      row.problem("error-image", "is a picture, not a film", "say .pfm, .hdr or .png");
    if (error_image->path.lexically_normal() == output.path.lexically_normal())
      row.problem("error-image", "is where the picture goes", "name another file");
  }
};

// How the film's scene, or the command line, wants it shown.
LightSettings look(const Options& options, const FilmFile& film) {
  LightSettings light;
  const JsonValue setting = parse_json(film.setting);
  light.exposure = setting.number_of("exposure");
  light.gamma = setting.number_of("gamma").value_or(light.gamma);
  const std::string tone = setting.text_of("tone");
  for (const auto& [word, curve] : kToneCurves)
    if (tone == word) light.tone = curve;
  if (options.exposure) light.exposure = options.exposure->value;
  light.tone = options.tone.value_or(light.tone);
  return light;
}

Result<FilmFile> merged(const Options& options) {
  const std::vector<std::string>& paths = options.operands();
  Result<FilmFile> film = read_film(paths.front(), options.max_bytes);
  for (std::size_t i = 1; film && i < paths.size(); ++i) {
    FLATRAY_TRY(more, read_film(paths[i], options.max_bytes));
    if (auto added = merge_film(*film, *more, paths[i]); !added) return fail(std::move(added));
  }
  return film;
}

std::vector<std::byte> picture_of(const FilmFile& film, const LightReport& report,
                                  const LightSettings& light, const PictureFormat& format) {
  std::vector<std::int64_t> sums = report.scrambles.front();
  for (std::size_t k = 1; k < report.scrambles.size(); ++k)
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += report.scrambles[k][i];
  const double unit = report.film_unit / static_cast<double>(report.scrambles.size());
  const std::vector<double> counts(sums.begin(), sums.end());
  const LightPicture shown = light_picture(counts, unit, light, format.of_light != nullptr);
  const LinearImage image{film.width, film.height, shown.rgb};
  return format.of_light != nullptr ? format.of_light(image) : format.encode(develop(image));
}

// Of the error of light, where it is asked for. `picture` must be able to follow.
Result<void> write_error(const Options& options, const FilmFile& film, const LightReport& report,
                         const Outputs& outputs, std::span<const std::byte> picture) {
  if (!options.error_image) return {};
  if (film.scrambles.size() < 2)
    return usage_error(options.where("error-image"), "needs films of 16 scrambles or more",
                       "render them again with -D light.scrambles=16");
  const std::string_view text{reinterpret_cast<const char*>(picture.data()), picture.size()};
  const PixelBox all{0, 0, film.width, film.height};
  return outputs.allow(options.output.path, text).and_then([&] {
    return outputs.write(options.error_image->path,
                         error_picture(report, *options.error_image->format, all, all));
  });
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(film, merged(options));
  const LightReport report = report_of(*film);
  const Outputs outputs(options);
  const std::filesystem::path& path = options.output.path;
  const PictureFormat& format = *options.output.format;
  const std::vector<std::byte> bytes =
      format.of_film != nullptr ? format.of_film(*film)
                                : picture_of(*film, report, look(options, *film), format);
  FLATRAY_TRY(beside, write_error(options, *film, report, outputs, bytes));
  if (auto written = outputs.write(path, bytes); !written) return fail(std::move(written));
  const LightRecord record = record_of(report);
  if (!options.has("quiet"))
    report_note(fmt::format("flatray: {} of {}{}", path.string(), counted(record.rays, "ray"),
                            record.error ? fmt::format(", error {:.2g}", *record.error)
                            : !report.scrambles.empty() && record.rounds == 0 ? ", no error yet"
                                                                              : ""));
  return VerbOutput{.results = Fields{{"file", path.string()},
                                      {"width", film->width},
                                      {"height", film->height},
                                      {"bytes", Hash().add(bytes).hex()},
                                      {"light", as_value(record)}}};
}

}  // namespace

extern const Verb entry = {
    "merge",
    "FILE.film...",
    "add films of light, exactly and in any order, into a film or a picture",
    kCommand<Options, &run>,
    "  flatray render scene.toml --ray-shard 0/2 -o a.film    # and 1/2 elsewhere\n"
    "  flatray merge a.film b.film -o picture.png\n"
    "  flatray merge a.film b.film -o all.film --force\n",
    "nothing written"};

}  // namespace flatray::merge_verb
