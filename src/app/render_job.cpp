#include "app/render_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "app/frame_encoder.h"
#include "app/interrupt.h"
#include "app/value.h"
#include "app/version.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "collide/scene_timeline.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Frames are drawn side by side as long as their pictures together stay under this.
constexpr std::uint64_t kMemoryAtOnce = std::uint64_t{1} << 30;

// What one picture takes at its peak, for pixels that do not compress, and what lies still below
// moving things, kept from frame to frame. Not what the scene and its outlines take.
std::uint64_t bytes_of_frame(const RenderJob& job, std::size_t frame_count) {
  const std::uint64_t channels = job.scene.film.background.a == 255 ? 3 : 4;
  const std::uint64_t png_bytes = 3 * channels;  // picture, its bands packed, joined
  constexpr std::uint64_t kHdrBytes =
      12 + 12 + 12;  // picture, without what RGBE lacks, growing file
  const PixelBox box = job.picture();
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(box.width) * static_cast<std::uint64_t>(box.height);
  const std::uint64_t picture =
      pixels * (job.output.format() == PictureFormat::png ? png_bytes : kHdrBytes);
  if (frame_count < 2 || job.keep_all || job.renderer || job.view) return picture;
  return picture + std::min(StillLayer::kMostBytes, StillLayer::kPixelBytes * pixels);
}

// Draws and writes the frames of one job in runs of neighbours, which have most in common.
class FrameMaker {
 public:
  FrameMaker(const RenderJob& job, const Timeline& timeline, const std::vector<unsigned>& frames,
             unsigned threads, const std::function<void()>& done)
      : job_(job),
        frames_(frames),
        spread_(spread(job, frames.size(), threads)),
        run_(run_length(frames.size(), spread_)),
        done_(done),
        plan_(make_plan(job.scene, job.keep_all, job.tracer)),
        timeline_(timeline),
        manifest_(job.manifest()),
        made_((frames.size() + run_ - 1) / run_) {
    if (plan_.still) draw_still(threads);
  }

  void make_all() {
    parallel_for(made_.size(), spread_.frames_at_once,
                 [this](std::size_t run) { make_run(run * run_, made_[run]); });
  }

  JobResult result() {
    JobResult result;
    result.drawn = drawn_;
    result.encoded = encoded_;
    for (Made& made : made_) {
      result.drawn += made.drawn;
      result.encoded += made.encoded;
      result.written.insert(result.written.end(), std::move_iterator(made.records.begin()),
                            std::move_iterator(made.records.end()));
      result.seconds.insert(result.seconds.end(), made.seconds.begin(), made.seconds.end());
      if (result.problems.empty() && !made.problems.empty())
        result.problems.push_back(made.problems.front());  // all threads meet the same full disk
    }
    return result;
  }

 private:
  // Of one run.
  struct Made {
    std::vector<FrameRecord> records;
    std::vector<double> seconds;
    Diagnostics problems;
    DrawCounts drawn;
    std::size_t encoded = 0;
  };

  // Enough runs for each thread to find work to the end.
  static std::size_t run_length(std::size_t count, const Spread& spread) {
    constexpr std::size_t kRunsAThread = 4, kLongest = 32;
    if (spread.frames_at_once == 1) return std::max<std::size_t>(count, 1);
    return std::clamp<std::size_t>(count / (kRunsAThread * spread.frames_at_once), 1, kLongest);
  }

  void draw_still(unsigned threads) {
    FrameEncoder encoder(job_, threads, &interrupted);
    Result<const Encoded*> made = encoder.encode(plan_, timeline_, frames_.front());
    if (!made)
      made_.front().problems = std::move(made).error();
    else if (*made != nullptr)
      still_ = **made;
    stopped_ = !still_;
    drawn_ = encoder.counts();
    encoded_ = encoder.encoded();
  }

  // Names and lines of a run are flushed together: what a machine that stops then loses of them,
  // --resume makes again. The bytes of a picture are flushed before it has its name.
  void make_run(std::size_t begin, Made& made) {
    draw_run(begin, made);
    if (made.records.empty() || !job_.output.has_frame()) return;
    flush_folder(job_.folder());
    if (auto flushed = flush_file(manifest_); !flushed && made.problems.empty())
      made.problems = std::move(flushed).error();
  }

