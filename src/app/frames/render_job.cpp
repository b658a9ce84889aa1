#include "app/frames/render_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>

#include "app/frames/frame_source.h"
#include "app/frames/light_files.h"
#include "app/frames/video_maker.h"
#include "app/interrupt.h"
#include "base/counted.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/parallel.h"
#include "collide/scene_timeline.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstName = "{\"frame\":";  // of a line of a list

// Beside the pictures of a sequence.
std::array<fs::path, 2> lists_of(const RenderJob& job) {
  return {job.manifest(), timings_path(job.folder(), job.shard)};
}

// Removes the records of frames to be made from all manifests, and adds those that --resume keeps to the
// manifest of the job.
Result<void> drop_records(const Work& work, const Outputs& outputs) {
  const RenderJob& job = *work.job;
  for (const fs::path& list : lists_of(job))
    if (auto free = outputs.make_way(list, kFirstName); !free) return free;
  std::set<std::string> files;
  for (const unsigned frame : work.frames) files.insert(job.path(frame).filename());
  const std::string setting = job.fingerprint();
  const auto goes = [&](const std::string& line, const FrameRecord& record) {
    return files.contains(record.file) &&
           (record.scene != setting || work.planned_on.contains(line));
  };
  std::vector<fs::path> manifests = manifests_in(job.folder());
  if (std::ranges::find(manifests, job.manifest()) == manifests.end())
    manifests.push_back(job.manifest());
  for (const fs::path& manifest : manifests) {
    auto merged = Journal(manifest).merge([&](const std::string& text) -> Result<std::string> {
      const Records before = records_of(text);
      const bool own = manifest == job.manifest();
      bool any_goes = false;
      std::string left;  // without what is no record
      each_line(text, [&](std::string_view line) {
        const std::optional<FrameRecord> record = parse_manifest_line(line);
        if (!record) return;
        const bool gone = goes(std::string(line), *record);
        any_goes = any_goes || gone;
        if (!gone) left += std::string(line) + "\n";
      });
      std::string changed = own || any_goes ? left : text;
      for (const auto& [file, record] : work.kept) {
        const auto there = before.find(file);
        if (own && (there == before.end() || there->second != record))
          changed += manifest_line(record) + "\n";
      }
      return changed;
    });
    if (!merged) return merged;
  }
  return {};
}

// Draws and writes the frames of one job in runs of neighbours, which have most in common.
class FrameMaker {
 public:
  FrameMaker(const Work& work, const FrameSource& source, const std::vector<unsigned>& frames,
             const Spread& spread, const std::function<void()>& done, const Hold* hold)
      : work_(work), source_(source), frames_(frames), spread_(spread), done_(done), hold_(hold) {}

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

