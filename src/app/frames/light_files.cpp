#include "app/frames/light_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "app/files/journal.h"
#include "app/frames/render_job.h"
#include "base/counted.h"
#include "base/file.h"
#include "render/light/light_picture.h"
#include "scene/lamp.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

// FilmFile::counts are these.
constexpr std::int64_t LightCounts::*kEnergies[] = {&LightCounts::emitted, &LightCounts::absorbed,
                                                    &LightCounts::escaped, &LightCounts::at_corners,
                                                    &LightCounts::cut_off, &LightCounts::gambled};
constexpr std::uint64_t LightCounts::*kNumbers[] = {&LightCounts::rays, &LightCounts::legs};

LightCounts counts_of(const FilmFile& film) {
  LightCounts counts;
  const std::int64_t* next = film.counts.data();
  for (const auto number : kNumbers) counts.*number = static_cast<std::uint64_t>(*next++);
  for (const auto energy : kEnergies) counts.*energy = *next++;
  return counts;
}

// Counts and lines that no rounds of rays have; nothing where they fit.
std::optional<std::string> misfit_of_counts(const FilmFile& film) {
  constexpr std::uint64_t kMostOfRay = 3ULL << 20;
  if (film.counts.size() != std::size(kNumbers) + std::size(kEnergies))
    return fmt::format("it has {}", counted(film.counts.size(), "count"));
  const LightCounts counts = counts_of(film);
  std::uint64_t rest = static_cast<std::uint64_t>(counts.emitted);  // in which any sum is defined
  for (const auto part : kEnergies) {
    if (part != &LightCounts::emitted) rest -= static_cast<std::uint64_t>(counts.*part);
    if (counts.*part < 0 && part != &LightCounts::gambled)
      return fmt::format("it counts {} of light", counts.*part);
  }
  if (rest != 0) return "what became of its light is not what was emitted";
  if (static_cast<std::uint64_t>(counts.emitted) / kMostOfRay > counts.rays)
    return fmt::format("{} cannot emit so much light", counted(counts.rays, "ray"));
  const std::uint64_t rounds = film.rounds.count();
  if (rounds == 0 ? counts.rays != 0 : counts.rays % rounds != 0)
    return fmt::format("{} are no {}", counted(counts.rays, "ray"), counted(rounds, "round"));
  std::uint64_t lines = 0;
  for (const FilmFile::Scramble& one : film.scrambles) lines += one.lines;
  if ((lines + kMostLinesOfLeg - 1) / kMostLinesOfLeg > counts.legs ||
      (counts.rays == 0 && counts.legs != 0))
    return fmt::format("{} of light do not come from {} of {}", counted(lines, "line"),
                       counted(counts.legs, "leg"), counted(counts.rays, "ray"));
  return std::nullopt;
}

// A setting that is not that of its film.
std::optional<std::string> misfit_of_setting(const FilmFile& film) {
  const auto setting = parse_json(film.setting);
  if (!setting) return "its setting is no JSON";
  const auto is = [&](const char* field, const JsonValue& value) {
    const JsonValue* one = setting->find(field);
    return one != nullptr && json_text(*one) == json_text(value);
  };
  const auto within = [&](const char* field, double low, double high) {
    const auto number = setting->number_of(field);
    return number && *number >= low && *number <= high;
  };
  if (!is("size", fmt::format("{}x{}", film.width, film.height)) ||
      !is("scrambles", film.scrambles.size()))
    return fmt::format("its setting is not of {}x{} pixels and {}", film.width, film.height,
                       counted(film.scrambles.size(), "scramble"));
  if (!is("exposure", "auto") &&
      !within("exposure", std::numeric_limits<double>::denorm_min(), 1e30))
    return "its exposure is not above 0 and at most 1e30";
  if (!within("gamma", 0.1, 10)) return "its gamma is not between 0.1 and 10";
  if (std::ranges::none_of(kToneCurves, [&](const auto& word) { return is("tone", word.first); }))
    return "its tone is unknown";
  return std::nullopt;
}

