#include "app/frames/render_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>

#include "app/frames/frame_source.h"
#include "app/frames/light_files.h"
#include "app/frames/video_maker.h"
#include "app/interrupt.h"
#include "base/counted.h"
#include "base/file.h"
#include "base/json.h"
#include "base/parallel.h"
#include "collide/scene_timeline.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Draws and writes the frames of one job in runs of neighbours, which have most in common.
class FrameMaker {
 public:
  FrameMaker(const RenderJob& job, const FrameSource& source, const std::vector<unsigned>& frames,
             const Spread& spread, const std::function<void()>& done, const Claim* claim)
      : job_(job), source_(source), frames_(frames), spread_(spread), done_(done), claim_(claim) {}

  JobResult operator()() {
    std::vector<JobResult> runs((frames_.size() + run_ - 1) / run_);
    parallel_for(runs.size(), spread_.frames_at_once,
                 [&](std::size_t run) { make_run(run * run_, runs[run]); });
    JobResult result;
    result.drawn = source_.drawn();
    result.encoded = source_.encoded();
    for (JobResult& made : runs) result.add(std::move(made));
    return result;
  }

 private:
  // Enough runs for each thread to find work to the end.
  static std::size_t run_length(std::size_t count, const Spread& spread) {
    constexpr std::size_t kRunsAThread = 4, kLongest = 32;
    if (spread.frames_at_once == 1) return std::max<std::size_t>(count, 1);
    return std::clamp<std::size_t>(count / (kRunsAThread * spread.frames_at_once), 1, kLongest);
  }

  // Names and lines of a run are flushed together: what a machine that stops then loses of them,
  // --resume makes again. The bytes of a picture are flushed before it has its name.
  void make_run(std::size_t begin, JobResult& made) {
    FrameEncoder encoder(job_, spread_.threads_each, &interrupted);
    write_run(begin, encoder, made);
    made.drawn = encoder.counts();
    made.encoded = encoder.encoded();
    if (made.written.empty() || !job_.output.has_frame()) return;
    flush_folder(job_.folder());
    if (auto flushed = flush_file(manifest_.path()); !flushed && made.problems.empty())
      made.problems = std::move(flushed).error();
  }

