#include <fmt/core.h>

#include <algorithm>

#include "app/files/scene_input.h"
#include "app/frames/profile.h"
#include "app/frames/render_run.h"
#include "app/help/build_parts.h"
#include "app/interrupt.h"
#include "app/options/backend_choice.h"
#include "app/options/resource_limits.h"
#include "app/options/tracer_choice.h"
#include "app/report/report.h"
#include "base/left_out.h"
#include "base/number_text.h"

namespace flatray::render_verb {
namespace {

constexpr Word<ProgressMode> kProgress[] = {{"auto", ProgressMode::automatic},
                                            {"always", ProgressMode::always},
                                            {"never", ProgressMode::never}};

Result<Vec2> read_point(std::string_view text, const std::string& view, const Place& where) {
  const std::vector<std::string_view> parts = split(text, ',');
  const auto x = parse_number(parts[0]);
  const auto y = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  if (!x || !y)
    return usage_error(where, fmt::format("'{}' is not a point", text),
                       fmt::format("say {}:x,y with two numbers", view));
  return Vec2(*x, *y);
}

Result<ViewRequest> parse_view(const std::string& text, const Place& where) {
  const std::string name = text.substr(0, text.find(':'));
  FLATRAY_TRY(view, entry_called("view", views())(name, where));
  ViewRequest request{*view, {0, 0}};
  const bool has_point = name.size() < text.size();
  if (has_point != (*view)->takes_point)
    return usage_error(where, has_point ? "takes no point" : "needs a point",
                       has_point ? "say " + name : fmt::format("say {}:x,y", name));
  if (!has_point) return request;
  FLATRAY_TRY(point, read_point(std::string_view(text).substr(name.size() + 1), name, where));
  request.point = *point;
  return request;
}

std::vector<std::string> view_names() { return names_of(views()); }

struct Options : Arguments {
  RenderRequest request;
  BackendOptions backend;
  ProfileOptions profile;
  LightWish light;
  std::optional<ViewRequest> view;
  const Tracer* tracer = nullptr;
  bool dry_run = false;
  ProgressMode progress = ProgressMode::automatic;