// What shows that flatray render did not write it.
std::optional<std::string> misfit(const FilmFile& film) {
  const std::size_t scrambles = film.scrambles.size();
  if (scrambles != 1 &&
      std::find(std::begin(kScrambles), std::end(kScrambles), scrambles) == std::end(kScrambles))
    return fmt::format("it has {}", counted(scrambles, "scramble"));
  if (auto counts = misfit_of_counts(film)) return counts;
  return misfit_of_setting(film);
}

// Writes a film now and then, but no more than a twentieth of the time.
class Keeper {
 public:
  Keeper(fs::path path, std::string setting)
      : path_(std::move(path)), setting_(std::move(setting)) {}

  void operator()(const TracedLight& light) {
    constexpr double kLeastSeconds = 2, kPart = 20;
    const auto begin = Clock::now();
    if (Seconds(begin - last_).count() < std::max(kLeastSeconds, kPart * cost_)) return;
    // What goes wrong here goes wrong at the end, too, and is told there.
    (void)write_file(path_, encode_film(film_of(light, setting_)));
    last_ = Clock::now();
    cost_ = Seconds(last_ - begin).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  const fs::path path_;
  const std::string setting_;
  Clock::time_point last_ = Clock::now();
  double cost_ = 0;
};

// What there is to go on from; empty where there is nothing.
Result<TracedLight> light_before(const RenderJob& job, unsigned frame) {
  const fs::path path = job.path(frame);
  const std::string setting = json_text(job.film_setting(frame));
  std::error_code ignored;
  if (!job.light.resume || job.output.is_stdout() || !fs::exists(path, ignored))
    return TracedLight{};
  FLATRAY_TRY(film, read_film(path, kMostFilmBytes));
  if (film->setting != setting)
    return fail(named_place(path.string()),
                "is a film of other light: " + differences(film->setting, setting),
                "name another file, or leave --resume out", Trouble::output);
  const Film& size = job.scene.film;
  if (film->width != size.width || film->height != size.height ||
      film->channels != light_channels(job.scene) ||
      film->scrambles.size() != job.scene.light.scrambles)
    return fail(named_place(path.string()), "has another size than its setting says",
                "it is damaged: name another file, or leave --resume out", Trouble::output);
  return light_of(*film);
}

// Of an Image or a LinearImage.
template <class Picture>
Picture part_of(Picture image, const PixelBox& part) {
  const auto whole = std::exchange(image.pixels, {});
  const std::ptrdiff_t row = std::ssize(whole) / image.height, channels = row / image.width;
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto at = whole.begin() + y * row + part.x * channels;
    image.pixels.insert(image.pixels.end(), at, at + part.width * channels);
  }
  image.width = part.width, image.height = part.height;
  return image;
}

}  // namespace

FilmFile film_of(const TracedLight& light, std::string setting) {
  const LightFilm& first = light.films.front();
  FilmFile film{std::move(setting), first.width(),    first.height(),
                first.channels(),   light.round_unit, light.rounds};
  for (const auto number : kNumbers)
    film.counts.push_back(static_cast<std::int64_t>(light.counts.*number));
  for (const auto energy : kEnergies) film.counts.push_back(light.counts.*energy);
  for (const LightFilm& one : light.films) film.scrambles.push_back({one.lines(), one.sums()});
  return film;
}

TracedLight light_of(const FilmFile& film) {
  TracedLight light{{}, film.round_unit, counts_of(film), film.rounds};
  for (const FilmFile::Scramble& one : film.scrambles)
    light.films.emplace_back(film.width, film.height, film.channels).add_sums(one.sums, one.lines);
  return light;
}

LightReport report_of(const FilmFile& film) {
  LightReport report{counts_of(film), film.rounds.count(), {}, {}, 0};
  const auto rounds = static_cast<double>(std::max<std::uint64_t>(report.rounds, 1));
  report.film_unit = film.round_unit / rounds;
  for (const FilmFile::Scramble& one : film.scrambles)
    report.scrambles.push_back(in_three_channels(one.sums, film.channels));
  if (report.scrambles.size() > 1 && report.rounds > 0)
    report.error = relative_error(report.scrambles);
  return report;
}