  void write_run(std::size_t begin, FrameEncoder& encoder, JobResult& made) {
    const std::size_t end = std::min(begin + run_, frames_.size());
    for (std::size_t i = begin; i < end && !stopped_ && !interrupted(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      if (Result<FrameRecord> record = write(frames_[i], encoder)) {
        if (record->frame == 0) return;
        made.written.push_back(std::move(*record));
        made.seconds.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        done_();
      } else {
        made.problems = std::move(record).error();
        stopped_ = true;
      }
    }
  }

  // A record without frame: the frame was interrupted.
  Result<FrameRecord> write(unsigned frame, FrameEncoder& encoder) const {
    FLATRAY_TRY(made, source_.encode(frame, encoder));
    if (*made == nullptr) return FrameRecord{};
    FrameRecord record = (*made)->record;
    record.frame = frame;
    record.file = job_.path(frame).filename();
    FLATRAY_TRY(written, write((*made)->bytes, record));
    if (job_.light.error_image) {
      FLATRAY_TRY(beside,
                  write_file(job_.light.error_image->path(job_.name, frame), (*made)->error_bytes));
    }
    return record;
  }

  // A single picture with a name of its own needs no list beside it.
  Result<void> write(std::span<const std::byte> bytes, const FrameRecord& record) const {
    const fs::path path = job_.path(record.frame);
    if (!job_.output.has_frame()) return write_file(path, bytes);
    FLATRAY_TRY(file, NewFile::write(path, bytes));
    const auto take_name = [&]() -> Result<void> {
      if (claim_ != nullptr)
        if (auto held = claim_->expect_held(); !held) return held;
      return file->take_name();
    };
    return manifest_.add(manifest_line(record) + "\n", take_name, Journal::Flush::later);
  }

  const RenderJob& job_;
  const FrameSource& source_;
  const std::vector<unsigned>& frames_;
  const Spread spread_;
  const std::function<void()>& done_;
  const Claim* const claim_;
  const std::size_t run_ = run_length(frames_.size(), spread_);
  const Journal manifest_{job_.manifest()};
  std::atomic<bool> stopped_{false};  ///< a write failed: the others need not try
};

// The lines of all manifests in a folder.
Result<std::string> text_of_manifests(const fs::path& folder) {
  std::string all;
  for (const fs::path& manifest : manifests_in(folder)) {
    FLATRAY_TRY(text, Journal(manifest).read());
    all += *text;
  }
  return all;
}

// The lines of a manifest without records of `files`, and without what is no record.
std::string without_files(const std::string& text, const std::set<std::string>& files) {
  std::string lines;
  each_line(text, [&](std::string_view line) {
    const std::optional<FrameRecord> record = parse_manifest_line(line);
    if (record && !files.contains(record->file)) lines += std::string(line) + "\n";
  });
  return lines;
}

// What is told of records of other settings in the pattern of a job, beside which its pictures will
// stand.
std::optional<Diagnostic> mixture(const RenderJob& job, const Records& records) {
  const FrameRecord* first = nullptr;
  std::size_t count = 0;
  const std::string own = job.fingerprint();
  for (const auto& [file, record] : records) {
    if (!job.names(record) || record.scene == own) continue;
    if (first == nullptr) first = &record;
    ++count;
  }
  if (first == nullptr) return std::nullopt;
  return Diagnostic{named_place((job.folder() / job.output.file_pattern(job.name)).string()),
                    fmt::format("{} of another scene or setting, as {} of {}x{}, seed {}",
                                counted(count, "frame") + (count == 1 ? " is" : " are"),
                                first->file, first->width, first->height, first->seed),
                    "draw all frames anew, or each setting in a folder of its own"};
}

// Those of frames made before stay as long as the manifest has these.
Result<void> write_timings(const RenderJob& job, const JobResult& result) {
  const Journal journal(timings_path(job.folder(), job.shard));
  return journal.merge([&](const std::string& text) -> Result<std::string> {
    FLATRAY_TRY(manifest, Journal(job.manifest()).read());
    const Records records = records_of(*manifest);
    std::map<std::string, std::string> timings;
    each_line(text, [&](std::string_view line) {
      const auto value = parse_json(line);
      const std::string name = value ? value->text_of("file") : "";
      if (records.contains(name)) timings[name] = line;
    });
    for (std::size_t i = 0; i < result.written.size(); ++i) {
      const FrameRecord& record = result.written[i];
      timings[record.file] = json_text(
          Fields{{"frame", record.frame}, {"file", record.file}, {"seconds", result.seconds[i]}});
    }
    std::string lines;
    for (const auto& [file, line] : timings) lines += line + "\n";
    return lines;
  });
}

}  // namespace

void JobResult::add(JobResult&& more) {
  drawn += more.drawn;
  encoded += more.encoded;
  std::ranges::move(more.written, std::back_inserter(written));
  seconds.insert(seconds.end(), more.seconds.begin(), more.seconds.end());
  if (problems.empty() && !more.problems.empty()) problems.push_back(more.problems.front());
}

Result<Work> plan_work(const RenderJob& job, bool resume, unsigned threads) {
  Work work{&job, {}, {}};
  std::vector<FrameRecord> candidates;
  const std::string own = job.fingerprint();
  // Of films it is their frames that go on: each has the rays that are missing added.
  if (resume && job.output.has_frame() && job.output.format().of_film == nullptr) {
    FLATRAY_TRY(text, text_of_manifests(job.folder()));
    each_line(*text, [&](std::string_view line) {
      const auto record = parse_manifest_line(line);
      if (record && job.makes(*record) && record->scene == own) candidates.push_back(*record);
    });
  }
  std::vector<char> whole(candidates.size());
  parallel_for(candidates.size(), threads,
               [&](std::size_t i) { whole[i] = is_whole(candidates[i], job.folder()) ? 1 : 0; });
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (whole[i] != 0) work.kept[candidates[i].file] = candidates[i];
  std::copy_if(job.frames.begin(), job.frames.end(), std::back_inserter(work.frames),
               [&](unsigned frame) { return !work.kept.contains(job.path(frame).filename()); });
  return work;
}

