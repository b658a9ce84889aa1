#include <fmt/core.h>

#include "app/files/scene_input.h"
#include "app/frames/profile.h"
#include "app/frames/render_run.h"
#include "app/help/build_parts.h"
#include "app/options/backend_choice.h"
#include "app/options/resource_limits.h"
#include "app/options/tracer_choice.h"
#include "app/options/view_choice.h"
#include "app/report/report.h"
#include "base/left_out.h"

namespace flatray::verbs {
namespace {

constexpr auto kOptions = with_scene_options(
    {{"output", 'o', "PATTERN", "where to: out/frame_####.png, {scene}, - for standard output"},
     {"frames", 'f', "LIST", "frames, as 1..240:2,300 (default: all of the scene)"},
     kThreadsOption,
     {"size", '\0', "WxH", "size of the pictures instead of the scene's"},
     {"crop", '\0', "x0,y0,x1,y1", "only this part, pixels from the top left"},
     kBackendOption,
     kSamplesOption,
     kProfileOption,
     kErrorOption,
     kTimeOption,
     kRaysOption,
     kEstimatorOption,
     kRayShardOption,
     kErrorImageOption,
     kViewOption,
     kTracerOption,
     kSeedOption,
     {"shard", '\0', "I/N", "only every N-th of the frames, from the I-th on, I from 0"},
     {"resume", '\0', "", "keep frames already written whole for this very scene, rays of films",
      OptionKind::flag},
     {"dry-run", '\0', "", "say what would be written and write nothing", OptionKind::flag},
     {"keep-all", '\0', "", "draw also what the plan would leave out; same pictures",
      OptionKind::flag},
     {"format", '\0', "NAME", "format where the name does not say it: flatray list pictures",
      OptionKind::text, &picture_format_names},
     kForceOption,
     {"progress", '\0', "auto|always|never", "always: plain lines without a terminal, too"},
     kJsonOption});

Result<ProgressMode> progress_mode(const Arguments& arguments) {
  const auto word = arguments.one_of("progress", {"auto", "always", "never"});
  if (!word) return tl::unexpected(word.error());
  if (*word == "never" || arguments.has("quiet")) return ProgressMode::never;
  return *word == "always" ? ProgressMode::always : ProgressMode::automatic;
}

Result<VerbOutput> to_stdout(const Arguments& arguments, const RenderJob& job, unsigned threads) {
  if (job.frames.empty())
    return usage_error(arguments.where("shard"), "leaves no frame for standard output",
                       "name a file, or leave out --shard");
  const auto bytes = picture_bytes(job, job.frames.front(), threads);
  if (!bytes) return tl::unexpected(bytes.error());
  return VerbOutput{
      .text = {std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size())},
      .picture = true};
}

Result<void> fits_in_memory(const Arguments& arguments, const RenderJob& job) {
  return expect_memory(arguments,
                       static_cast<double>(picture_bytes_at_once(job, job.frames.size(), 1)),
                       fmt::format("a picture of {}x{}", job.picture().width, job.picture().height),
                       "say a smaller --size or --crop");
}

// Of --backend auto: a back end that does not add light is not the one of choice for lamps.
bool wants_software(const Arguments& arguments, const RenderJob& job) {
  return arguments.text("backend") == "auto" && !job.scene.lamps.empty();
}

Result<VerbOutput> run(const Arguments& given) {
  const auto chosen = with_profile(given);
  if (!chosen) return tl::unexpected(chosen.error());
  const Arguments& arguments = *chosen;
  const auto request = read_request(arguments);
  if (!request) return tl::unexpected(request.error());
  const auto light = read_light_wish(arguments);
  if (!light) return tl::unexpected(light.error());
  const auto mode = progress_mode(arguments);
  if (!mode) return tl::unexpected(mode.error());
  auto jobs = make_jobs(arguments, *request);
  if (!jobs) return tl::unexpected(jobs.error());
  for (const RenderJob& job : *jobs)
    if (auto able = can_draw(job.scene, left_out_of_build()); !able) return fail(std::move(able));
  const auto renderer = chosen_renderer(arguments, request->threads);
  if (!renderer) return tl::unexpected(renderer.error());
  const auto view = chosen_view(arguments);
  if (!view) return tl::unexpected(view.error());
  const auto tracer = chosen_tracer(arguments);
  if (!tracer) return tl::unexpected(tracer.error());
  if (*view)
    if (auto can = check_tracer_of_view(arguments, *tracer, *(*view)->view); !can)
      return fail(std::move(can));
  for (RenderJob& job : *jobs) {
    job.tracer = *tracer;
    if (*renderer != nullptr && wants_software(arguments, job))
      report_warnings(
          {{arguments.where("backend"),
            fmt::format("the lamps of '{}' are drawn by the software back end", job.scene.name),
            "GL adds no light"}},
          arguments);
    else
      job.renderer = *renderer;
    job.view = *view;
    if (*view && job.output.format().of_picture == nullptr)
      return usage_error(arguments.where("view"), "has no light for an HDR picture",
                         "write a PNG file");
    if (auto wished = wish_light(arguments, *light, job); !wished) return fail(std::move(wished));
    if (auto fits = fits_in_memory(arguments, job); !fits) return fail(std::move(fits));
  }
  const auto list = work_list(*jobs, *request);
  if (!list) return tl::unexpected(list.error());
  if (arguments.has("dry-run")) return describe(*list);
  const RenderJob& first = jobs->front();
  if (first.output.is_stdout() && arguments.has("json"))
    return usage_error(arguments.where("json"), "standard output is taken by the picture",
                       "leave out --json, or write to a file");
  if (first.output.is_stdout() && !first.output.format().is_video())
    return to_stdout(arguments, first, request->threads);
  return render_all(arguments, *list, *mode);
}

}  // namespace

extern const Verb render = {
    "render",
    "SCENE...",
    "draw frames of scenes into picture files",
    1,
    10'000,
    kOptions,
    "  flatray render scenes/demo.toml\n"
    "  flatray render scene.toml -f 3 -o hall.png\n"
    "  flatray render scene.toml -o 'out/frame_####.png' -j 4 --resume\n"
    "  flatray render scene.toml --shard 0/3        # and 1/3, 2/3 elsewhere\n"
    "  flatray render scene.toml --profile scene.profile --error 0.002\n"
    "  flatray render scene.toml --view visibility:3,4 -o lit.png\n"
    "  flatray render lamps.toml --error 0.01 --error-image error.pfm -o lit.png\n"
    "  flatray render lamps.toml --rays 100000000 -o lit.film --resume\n"
    "  flatray render scene.toml -f 1..240 -o video.mp4 -j 4\n"
    "  flatray render scene.toml -o - --format y4m | ffmpeg -i - video.mkv\n",
    "nothing rendered",
    &run,
    nullptr,
    "frames written are whole, and the same command with --resume goes on"};

}  // namespace flatray::verbs
