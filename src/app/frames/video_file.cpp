#include "app/frames/video_file.h"

#include <fmt/core.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/interrupt.h"

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

}  // namespace

Result<VideoFile> VideoFile::begin(const PictureFormat& format, const std::filesystem::path& path) {
  survive_closed_pipes();
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

Result<void> VideoFile::add(std::span<const std::byte> bytes) {
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
  return fail(named_place("standard output"), fmt::format("cannot write: {}", std::strerror(error)),
              error == EPIPE ? "the program that reads it has ended" : "", Trouble::output);
}

Result<void> VideoFile::finish() {
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

}  // namespace flatray