Result<Claim> begin_work(const Work& work, const Outputs& outputs, Diagnostics& warnings) {
  const RenderJob& job = *work.job;
  constexpr std::string_view kFirstName = "{\"frame\":";
  for (const fs::path& list : {job.manifest(), timings_path(job.folder(), job.shard)}) {
    FLATRAY_TRY(allowed, outputs.make_way(list, kFirstName));
  }
  FLATRAY_TRY(lines, text_of_manifests(job.folder()));
  const Records recorded = records_of(*lines);
  std::set<std::string> files;
  for (const unsigned frame : work.frames) {
    const std::string& file = *files.insert(job.path(frame).filename()).first;
    FLATRAY_TRY(allowed, outputs.allow(job.path(frame), job.output.format().beginning,
                                       recorded.contains(file)));
  }
  FLATRAY_TRY(claim, Claim::take(job.folder(), job.output.file_pattern(job.name),
                                 json_text(job.setting()), outputs.force()));
  std::vector<fs::path> manifests = manifests_in(job.folder());
  if (std::ranges::find(manifests, job.manifest()) == manifests.end())
    manifests.push_back(job.manifest());
  Records others;
  for (const fs::path& manifest : manifests) {
    auto merged = Journal(manifest).merge([&](const std::string& text) -> Result<std::string> {
      const Records before = records_of(text);
      const bool own = manifest == job.manifest();
      const bool goes = std::ranges::any_of(
          files, [&](const std::string& file) { return before.contains(file); });
      std::string changed = own || goes ? without_files(text, files) : text;
      for (const auto& [file, record] : work.kept) {  // by --resume, also from others
        const auto there = before.find(file);
        if (own && (there == before.end() || there->second != record))
          changed += manifest_line(record) + "\n";
      }
      others.merge(records_of(changed));
      return changed;
    });
    if (!merged) return fail(std::move(merged));
  }
  if (auto mixed = mixture(job, others)) warnings.push_back(std::move(*mixed));
  return claim;
}

JobResult run_job(const RenderJob& job, const std::vector<unsigned>& frames, unsigned threads,
                  const std::function<void()>& done, const Claim* claim, const Told& told) {
  if (frames.empty()) return {};
  Result<PartTimeline> part = timeline_before_trouble(job.scene, job.seed, job.last_frame);
  if (!part) return {{}, {}, std::move(part).error()};
  std::vector<unsigned> known = frames;
  std::erase_if(known, [&](unsigned frame) { return frame > part->last_frame; });
  const bool video = job.output.format().part != nullptr;  // of all its frames, or none
  if (known.empty() || (video && known.size() < frames.size()))
    return {{}, {}, std::move(part->problems), true};
  const FrameSource source(job, part->timeline, known.front(), known.size(), threads, told);
  JobResult result =
      video ? make_video(job, source, known, threads, done)
            : FrameMaker(job, source, known, spread(job, known.size(), threads), done, claim)();
  if (auto lost = lost_light(job.scene, result.written))
    result.warnings.push_back(std::move(*lost));
  if (auto missed = missed_error(job.light.error, result.written))
    result.warnings.push_back(std::move(*missed));
  if (job.output.has_frame() && result.problems.empty())
    if (auto written = write_timings(job, result); !written)
      result.problems = std::move(written).error();
  if (result.problems.empty()) {
    result.problems = std::move(part->problems);
    result.ends = true;
  }
  return result;
}

Result<std::vector<std::byte>> picture_bytes(const RenderJob& job, unsigned frame,
                                             unsigned threads) {
  const LightGoal goal = job.light.goal();
  const RenderPlan plan = plan_of(job, goal);
  FLATRAY_TRY(timeline, make_timeline(job.scene, job.seed, job.last_frame));
  FrameEncoder encoder(job, threads);
  FLATRAY_TRY(made, encoder.encode(plan, *timeline, frame));
  return (*made)->bytes;
}

}  // namespace flatray
