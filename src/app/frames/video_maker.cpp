#include "app/frames/video_maker.h"

#include <algorithm>
#include <chrono>
#include <deque>

#include "app/frames/video_file.h"
#include "app/interrupt.h"
#include "base/hash.h"
#include "base/parallel.h"

namespace flatray {
namespace {

// A thread that draws, from one turn to the next, and what it has drawn in this one.
struct DrawingThread {
  DrawingThread(const RenderJob& job, unsigned threads) : encoder(job, threads, &interrupted) {}
  FrameEncoder encoder;
  std::vector<Encoded> drawn{};
  std::vector<double> seconds{};
  Diagnostics problems{};
};

class VideoMaker {
 public:
  VideoMaker(const RenderJob& job, const FrameSource& source, const std::vector<unsigned>& frames,
             const Spread& spread, const std::function<void()>& done, VideoFile file)
      : job_(job), source_(source), frames_(frames), done_(done), file_(std::move(file)) {
    for (unsigned i = 0; i < spread.frames_at_once; ++i)
      threads_.emplace_back(job, spread.threads_each);
  }

  // While these threads draw, one more thread writes what they drew before.
  JobResult operator()() {
    const std::size_t count = threads_.size();
    for (std::size_t first = 0; first < frames_.size() && goes_on(); first += count * turn_) {
      parallel_for(count + 1, static_cast<unsigned>(count) + 1, [&](std::size_t i) {
        if (i == count)
          write();
        else
          draw(threads_[i], first + i * turn_);
      });
      collect();
    }
    if (goes_on()) write();
    if (goes_on()) {
      auto finished = file_.finish();
      whole_ = finished.has_value();
      if (!whole_) result_.problems = std::move(finished).error();
    }
    return result();
  }

 private:
  bool goes_on() const { return result_.problems.empty() && !interrupted(); }

  void draw(DrawingThread& thread, std::size_t first) const {
    const std::size_t end = std::min(first + turn_, frames_.size());
    for (std::size_t i = first; i < end; ++i) {
      const auto start = std::chrono::steady_clock::now();
      Result<const Encoded*> made = source_.encode(frames_[i], thread.encoder);
      if (!made) {
        thread.problems = made.error();
        return;
      }
      if (*made == nullptr) return;
      thread.drawn.push_back(**made);
      thread.seconds.push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  }

  // What the threads have drawn becomes what is to be written.
  void collect() {
    for (DrawingThread& thread : threads_) {
      std::move(thread.drawn.begin(), thread.drawn.end(), std::back_inserter(waiting_));
      result_.seconds.insert(result_.seconds.end(), thread.seconds.begin(), thread.seconds.end());
      if (result_.problems.empty()) result_.problems = std::move(thread.problems);
      thread.drawn.clear(), thread.seconds.clear();
    }
  }

  void write() {
    for (; !waiting_.empty() && !interrupted(); waiting_.pop_front()) {
      const std::size_t index = result_.written.size();
      const std::vector<std::byte> part = format_.part(waiting_.front().bytes, index, sequence_);
      hash_.add(part);
      if (auto added = file_.add(part); !added) {
        result_.problems = std::move(added).error();
        return;
      }
      FrameRecord& record = result_.written.emplace_back(std::move(waiting_.front().record));
      record.frame = frames_[index];
      record.file = job_.path(record.frame).filename();
      done_();
    }
  }

  JobResult result() {
    result_.drawn = source_.drawn();
    result_.encoded = source_.encoded();
    for (const DrawingThread& thread : threads_) {
      result_.drawn += thread.encoder.counts();
      result_.encoded += thread.encoder.encoded();
    }
    if (interrupted()) result_.problems.clear();  // as it may end the program, too
    if (!whole_ && file_.is_file()) result_.written.clear(), result_.seconds.clear();
    for (FrameRecord& record : result_.written) record.bytes = hash_.hex();
    return std::move(result_);
  }

  const RenderJob& job_;
  const FrameSource& source_;
  const std::vector<unsigned>& frames_;
  const std::size_t turn_ = frames_a_turn(job_);
  const std::function<void()>& done_;
  VideoFile file_;
  const PictureFormat& format_ = job_.output.format();
  const FrameSequence sequence_{job_.picture().width, job_.picture().height, frames_.size(),
                                std::clamp(job_.scene.fps, format_.least_fps, format_.most_fps)};
  std::deque<DrawingThread> threads_;  // which are never moved
  std::deque<Encoded> waiting_;
  Hash hash_;           ///< of all parts
  bool whole_ = false;  ///< the file has its name
  JobResult result_;
};

}  // namespace

JobResult make_video(const RenderJob& job, const FrameSource& source,
                     const std::vector<unsigned>& frames, unsigned threads,
                     const std::function<void()>& done) {
  auto file = VideoFile::begin(job.output.format(), job.path(frames.front()));
  if (!file) return {{}, {}, std::move(file).error()};
  return VideoMaker(job, source, frames, spread(job, frames.size(), threads), done,
                    std::move(*file))();
}

}  // namespace flatray
