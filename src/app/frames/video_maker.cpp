#include "app/frames/video_maker.h"

#include <fmt/core.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>

#include "app/interrupt.h"
#include "base/child_program.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/parallel.h"

namespace flatray {
namespace {

// Of a program that does not make the file, at the file.
tl::unexpected<Diagnostics> at_file(const std::filesystem::path& path, Diagnostics problems) {
  for (Diagnostic& one : problems) {
    one.message = fmt::format("{} {}", one.where.source->name(), one.message);
    one.where = named_place(path.string());
  }
  return tl::unexpected(std::move(problems));
}

// Y4M on its standard input; what it writes tells the colours, and not the time.
std::vector<std::string> words_for(const PictureFormat& format) {
  static constexpr const char* kColours[] = {"-colorspace",  "bt709",      "-color_primaries",
                                             "bt709",        "-color_trc", "iec61966-2-1",
                                             "-color_range", "tv"};
  std::vector<std::string> words{"ffmpeg", "-nostdin", "-hide_banner", "-loglevel",
                                 "error",  "-y",       "-f",           "yuv4mpegpipe"};
  static constexpr const char* kInput[] = {"-i", "-",       "-map_metadata",
                                           "-1", "-fflags", "+bitexact"};
  using Words = std::span<const char* const>;
  for (const Words more : {Words(kColours), Words(kInput), Words(kColours), format.by_ffmpeg})
    words.insert(words.end(), more.begin(), more.end());
  return words;
}

// A file of all frames of a sequence while it is written: a plain file, standard output, or what a
// program makes of the parts. A file has its name once it is whole; where it never is, nothing is
// left. What ends the other side of a pipe ends the write, not flatray.
class VideoFile {
 public:
  // `path` is "-" for standard output.
  // Error   Trouble::output; Trouble::unavailable where the format's program is not on this
  //         machine, with what to install.
  static Result<VideoFile> begin(const PictureFormat& format, const std::filesystem::path& path) {
    ::signal(SIGPIPE, SIG_IGN);  // who reads no more is told as an error of the write
    ::signal(SIGCHLD, SIG_DFL);  // where it is ignored, nobody is told how a program ended
    VideoFile video(path);
    if (path == "-") return video;
    FLATRAY_TRY(file, NewFile::begin(path));
    video.file_.emplace(std::move(*file));
    if (format.by_ffmpeg.empty()) return video;
    auto program = ChildProgram::start(words_for(format), video.file_->descriptor(),
                                       "apt install ffmpeg; without it, say -o video.y4m");
    if (!program) return at_file(path, std::move(program).error());
    video.program_.emplace(std::move(*program));
    return video;
  }

  // The bytes of the next part. Error   Trouble::output, with what the program said.
  Result<void> add(std::span<const std::byte> bytes) {
    if (program_) {
      if (program_->feed(bytes)) return {};
      auto ended = program_->finish(&interrupted);
      if (!ended) return at_file(path_, std::move(ended).error());
      return fail(named_place(path_.string()), "the program that makes it has read but a part", "",
                  Trouble::output);
    }
    if (file_) return file_->add(bytes);
    if (write_all(Descriptor(STDOUT_FILENO), bytes)) return {};
    const int error = errno;
    return fail(named_place("standard output"),
                fmt::format("cannot write: {}", std::strerror(error)),
                error == EPIPE ? "the program that reads it has ended" : "", Trouble::output);
  }

  // Whether it is a file, which is there whole or not at all, and not standard output.
  bool is_file() const { return file_.has_value(); }

  // Gives it its name.
  Result<void> finish() {
    if (program_) {
      if (auto ended = program_->finish(&interrupted); !ended)
        return at_file(path_, std::move(ended).error());
      // It ends with 0 on a full disk, too. What it says are errors, or nothing.
      const std::string words = program_->last_words();
      if (!words.empty() || ::lseek(file_->descriptor().get(), 0, SEEK_END) <= 0)
        return fail(named_place(path_.string()), "ffmpeg ended before it was whole",
                    words.empty() ? "it wrote nothing" : "it said: " + words, Trouble::output);
    }
    if (!file_) return {};
    if (auto kept = file_->flush(); !kept) return kept;
    if (auto named = file_->take_name(); !named) return named;
    flush_folder(folder_of(path_));
    return {};
  }

 private:
  explicit VideoFile(const std::filesystem::path& path) : path_(path) {}

  std::filesystem::path path_;
  std::optional<NewFile> file_;          // none: standard output
  std::optional<ChildProgram> program_;  // that writes the file
};

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
      const std::vector<std::byte> part =
          job_.output.format().part(waiting_.front().bytes, index, sequence_);
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
  const FrameSequence sequence_{job_.picture().width, job_.picture().height, frames_.size(),
                                job_.scene.fps};
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
