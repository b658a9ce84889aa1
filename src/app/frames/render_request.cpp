#include "app/frames/render_request.h"

#include <fmt/core.h>

#include <numeric>
#include <set>

#include "app/report/report.h"
#include "render/coverage/unseen.h"

namespace flatray {

void RenderRequest::row_of_size(OptionTable& row) {
  row("--size WxH", "size of the pictures instead of the scene's");
}

void RenderRequest::read_size(OptionTable& row) {
  row.read("size", size, [this](const std::string& text, const Place& where) {
    return parse_size(text, where, scene.limits.max_pixels);
  });
}

void RenderRequest::row_of_format(OptionTable& row) {
  row("--format NAME", "format where the name does not say it: flatray list pictures",
      &picture_format_names);
  std::optional<std::string> word;
  row.read("format", word, &as_text);
  row.read("output", output, [&](const std::string& text, const Place& where) {
    return OutputPattern::parse(text, word, where);
  });
  if (!row.has("output")) row.read("format", format, &picture_format);
}

namespace {

Result<OutputPattern> output_of(const RenderRequest& request, bool sequence) {
  if (request.output) return *request.output;
  if (request.format != nullptr) return OutputPattern::standard(sequence, *request.format);
  return picture_format("png", named_place("--format")).map([&](const PictureFormat* png) {
    return OutputPattern::standard(sequence, *png);
  });
}

// One file holds all frames, or is not there.
Result<void> check_video(const Arguments& arguments, const OutputPattern& output) {
  const PictureFormat& format = output.format();
  if (output.has_frame())
    return usage_error(
        arguments.where("output"),
        fmt::format("has a place for numbers of frames, and a .{} holds all frames", format.name),
        fmt::format("say video.{}", format.name));
  if (output.is_stdout() && !format.by_ffmpeg.empty())
    return usage_error(arguments.where("format"),
                       fmt::format("a .{} is made by ffmpeg, as a file", format.name),
                       "name the file, or say --format y4m");
  for (const char* option : {"resume", "shard"})
    if (arguments.has(option))
      return usage_error(
          arguments.where(option),
          fmt::format("does not go with a .{}, which is written as a whole", format.name),
          "leave it out, or write frame_####.png");
  return {};
}

Result<void> check_places(const Arguments& arguments, const OutputPattern& output,
                          std::size_t frames) {
  const std::size_t scenes = arguments.operands().size();
  const bool video = output.format().is_video();
  if (video)
    if (auto fits = check_video(arguments, output); !fits) return fits;
  if (frames > 1 && !output.has_frame() && !video)
    return usage_error(
        arguments.where("output"), fmt::format("has no place for the numbers of {} frames", frames),
        output.is_stdout()
            ? "choose one, as -f 1, or say --format y4m"
            : fmt::format("say frame_####.{}, or choose one frame, as -f 1", output.format().name));
  if (scenes > 1 && !output.has_scene())
    return usage_error(
        arguments.where("output"), fmt::format("has no place for the names of {} scenes", scenes),
        output.is_stdout() ? "choose one scene"
        : video ? "say {scene} in it, as out/{scene}." + std::string(output.format().name)
                : "say {scene} in it, as out/{scene}/####.png");
  return {};
}

Result<RenderJob> make_job(const Arguments& arguments, const RenderRequest& request, Scene scene) {
  std::vector<unsigned> frames(scene.frames);
  std::iota(frames.begin(), frames.end(), 1U);
  if (request.frames) frames = *request.frames;
  if (scene.ends && frames.back() > scene.frames)
    return usage_error(arguments.where("frames"),
                       fmt::format("there is no frame {} in {}", frames.back(), scene.name),
                       fmt::format("its lines are frames 1 to {}", scene.frames));
  FLATRAY_TRY(output, output_of(request, scene.frames > 1 || frames.size() > 1));
  FLATRAY_TRY(fits, check_places(arguments, *output, frames.size()));
  std::string name;
  if (output->has_scene()) {
    FLATRAY_TRY(plain, plain_name(scene.name));
    name = std::move(*plain);
  }
  const std::uint64_t seed = request.scene.seed_of(scene);
  RenderJob job{.scene = std::move(scene),
                .name = name,
                .output = *output,
                .frames = frames_of(request.shard, frames),
                .last_frame = frames.back(),
                .shard = request.shard,
                .crop = std::nullopt,
                .seed = seed,
                .keep_all = request.keep_all};
  if (request.crop) {
    const FilmSize film{job.scene.film.width, job.scene.film.height};
    FLATRAY_TRY(crop, parse_crop(*request.crop, arguments.where("crop"), film));
    job.crop = *crop;
  }
  return job;
}

}  // namespace

Result<std::vector<RenderJob>> make_jobs(const Arguments& arguments, const RenderRequest& request) {
  std::vector<RenderJob> jobs;
  Diagnostics problems;
  std::vector<Override> size;  // before the scene's own is held against the limit
  if (request.size)
    size.push_back({"film.size", fmt::format("[{}, {}]", request.size->width, request.size->height),
                    arguments.where("size")});
  std::set<std::string> names;
  for (const std::string& path : arguments.operands()) {
    Result<LoadedScene> loaded = load_input(request.scene, path, size);
    if (loaded) report_warnings(loaded->warnings, arguments);
    Result<RenderJob> job = loaded ? make_job(arguments, request, std::move(loaded->scene))
                                   : Result<RenderJob>(fail(std::move(loaded)));
    if (job) report_warnings(unseen_in(job->scene, job->seed), arguments);
    if (!job) {
      problems.insert(problems.end(), job.error().begin(), job.error().end());
      continue;
    }
    if (!names.insert(job->name).second)
      problems.push_back({named_place(path),
                          fmt::format("another scene is named '{}', too", job->name),
                          "render them one by one, with -o", Trouble::usage});
    jobs.push_back(std::move(*job));
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return jobs;
}

}  // namespace flatray