  // Names of pictures and lines of the manifest are flushed once a run. Where the machine stops before,
  // --resume makes again what is lost. The bytes of a picture are flushed before it has its name.
  void make_run(std::size_t begin, JobResult& made) {
    FrameEncoder encoder(job_, spread_.threads_each, &interrupted);
    write_run(begin, encoder, made);
    made.drawn = encoder.counts();
    made.encoded = encoder.encoded();
    if (made.written.empty() || !job_.output.has_frame()) return;
    if (const auto& image = job_.light.error_image)
      flush_folder(image->path(job_.name, 1).parent_path());
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
  Result<FrameRecord> write(unsigned frame, FrameEncoder& encoder) {
    if (job_.output.format().of_film != nullptr)  // written while it is traced
      if (auto begun = begin(); !begun) return fail(std::move(begun));
    FLATRAY_TRY(made, source_.encode(frame, encoder));
    if (*made == nullptr) return FrameRecord{};
    FrameRecord record = (*made)->record;
    record.frame = frame;
    record.file = job_.path(frame).filename();
    if (const auto& image = job_.light.error_image) {
      const fs::path path = image->path(job_.name, frame);
      std::error_code ignored;  // a folder that cannot be looked at, writing tells
      if (fs::weakly_canonical(folder_of(path), ignored) ==
          fs::weakly_canonical(job_.folder(), ignored))
        record.error_file = path.filename();
    }
    FLATRAY_TRY(written, write(**made, record));
    return record;
  }

  // Drops the records of frames to be made, once, when the first frame is about to be written: a frame that
  // cannot be drawn changes no record.
  Result<void> begin() {
    std::call_once(once_, [this] {
      if (hold_ != nullptr)
        begun_ = hold_->claim.expect_held().and_then(
            [this] { return drop_records(work_, *hold_->outputs); });
    });
    return begun_;
  }

  // The picture of the error takes its name first, so that it is there wherever its picture is. Only frames of a
  // sequence have lines in a manifest.
  Result<void> write(const Encoded& made, const FrameRecord& record) {
    std::vector<NewFile> files;
    const auto add = [&](const fs::path& path, std::span<const std::byte> bytes) -> Result<void> {
      FLATRAY_TRY(file, NewFile::write(path, bytes));
      files.push_back(std::move(*file));
      return {};
    };
    if (const auto& image = job_.light.error_image) {
      FLATRAY_TRY(beside, add(image->path(job_.name, record.frame), made.error_bytes));
    }
    FLATRAY_TRY(whole, add(job_.path(record.frame), made.bytes));
    const auto take_names = [&]() -> Result<void> {
      if (hold_ != nullptr)
        if (auto held = hold_->claim.expect_held(); !held) return held;
      for (NewFile& file : files) {
        if (auto named = file.take_name(); !named) return named;
        if (!job_.output.has_frame()) flush_folder(file.path().parent_path());
      }
      return {};
    };
    if (auto begun = begin(); !begun) return begun;
    if (job_.output.has_frame())
      return manifest_.add(manifest_line(record) + "\n", take_names, Journal::Flush::later);
    return take_names();
  }

  const Work& work_;
  const RenderJob& job_ = *work_.job;
  const FrameSource& source_;
  const std::vector<unsigned>& frames_;
  const Spread spread_;
  const std::function<void()>& done_;
  const Hold* const hold_;
  const std::size_t run_ = run_length(frames_.size(), spread_);
  const Journal manifest_{job_.manifest()};
  std::once_flag once_;
  Result<void> begun_{};
  std::atomic<bool> stopped_{false};  ///< a write failed: the others need not try
};

// Whether all that was made of a frame is there and whole, with the picture of its error where the
// job asks for one.
bool is_kept(const RenderJob& job, const FrameRecord& record) {
  if (!is_whole(record, job.folder())) return false;
  const auto& image = job.light.error_image;
  return !image || is_error_image(record, image->path(job.name, record.frame));
}

// The lines of all manifests in a folder. `replaceable` may be unreadable: --force replaces it.
Result<std::string> text_of_manifests(const fs::path& folder, const fs::path& replaceable) {
  std::string all;
  for (const fs::path& manifest : manifests_in(folder)) {
    auto text = Journal(manifest).read();
    if (text)
      all += *text;
    else if (manifest != replaceable)
      return text;
  }
  return all;
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
  const bool keeps = resume && job.output.format().of_film == nullptr;
  if (job.output.has_frame()) {
    FLATRAY_TRY(text, text_of_manifests(job.folder(), keeps ? fs::path() : job.manifest()));
    each_line(*text, [&](std::string_view line) {
      const auto record = parse_manifest_line(line);
      if (!record) return;
      work.planned_on.emplace(line);
      work.recorded[record->file] = *record;
      if (keeps && job.makes(*record) && record->scene == own) candidates.push_back(*record);
    });
  }
  std::vector<char> whole(candidates.size());
  parallel_for(candidates.size(), threads,
               [&](std::size_t i) { whole[i] = is_kept(job, candidates[i]) ? 1 : 0; });
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (whole[i] != 0) work.kept[candidates[i].file] = candidates[i];
  std::copy_if(job.frames.begin(), job.frames.end(), std::back_inserter(work.frames),
               [&](unsigned frame) { return !work.kept.contains(job.path(frame).filename()); });
  return work;
}

Result<void> expect_place(const Work& work, const Outputs& outputs, Diagnostics& warnings) {
  const RenderJob& job = *work.job;
  if (job.output.is_stdout() || work.frames.empty()) return {};
  Records recorded = work.recorded;
  if (const auto& image = job.light.error_image)
    for (const unsigned frame : work.frames) {
      const auto record = recorded.find(job.path(frame).filename());
      const bool ours = record != recorded.end() && !record->second.error_image.empty();
      if (auto free = outputs.allow(image->path(job.name, frame), image->format().beginning, ours);
          !free)
        return free;
    }
  for (const unsigned frame : work.frames) {
    const fs::path path = job.path(frame);
    const bool ours = recorded.erase(path.filename()) > 0;
    if (auto free = outputs.allow(path, job.output.format().beginning, ours); !free) return free;
    if (job.output.format().is_video()) break;  // one file of all frames
  }
  if (job.output.has_frame())
    for (const fs::path& list : lists_of(job))
      if (auto free = outputs.allow(list, kFirstName); !free) return free;
  if (auto mixed = mixture(job, recorded)) warnings.push_back(std::move(*mixed));
  return expect_films(job, work.frames);
}

Result<Hold> hold_pattern(const RenderJob& job, const Outputs& outputs) {
  FLATRAY_TRY(claim, Claim::take(job.folder(), job.output.file_pattern(job.name),
                                 json_text(job.setting()), outputs.force()));
  return Hold{std::move(*claim), &outputs};
}

JobResult run_job(const Work& work, unsigned threads, const std::function<void()>& done,
                  const Hold* hold, const Told& told) {
  const RenderJob& job = *work.job;
  if (work.frames.empty()) return {};
  Result<PartTimeline> part = timeline_before_trouble(job.scene, job.seed, job.last_frame);
  if (!part) return {{}, {}, std::move(part).error()};
  std::vector<unsigned> known = work.frames;
  std::erase_if(known, [&](unsigned frame) { return frame > part->last_frame; });
  const bool video = job.output.format().part != nullptr;  // of all its frames, or none
  if (known.empty() || (video && known.size() < work.frames.size()))
    return {{}, {}, std::move(part->problems), true};
  const FrameSource source(job, part->timeline, known.front(), known.size(), threads, told);
  JobResult result =
      video ? make_video(job, source, known, threads, done)
            : FrameMaker(work, source, known, spread(job, known.size(), threads), done, hold)();
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
