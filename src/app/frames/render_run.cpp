#include "app/frames/render_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "app/files/journal.h"
#include "app/files/manifest.h"
#include "app/interrupt.h"
#include "app/report/report.h"
#include "base/counted.h"
#include "base/file.h"

namespace flatray {
namespace {

// What it took: counts, the same whenever it is done again by as many threads.
JsonValue work_value(const JobResult& result) {
  const DrawCounts& drawn = result.drawn;
  return Fields{{"pictures_encoded", result.encoded},
                {"bands_drawn", drawn.bands},
                {"bands_kept", drawn.kept_bands},
                {"pieces", drawn.items},
                {"pieces_hidden", drawn.hidden_items},
                {"pieces_scanned", drawn.scans},
                {"pixels", drawn.pixels},
                {"pixels_kept", drawn.kept_pixels}};
}

// Records of the job's frames, kept and written, as --json shows them.
JsonValue job_value(const Work& work, const JobResult& result) {
  std::map<unsigned, FrameRecord> records;
  for (const auto& [file, record] : work.kept) records[record.frame] = record;
  for (const FrameRecord& record : result.written) records[record.frame] = record;
  Values frames;
  for (const auto& [frame, record] : records) frames.push_back(as_value(record));
  return Fields{{"scene", work.job->scene.name},    {"folder", work.job->folder().string()},
                {"written", result.written.size()}, {"kept", work.kept.size()},
                {"work", work_value(result)},       {"frames", std::move(frames)}};
}

class Run {
 public:
  Run(const Arguments& arguments, const WorkList& list, ProgressMode mode)
      : arguments_(arguments), list_(list), mode_(mode) {
    if (lost_ != nullptr) catch_interrupts(lost_);
  }

  VerbOutput operator()() {
    if (const auto begun = begin(); !begun) return give_up(begun.error());
    for (const Work& work : list_.works) {
      if (interrupted()) break;
      const auto hold = holds_.find(&work);
      JobResult result = run_job(
          work, list_.threads, [this] { progress_.step(); },
          hold == holds_.end() ? nullptr : &hold->second,
          [this](const std::string& news) { progress_.tell(news); });
      if (!result.warnings.empty()) progress_.finish();
      report_warnings(result.warnings, arguments_);
      written_ += result.written.size();
      kept_ += work.kept.size();
      results_.push_back(job_value(work, result));
      if (!result.problems.empty()) return give_up(result.problems, result.ends);
    }
    return finish();
  }

 private:
  static std::size_t total(const WorkList& list) {
    std::size_t count = 0;
    for (const Work& work : list.works) count += work.frames.size();
    return count;
  }

  static bool has_light(const WorkList& list) {
    return std::ranges::any_of(list.works, [](const Work& work) { return work.job->has_light(); });
  }

  // All that can be refused is refused before anything is written or removed. Where nothing is to be
  // done nothing is written. Files of runs that were killed go first.
  Result<void> begin() {
    Diagnostics warnings;
    for (const Work& work : list_.works) {
      if (const auto link = work.job->output.link_chosen_by(work.job->name))
        return fail(named_place(link->string()), "is a link, and a scene's name led to it",
                    "remove it, or write the folder out in -o", Trouble::output);
      if (auto free = expect_place(work, outputs_, warnings); !free) return free;
    }
    for (const Work& work : list_.works) {
      if (!work.job->output.has_frame() || work.frames.empty()) continue;
      FLATRAY_TRY(hold, hold_pattern(*work.job, outputs_));
      holds_.emplace(&work, std::move(*hold));
    }
    for (const Work& work : list_.works) {
      if (work.job->output.is_stdout()) continue;
      remove_leftovers(work.job->folder());
      if (!work.frames.empty()) continue;
      for (const std::filesystem::path& manifest : manifests_in(work.job->folder()))
        if (auto mended = Journal(manifest).mend(); !mended) return mended;
    }
    report_warnings(warnings, arguments_);
    return {};
  }