  void draw_run(std::size_t begin, Made& made) {
    FrameEncoder encoder(job_, spread_.threads_each, &interrupted);
    write_run(begin, encoder, made);
    made.drawn = encoder.counts();
    made.encoded = encoder.encoded();
  }

  void write_run(std::size_t begin, FrameEncoder& encoder, Made& made) {
    const std::size_t end = std::min(begin + run_, frames_.size());
    for (std::size_t i = begin; i < end && !stopped_ && !interrupted(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      if (Result<FrameRecord> record = write(frames_[i], encoder)) {
        if (record->frame == 0) return;
        made.records.push_back(std::move(*record));
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
    Result<const Encoded*> made = still_ ? &*still_ : encoder.encode(plan_, timeline_, frame);
    if (!made) return fail(std::move(made));
    if (*made == nullptr) return FrameRecord{};
    const Encoded& picture = **made;
    FrameRecord record = picture.record;
    record.frame = frame;
    record.file = job_.path(frame).filename();
    const Flush flush = job_.output.has_frame() ? Flush::later : Flush::now;
    if (auto written = write_file(job_.path(frame), picture.bytes, flush); !written)
      return fail(std::move(written));
    // A single picture with a name of its own needs no list beside it.
    if (job_.output.has_frame())
      if (auto added = append_line(manifest_, manifest_line(record), flush); !added)
        return fail(std::move(added));
    return record;
  }

  const RenderJob& job_;
  const std::vector<unsigned>& frames_;
  const Spread spread_;
  const std::size_t run_;
  const std::function<void()>& done_;
  const RenderPlan plan_;
  const Timeline& timeline_;
  const fs::path manifest_;
  std::vector<Made> made_;
  std::optional<Encoded> still_;
  DrawCounts drawn_;  ///< for it
  std::size_t encoded_ = 0;
  std::atomic<bool> stopped_{false};  ///< a write failed: the others need not try
};

Records still_valid(const Records& old, std::span<const RenderJob> jobs, bool resume,
                    unsigned threads) {
  std::vector<std::pair<const FrameRecord*, const RenderJob*>> candidates;
  Records kept;
  for (const auto& entry : old) {  // clang 14 cannot capture structured bindings
    const FrameRecord& record = entry.second;
    const auto job = std::find_if(jobs.begin(), jobs.end(),
                                  [&](const RenderJob& one) { return one.makes(record); });
    const bool same_scene = std::any_of(jobs.begin(), jobs.end(), [&](const RenderJob& one) {
      return one.fingerprint() == record.scene;
    });
    if (job == jobs.end() && same_scene) kept[entry.first] = record;
    if (job != jobs.end() && resume && record.scene == job->fingerprint())
      candidates.emplace_back(&record, &*job);
  }
  std::vector<char> whole(candidates.size());
  parallel_for(candidates.size(), threads, [&](std::size_t i) {
    const auto& [record, job] = candidates[i];
    whole[i] = is_whole(*record, job->folder(), job->output.format()) ? 1 : 0;
  });
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (whole[i] != 0) kept[candidates[i].first->file] = *candidates[i].first;
  return kept;
}

// Whoever made a picture of this job, another shard or a run of all, it need not be made again.
Result<void> take_others(Records& records, const RenderJob& job) {
  Result<Records> others = read_other_manifests(job.manifest());
  if (!others) return fail(std::move(others));
  for (const auto& entry : *others)
    if (job.makes(entry.second)) records.insert(entry);
  return {};
}

// Those of frames made before stay as long as the manifest has these.
Result<void> write_timings(const RenderJob& job, const JobResult& result) {
  const fs::path path = timings_path(job.folder(), job.shard);
  Result<Timings> before = read_timings(path);
  if (!before) return fail(std::move(before));
  Result<Records> records = read_manifest(job.manifest());
  if (!records) return fail(std::move(records));
  Timings timings;
  for (const auto& [file, record] : *records)
    if (const auto kept = before->find(record.frame); kept != before->end()) timings.insert(*kept);
  for (std::size_t i = 0; i < result.written.size(); ++i) {
    const unsigned frame = result.written[i].frame;
    timings[frame] = json_text(Fields{{"frame", frame}, {"seconds", result.seconds[i]}});
  }
  std::string lines;
  for (const auto& [frame, line] : timings) lines += line + "\n";
  return write_file(path, lines);
}

}  // namespace

std::string RenderJob::fingerprint() const {
  const PixelBox box = picture();
  Hash hash;
  for (const std::uint64_t part : {scene.hash, seed}) hash.add(part);
  for (const int part : {scene.film.width, scene.film.height, box.x, box.y, box.width, box.height})
    hash.add(static_cast<std::uint64_t>(part));
  if (renderer) hash.add(backend());
  if (view)
    hash.add(view->view->name).add(number_text(view->point.x())).add(number_text(view->point.y()));
  if (tracer != nullptr && !tracer->exact) hash.add(tracer->name);
  return hash.add(flatray::name(output.format())).add(kVersion).hex();
}

bool RenderJob::makes(const FrameRecord& record) const {
  return std::binary_search(frames.begin(), frames.end(), record.frame) &&
         record.file == path(record.frame).filename();
}

Spread spread(const RenderJob& job, std::size_t frame_count, unsigned threads) {
  const std::uint64_t fit =
      std::max<std::uint64_t>(kMemoryAtOnce / bytes_of_frame(job, frame_count), 1);
  const std::uint64_t at_once =
      std::min({std::uint64_t{threads}, fit, std::max<std::uint64_t>(frame_count, 1)});
  return {static_cast<unsigned>(at_once), static_cast<unsigned>(threads / at_once)};
}

std::uint64_t picture_bytes_at_once(const RenderJob& job, std::size_t frame_count,
                                    unsigned threads) {
  return spread(job, frame_count, threads).frames_at_once * bytes_of_frame(job, frame_count);
}

Result<Manifests> kept_records(std::span<const RenderJob> jobs, bool resume, unsigned threads) {
  Manifests manifests;
  for (const RenderJob& job : jobs) {
    if (!job.output.has_frame() || manifests.count(job.manifest()) != 0) continue;
    Result<Records> old = read_manifest(job.manifest());
    if (!old) return fail(std::move(old));
    if (resume)
      if (auto taken = take_others(*old, job); !taken) return fail(std::move(taken));
    manifests[job.manifest()] = still_valid(*old, jobs, resume, threads);
  }
  return manifests;
}

std::vector<unsigned> frames_to_make(const RenderJob& job, const Manifests& kept) {
  const auto found = kept.find(job.manifest());
  if (!job.output.has_frame() || found == kept.end()) return job.frames;
  std::vector<unsigned> frames;
  std::copy_if(
      job.frames.begin(), job.frames.end(), std::back_inserter(frames),
      [&](unsigned frame) { return found->second.count(job.path(frame).filename()) == 0; });
  return frames;
}

JobResult run_job(const RenderJob& job, const std::vector<unsigned>& frames, unsigned threads,
                  const std::function<void()>& done) {
  if (frames.empty()) return {};
  Result<Timeline> timeline = make_timeline(job.scene, job.seed, job.last_frame);
  if (!timeline) return {{}, {}, std::move(timeline).error()};
  FrameMaker maker(job, *timeline, frames, threads, done);
  maker.make_all();
  JobResult result = maker.result();
  if (job.output.has_frame() && result.problems.empty())
    if (auto written = write_timings(job, result); !written)
      result.problems = std::move(written).error();
  return result;
}

Result<std::vector<std::byte>> picture_bytes(const RenderJob& job, unsigned frame,
                                             unsigned threads) {
  const RenderPlan plan = make_plan(job.scene, job.keep_all, job.tracer);
  Result<Timeline> timeline = make_timeline(job.scene, job.seed, job.last_frame);
  if (!timeline) return fail(std::move(timeline));
  FrameEncoder encoder(job, threads);
  Result<const Encoded*> made = encoder.encode(plan, *timeline, frame);
  if (!made) return fail(std::move(made));
  return (*made)->bytes;
}

}  // namespace flatray
