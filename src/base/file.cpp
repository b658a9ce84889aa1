#include "base/file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>

#include "base/counted.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ > STDERR_FILENO) ::close(fd_);
  }
  explicit operator bool() const { return fd_ >= 0; }
  int get() const { return fd_; }

 private:
  int fd_;
};

bool write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

tl::unexpected<Diagnostics> cannot(const char* what, const fs::path& path, int error,
                                   Trouble trouble) {
  return fail(named_place(path.string()), fmt::format("cannot {}: {}", what, std::strerror(error)),
              "", trouble);
}

// Of a regular file, and only a hint: it may grow, and pipes have none.
std::size_t size_now(const Descriptor& file) {
  struct stat status {};
  const bool known = ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
  return known && status.st_size > 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

// The process number in a name of `write_file`'s, ".NAME.1234.part".
std::optional<pid_t> writer_of(std::string_view name) {
  constexpr std::string_view kEnd = ".part";
  if (!name.starts_with('.') || !name.ends_with(kEnd)) return std::nullopt;
  name.remove_suffix(kEnd.size());
  const std::string_view digits = name.substr(name.rfind('.') + 1);
  pid_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size() || number <= 0)
    return std::nullopt;
  return number;
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::size_t limit, std::string raise) {
  const Descriptor file(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return cannot("read", path, errno, Trouble::missing);
  std::string content;
  content.reserve(std::min(size_now(file), limit));
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return cannot("read", path, errno, Trouble::missing);
    if (count == 0) return content;
    if (content.size() + static_cast<std::size_t>(count) > limit)
      return fail(named_place(path.string()), "is larger than " + counted(limit, "byte"),
                  std::move(raise), Trouble::missing);
    content.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

Result<void> write_file(const fs::path& path, std::span<const std::byte> bytes, Flush name) {
  const fs::path folder = folder_of(path);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannot("make the folder", folder, error.value(), Trouble::output);
  // The process number keeps two runs into one folder from sharing a temporary file.
  const fs::path temporary =
      folder / fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
  const auto give_up = [&](int reason) {
    ::unlink(temporary.c_str());
    return cannot("write", path, reason, Trouble::output);
  };
  {
    const Descriptor file(
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!file) return cannot("write", path, errno, Trouble::output);
    ::flock(file.get(), LOCK_EX | LOCK_NB);  // tells processes that do not see ours that it lives
    if (!write_all(file.get(), bytes) || ::fsync(file.get()) != 0) return give_up(errno);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) return give_up(errno);
  if (name == Flush::now) flush_folder(folder);
  return {};
}

Result<void> flush_file(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file || ::fsync(file.get()) != 0) return cannot("write", path, errno, Trouble::output);
  return {};
}

// Not all file systems can.
void flush_folder(const fs::path& path) {
  const Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder) ::fsync(folder.get());
}

Result<void> write_file(const fs::path& path, const std::string& text) {
  return write_file(path, std::as_bytes(std::span(text)));
}

void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
       !error && entry != end; entry.increment(error)) {
    const fs::path path = entry->path();
    const std::optional<pid_t> writer = writer_of(path.filename().string());
    if (!writer || ::kill(*writer, 0) == 0 || errno != ESRCH) continue;
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (file && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  }
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

Result<std::string> read_whole_lines(const fs::path& path) {
  Result<std::string> text = read_file(path);
  if (!text) return text;
  const std::size_t whole = text->rfind('\n') + 1;
  if (whole < text->size()) {
    std::error_code error;
    fs::resize_file(path, whole, error);
    if (error) return fail(named_place(path.string()), error.message(), "", Trouble::output);
    text->resize(whole);
  }
  return text;
}

Result<void> append_line(const fs::path& path, const std::string& line, Flush flush) {
  std::error_code error;
  fs::create_directories(folder_of(path), error);
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (!file) return cannot("write", path, errno, Trouble::output);
  const std::string whole = line + "\n";
  const bool written = write_all(file.get(), std::as_bytes(std::span(whole)));
  if (!written || (flush == Flush::now && ::fsync(file.get()) != 0))
    return cannot("write", path, errno, Trouble::output);
  return {};
}

}  // namespace flatray