  // `ends`: by what the scene says, which no other run changes.
  VerbOutput give_up(const Diagnostics& problems, bool ends = false) {
    progress_.finish();
    const std::string goes_on =
        written_ == 0
            ? "nothing rendered"
            : fmt::format("{} of {} written{}", written_, counted(total_, "frame"),
                          ends || lost_ != nullptr ? "" : "; --resume goes on from there");
    return {.results = failed_results(problems), .exit_code = report_failure(problems, goes_on)};
  }

  VerbOutput finish() {
    progress_.finish();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
    const bool stopped = written_ < total_;
    if (stopped)
      report_note(fmt::format("flatray: {}, {} of {} written; {}", interruption(), written_,
                              counted(total_, "frame"),
                              lost_ != nullptr ? lost_ : "the same command with --resume goes on"));
    else if (!arguments_.has("quiet"))
      report_note(fmt::format("flatray: {} written{} in {:.2f} s", counted(written_, "frame"),
                              kept_ == 0 ? "" : fmt::format(", {} kept,", kept_), time.count()));
    return {.results = std::move(results_), .exit_code = stopped ? interrupted_code() : 0};
  }

  const Arguments& arguments_;
  const WorkList& list_;
  const ProgressMode mode_;
  const std::size_t total_ = total(list_);
  Progress progress_{total_, mode_, "frames", has_light(list_)};
  /// By a stop, so that --resume does not go on; else null.
  const char* const lost_ = list_.works.empty() ? nullptr : lost_by_stop(*list_.works.front().job);
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t written_ = 0, kept_ = 0;
  const Outputs outputs_{arguments_};
  std::map<const Work*, Hold> holds_;  ///< of sequences
  Values results_;
};

}  // namespace

const char* lost_by_stop(const RenderJob& job) {
  const PictureFormat& format = job.output.format();
  if (format.is_video()) return "nothing of a video is kept";
  const bool alone = job.output.is_stdout() || !job.output.has_frame();
  if (alone && job.has_light() && format.of_film == nullptr)
    return "nothing of a picture's light is kept; -o NAME.film --resume keeps and adds to it";
  return job.output.is_stdout() ? "nothing of a picture on standard output is kept" : nullptr;
}

Result<WorkList> work_list(const std::vector<RenderJob>& jobs, const RenderRequest& request) {
  WorkList list{{}, request.threads()};
  for (const RenderJob& job : jobs) {
    FLATRAY_TRY(work, plan_work(job, request.resume, request.threads()));
    list.works.push_back(std::move(*work));
  }
  return list;
}

VerbOutput describe(const WorkList& list) {
  VerbOutput output;
  for (const Work& work : list.works) {
    const RenderJob* const job = work.job;
    const std::vector<unsigned>& frames = work.frames;
    const PixelBox size = job->picture();
    const std::uint64_t bytes = picture_bytes_at_once(*job, frames.size(), list.threads);
    std::string text = fmt::format("{}: {} of {}x{}, {} kept, at most {:.1f} MB for pictures\n",
                                   job->scene.name, counted(frames.size(), "frame"), size.width,
                                   size.height, work.kept.size(), static_cast<double>(bytes) / 1e6);
    Values files;
    for (const unsigned frame : frames) {
      if (!files.empty() && job->output.format().is_video()) break;  // one file of all frames
      files.emplace_back(job->path(frame).string());
      text += job->path(frame).string() + "\n";
    }
    output.add(Fields{{"scene", job->scene.name},
                      {"width", size.width},
                      {"height", size.height},
                      {"files", std::move(files)},
                      {"kept", work.kept.size()},
                      {"picture_bytes", bytes}},
               std::move(text));
  }
  return output;
}

VerbOutput render_all(const Arguments& arguments, const WorkList& list, ProgressMode mode) {
  return Run(arguments, list, mode)();
}

}  // namespace flatray
