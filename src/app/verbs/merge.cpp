#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/frames/light_files.h"
#include "app/options/light_wish.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/number_text.h"
#include "image/hdr.h"
#include "render/light/light_picture.h"

namespace flatray::verbs {
namespace {

std::vector<std::string> tones() {
  std::vector<std::string> names;
  for (const ToneCurve tone : kToneCurves) names.emplace_back(name(tone));
  return names;
}

constexpr Option kOptions[] = {
    {"output", 'o', "OUT.film", "where to: all.film, or a picture .png, .hdr, .pfm"},
    {"exposure", '\0', "E",
     "of a .png: what light of 1 is shown as, or auto (default: the scene's)"},
    {"tone", '\0', "NAME", "of a .png: linear, soft, filmic, gamma (default: the scene's)",
     OptionKind::text, &tones},
    kErrorImageOption,
    {"max-bytes", '\0', "N", "most bytes of a film (default 17179869184)"},
    kForceOption,
    kJsonOption,
    kQuietOption};

// How the film's scene, or the command line, wants it shown.
Result<LightSettings> look(const Arguments& arguments, const FilmFile& film) {
  LightSettings light;
  const JsonValue setting = parse_json(film.setting);
  light.exposure = setting.number_of("exposure");
  light.gamma = setting.number_of("gamma").value_or(light.gamma);
  std::string tone = setting.text_of("tone");
  if (const auto text = arguments.text("exposure")) {
    light.exposure = parse_number(*text);
    if (*text != "auto" && !(light.exposure && *light.exposure > 0 && *light.exposure <= 1e30))
      return usage_error(arguments.where("exposure"), "is not above 0 and at most 1e30",
                         "say what light of 1 is to be shown as, or auto");
  }
  if (arguments.has("tone")) {
    const auto word = arguments.one_of("tone", tones());
    if (!word) return tl::unexpected(word.error());
    tone = *word;
  }
  for (const ToneCurve one : kToneCurves)
    if (tone == name(one)) light.tone = one;
  return light;
}

Result<FilmFile> merged(const Arguments& arguments) {
  const auto most = arguments.whole("max-bytes", kMostFilmBytes, 1, std::uint64_t{1} << 40);
  if (!most) return tl::unexpected(most.error());
  const std::vector<std::string>& paths = arguments.operands();
  Result<FilmFile> film = read_film(paths.front(), *most);
  for (std::size_t i = 1; film && i < paths.size(); ++i) {
    const auto more = read_film(paths[i], *most);
    if (!more) return tl::unexpected(more.error());
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

Result<OutputPattern> output_of(const Arguments& arguments, const char* option) {
  const auto text = arguments.text(option);
  if (!text)
    return usage_error(named_place(fmt::format("--{}", option)), "is missing",
                       "say -o all.film, or -o picture.png");
  auto output = OutputPattern::parse(*text, std::nullopt, arguments.where(option));
  if (output && (output->has_scene() || output->is_stdout()))
    return usage_error(arguments.where(option), "is not the name of one file", "say all.film");
  if (output && output->format().is_video())
    return usage_error(arguments.where(option), "is a video, and light of one frame a picture",
                       "say .film, .png, .hdr or .pfm");
  return output;
}

Result<VerbOutput> run(const Arguments& arguments) {
  const auto output = output_of(arguments, "output");
  if (!output) return tl::unexpected(output.error());
  std::optional<OutputPattern> error_output;
  if (arguments.has("error-image")) {
    auto image = output_of(arguments, "error-image");
    if (!image) return tl::unexpected(image.error());
    error_output = std::move(*image);
  }
  if (output->format().of_picture == nullptr)
    for (const char* option : {"exposure", "tone"})
      if (arguments.has(option))
        return usage_error(
            arguments.where(option),
            fmt::format("is of a .png: a .{} keeps light as it is", output->format().name),
            "leave it out, or say -o picture.png");
  const auto film = merged(arguments);
  if (!film) return tl::unexpected(film.error());
  const auto light = look(arguments, *film);
  if (!light) return tl::unexpected(light.error());
  const LightReport report = report_of(*film);
  const Outputs outputs(arguments);
  const std::filesystem::path path = *arguments.text("output");
  const std::vector<std::byte> bytes = output->format().of_film != nullptr
                                           ? output->format().of_film(*film)
                                           : picture_of(*film, report, *light, output->format());
  if (error_output) {
    if (error_output->format().of_film != nullptr)
      return usage_error(arguments.where("error-image"), "is a picture, not a film",
                         "say .pfm, .hdr or .png");
    if (film->scrambles.size() < 2)
      return usage_error(arguments.where("error-image"), "needs films of 16 scrambles or more",
                         "render them again with -D light.scrambles=16");
    if (std::filesystem::path(*arguments.text("error-image")).lexically_normal() ==
        path.lexically_normal())
      return usage_error(arguments.where("error-image"), "is where the picture goes",
                         "name another file");
    if (auto may = outputs.allow(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        !may)
      return fail(std::move(may));
    const PixelBox all{0, 0, film->width, film->height};
    if (auto written = outputs.write(*arguments.text("error-image"),
                                     error_picture(report, error_output->format(), all, all));
        !written)
      return fail(std::move(written));
  }
  if (auto written = outputs.write(path, bytes); !written) return fail(std::move(written));
  const LightRecord record = record_of(report);
  if (!arguments.has("quiet"))
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

extern const Verb merge = {
    "merge",
    "FILE.film...",
    "add films of light, exactly and in any order, into a film or a picture",
    1,
    10'000,
    kOptions,
    "  flatray render scene.toml --ray-shard 0/2 -o a.film    # and 1/2 elsewhere\n"
    "  flatray merge a.film b.film -o picture.png\n"
    "  flatray merge a.film b.film -o all.film --force\n",
    "nothing written",
    &run};

}  // namespace flatray::verbs