Result<FilmFile> read_film(const fs::path& path, std::size_t most_bytes) {
  FLATRAY_TRY(text, read_file(path, {.bytes = most_bytes,
                                     .raise = "--max-bytes N allows more",
                                     .begins = {kFilmSignature}}));
  Result<FilmFile> film = decode_film(std::as_bytes(std::span(*text)), path.string());
  if (const auto wrong = film ? misfit(*film) : std::nullopt)
    return fail(named_place(path.string()), "is not a film that flatray render writes: " + *wrong,
                "write or copy it again");
  return film;
}

Result<void> merge_film(FilmFile& film, const FilmFile& more, const std::string& name) {
  if (film.setting != more.setting)
    return fail(named_place(name),
                "is a film of other light: " + differences(more.setting, film.setting),
                "add films of one scene, size, frame and seed");
  return add_film(film, more, name);
}

Result<void> expect_films(const RenderJob& job, std::span<const unsigned> frames) {
  if (job.output.format().of_film == nullptr) return {};
  for (const unsigned frame : frames)
    if (auto before = light_before(job, frame); !before) return fail(std::move(before));
  return {};
}

Result<std::optional<FilmFile>> traced_film(const RenderJob& job, const RenderPlan& plan,
                                            const Timeline& timeline, unsigned frame,
                                            const FrameOptions& options) {
  const fs::path path = job.path(frame);
  const std::string setting = json_text(job.film_setting(frame));
  FLATRAY_TRY(before, light_before(job, frame));
  LightGoal goal = *plan.light_goal;
  // A film that this run was not told to add to stays until there is a whole one in its place.
  std::error_code ignored;
  const bool keeps = !job.output.is_stdout() && (job.light.resume || !fs::exists(path, ignored));
  Keeper keeper(path, setting);
  goal.told = [&](const TracedLight& light, std::optional<double> error) {
    if (plan.light_goal->told) plan.light_goal->told(light, error);
    if (keeps) keeper(light);
  };
  const TracedLight light =
      trace_frame_light(timeline.scene(), at(timeline, frame), job.tracer, timeline.seed(),
                        options.threads, options.stop, goal, std::move(*before));
  if (!light.whole) return std::nullopt;
  return film_of(light, setting);
}

std::vector<std::byte> error_picture(const LightReport& report, const PictureFormat& format,
                                     const PixelBox& film, const PixelBox& part) {
  if (format.of_picture != nullptr)
    return format.encode(part_of(shown_error(report.scrambles, film.width, film.height), part));
  return format.of_light(
      part_of(error_image(report.scrambles, report.film_unit, film.width, film.height), part));
}

std::optional<Diagnostic> lost_light(const Scene& scene, std::span<const FrameRecord> records) {
  constexpr double kMuch = 0.01;
  const LightRecord* worst = nullptr;
  const double cut_counts = scene.light.bounces_chosen ? 0 : 1;
  const auto lost = [&](const LightRecord& light) {
    return cut_counts * light.cut_off + light.corners;
  };
  for (const FrameRecord& record : records)
    if (record.light && (worst == nullptr || lost(*record.light) > lost(*worst)))
      worst = &*record.light;
  if (worst == nullptr || lost(*worst) <= kMuch) return std::nullopt;
  const bool cut = cut_counts * worst->cut_off >= worst->corners;
  return Diagnostic{scene.light.where ? scene.light.where : scene.lamps.front().where,
                    fmt::format("{:.3g} % of the light is lost: {:.3g} % cut off after {} bounces, "
                                "{:.3g} % at corners",
                                100 * lost(*worst), 100 * worst->cut_off, scene.light.bounces,
                                100 * worst->corners),
                    cut ? fmt::format("raise light.bounces, as -D light.bounces={}",
                                      std::min(10 * std::max(scene.light.bounces, 1U), 1000000U))
                        : "move lamps and what they aim at away from where walls meet"};
}

std::optional<Diagnostic> missed_error(double asked, std::span<const FrameRecord> records) {
  double error = 0;
  for (const FrameRecord& record : records)
    if (record.light) error = std::max(error, record.light->error.value_or(0));
  if (!(asked > 0 && error > asked)) return std::nullopt;
  return Diagnostic{
      named_place("--error"),
      fmt::format("the error is {:.3g}, not {:.3g}: rays or time ended first", error, asked),
      "say more --rays or --time, or leave them out"};
}

}  // namespace flatray