  void rows(OptionTable& row) {
    SceneOptions& scene = request.scene;
    row("-o, --output PATTERN", "where to: out/frame_####.png, {scene}, - for standard output");
    row("-f, --frames LIST", "frames, as 1..240:2,300 (default: all of the scene)", request.frames,
        &parse_frames);
    row_of_threads(row, scene.limits.threads);
    request.row_of_size(row);
    row("--crop x0,y0,x1,y1", "only this part, pixels from the top left", request.crop);
    backend.rows(row);
    profile.rows(row, light);
    light.rows(row);
    row("--view VIEW",
        "instead of a picture one ray a pixel: hits, depth, intervals, visibility:x,y", view,
        &parse_view, &view_names);
    row_of_tracer(row, tracer);
    scene.row_of_seed(row);
    row("--shard I/N", "only every N-th of the frames, from the I-th on, I from 0", request.shard,
        &parse_shard);
    row("--resume", "keep frames already written whole for this very scene, rays of films",
        request.resume);
    row("--dry-run", "say what would be written and write nothing", dry_run);
    row("--keep-all", "draw also what the plan would leave out; same pictures", request.keep_all);
    request.row_of_format(row);
    row(kForceRow);
    row("--progress", "always: plain lines without a terminal, too", progress, kProgress);
    row(kJsonRow);
    scene.rows(row);
    request.read_size(row);
    light.resume = request.resume;
    if (row.has("view") && row.has("backend"))
      row.problem("view", "is drawn by rays, not by a back end", "leave out --backend");
    if (view) expect_tracer_of_view(row, tracer, *view->view);
    if (row.has("quiet")) progress = ProgressMode::never;
  }
};

Result<VerbOutput> to_stdout(const Arguments& arguments, const RenderJob& job, unsigned threads) {
  if (job.frames.empty())
    return usage_error(arguments.where("shard"), "leaves no frame for standard output",
                       "name a file, or leave out --shard");
  catch_interrupts(lost_by_stop(job));
  survive_closed_pipes();
  FLATRAY_TRY(bytes, picture_bytes(job, job.frames.front(), threads));
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

// What the options say of a job's drawing.
Result<void> complete(const Options& options, const std::shared_ptr<const Renderer>& renderer,
                      RenderJob& job) {
  job.tracer = options.tracer;
  for (const char* option : {"view", "tracer"})
    if (options.has(option))
      if (auto straight = expect_no_field(job.scene, fmt::format("--{}", option)); !straight)
        return straight;
  // A back end that does not add light is not the one of choice for lamps.
  if (renderer != nullptr && options.backend.name == "auto" && !job.scene.lamps.empty())
    report_warnings(
        {{options.where("backend"),
          fmt::format("the lamps of '{}' are drawn by the software back end", job.scene.name),
          "GL adds no light"}},
        options);
  else
    job.renderer = renderer;
  const PictureFormat& format = job.output.format();
  if (const double fps = job.scene.fps; format.is_video() && job.frames.size() > 1 &&
                                        (fps < format.least_fps || fps > format.most_fps))
    report_warnings(
        {{options.where(options.has("output") ? "output" : "format"),
          fmt::format("{} keeps from {:.3g} to {:.3g} frames a second, not the {} of '{}'",
                      format.kind, format.least_fps, format.most_fps, number_text(fps),
                      job.scene.name),
          fmt::format("it plays at another speed; say -D fps={:.3g}, or another format",
                      std::clamp(fps, format.least_fps, format.most_fps))}},
        options);
  job.view = options.view;
  if (job.view && format.of_picture == nullptr)
    return usage_error(options.where("view"), "has no light for an HDR picture",
                       "write a PNG file");
  return wish_light(options, options.light, job).and_then([&] {
    return fits_in_memory(options, job);
  });
}

// What a profile chooses, as if it had been given.
Result<Options> with_profile(Options options) {
  FLATRAY_TRY(chosen, choose_by_profile(options, options.profile, options.request.scene));
  Diagnostics problems;
  OptionTable table(options, problems);
  options.backend.rows(table);
  options.request.scene.overrides.clear();
  options.request.scene.rows(table);
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return options;
}

Result<VerbOutput> run(const Options& given) {
  FLATRAY_TRY(chosen, with_profile(given));
  const Options& options = *chosen;
  const RenderRequest& request = options.request;
  FLATRAY_TRY(jobs, make_jobs(options, request));
  for (const RenderJob& job : *jobs)
    if (auto able = can_draw(job.scene, left_out_of_build()); !able) return fail(std::move(able));
  FLATRAY_TRY(renderer, chosen_renderer(options.backend, request.threads()));
  for (RenderJob& job : *jobs) {
    FLATRAY_TRY(completed, complete(options, *renderer, job));
  }
  FLATRAY_TRY(list, work_list(*jobs, request));
  if (options.dry_run) return describe(*list);
  const RenderJob& first = jobs->front();
  if (first.output.is_stdout() && options.has("json"))
    return usage_error(options.where("json"), "standard output is taken by the picture",
                       "leave out --json, or write to a file");
  if (first.output.is_stdout() && !first.output.format().is_video())
    return to_stdout(options, first, request.threads());
  return render_all(options, *list, options.progress);
}

}  // namespace

extern const Verb entry = {
    "render",
    "SCENE...",
    "draw frames of scenes into picture files",
    kCommand<Options, &run>,
    "  flatray render scenes/demo.toml\n"
    "  flatray render scene.toml -f 3 -o hall.png\n"
    "  flatray render scene.toml -o 'out/frame_####.png' -j 4 --resume\n"
    "  flatray render scene.toml --shard 0/3        # and 1/3, 2/3 elsewhere\n"
    "  flatray render scene.toml --profile scene.profile --error 0.002\n"
    "  flatray render scene.toml --view visibility:3,4 -o lit.png\n"
    "  flatray render lamps.toml --error 0.01 --error-image error.pfm -o lit.png\n"
    "  flatray render lamps.toml --rays 100000000 -o lit.film --resume\n"
    "  flatray render scene.toml -f 1..240 -o video.mp4 -j 4\n"
    "  flatray render scene.toml -o - --format y4m | ffmpeg -colorspace bt709 -i - video.mkv\n",
    "nothing rendered",
    nullptr,
    "frames written are whole, and the same command with --resume goes on"};

}  // namespace flatray::render_verb
