#include "app/query/line_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "app/files/journal.h"

namespace flatray {

Result<LineStream> LineStream::open(const std::string& path) {
  const bool is_input = path == "-";  // which stays open when the stream closes its own
  const std::string name = is_input ? "standard input" : path;
  Descriptor file(is_input ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                           : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return cannot("read", name, errno, Trouble::missing);
  return LineStream(std::move(file), name);
}

// Reads once, and tells the end.
Result<void> LineStream::fill() {
  constexpr std::size_t kBlock = std::size_t{1} << 18;
  const std::size_t before = room_.size();
  room_.resize(before + kBlock);
  ssize_t count = -1;
  do count = ::read(file_.get(), room_.data() + before, kBlock);
  while (count < 0 && errno == EINTR);
  room_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  if (count < 0) return cannot("read", name_, errno, Trouble::missing);
  ended_ = count == 0;
  return {};
}

// To the end of a line, however long, in the room of a block.
Result<void> LineStream::skip_line() {
  std::size_t end = std::string::npos;
  while (!ended_ && end == std::string::npos) {
    room_.clear();
    FLATRAY_TRY(filled, fill());
    end = room_.find('\n');
  }
  room_.erase(0, end == std::string::npos ? end : end + 1);
  return {};
}

Result<std::vector<StreamLine>> LineStream::next() {
  room_.erase(0, used_);
  used_ = 0;
  std::size_t end = room_.rfind('\n');
  while (!ended_ && end == std::string::npos) {
    const std::size_t before = room_.size();
    FLATRAY_TRY(filled, fill());
    const std::size_t last = std::string_view(room_).substr(before).rfind('\n');
    if (last != std::string_view::npos) end = before + last;
    if (end != std::string::npos || room_.size() <= kLongest) continue;
    FLATRAY_TRY(skipped, skip_line());
    return std::vector<StreamLine>{{{}, true}};
  }
  used_ = end == std::string::npos ? room_.size() : end + 1;
  std::vector<StreamLine> lines;
  each_line({room_.data(), used_}, [&](std::string_view line) {
    lines.push_back(line.size() > kLongest ? StreamLine{{}, true} : StreamLine{line});
  });
  return lines;
}

}  // namespace flatray
