#include "base/file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <new>

#include "base/counted.h"
#include "base/in_flight.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartEnd = ".part";
constexpr std::size_t kPartDigits = 16;

// Of a regular file, and only a hint: it may grow, and pipes have none.
std::size_t size_now(const Descriptor& file) {
  struct stat status {};
  const bool known = ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
  return known && status.st_size > 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

// Not for secrets: names that two writers, of whatever machines and containers, do not have in common.
std::uint64_t random_number() {
  auto number = static_cast<std::uint64_t>(
      std::chrono::steady_clock::now().time_since_epoch().count() ^ ::getpid());
  (void)!::getrandom(&number, sizeof(number), GRND_NONBLOCK);
  return number;
}

// Of a folder the read says what it is.
bool is_pipe_or_device(const Descriptor& file) {
  struct stat status {};
  return ::fstat(file.get(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

// Whether a name is one of `part_name`'s.
bool is_part_name(std::string_view name) {
  const std::size_t end = name.size() - std::min(name.size(), kPartEnd.size());
  if (!name.starts_with('.') || name.substr(end) != kPartEnd || end < kPartDigits + 2) return false;
  const std::string_view digits = name.substr(end - kPartDigits, kPartDigits);
  return name[end - kPartDigits - 1] == '.' &&
         digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Result<std::string> read_to_end(const Descriptor& file, const fs::path& path,
                                const ReadLimits& limits) {
  const auto too_large = [&] {
    return fail(named_place(path.string()), "is larger than " + counted(limits.bytes, "byte"),
                limits.raise, Trouble::missing);
  };
  const std::size_t size = size_now(file);
  if (size > limits.bytes) return too_large();
  std::string content;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return cannot("read", path, errno, Trouble::missing);
    if (count == 0) return content;
    if (content.size() + static_cast<std::size_t>(count) > limits.bytes) return too_large();
    content.append(buffer.data(), static_cast<std::size_t>(count));
    const std::string_view whole = content;
    const auto may_begin = [&](std::string_view begins) {
      return whole.substr(0, begins.size()) == begins.substr(0, whole.size());
    };
    if (!limits.begins.empty() && std::ranges::none_of(limits.begins, may_begin)) return content;
    content.reserve(size);
  }
}

// `take(path)` of what nobody holds locked, which is held while it is looked at.
template <class Take>
void each_leftover(const fs::path& folder, const Take& take) {
  for (const fs::path& path : files_in(folder)) {
    if (!is_part_name(path.filename().string())) continue;
    const auto file = open_regular(path, O_RDONLY, "read", Trouble::missing);
    if (file && ::flock(file->get(), LOCK_EX | LOCK_NB) == 0 && is_at(path, *file)) take(path);
  }
}

}  // namespace

Descriptor::~Descriptor() {
  if (fd_ > STDERR_FILENO) ::close(fd_);
}

tl::unexpected<Diagnostics> cannot(const char* what, const fs::path& path, int error,
                                   Trouble trouble) {
  return fail(named_place(path.string()), fmt::format("cannot {}: {}", what, std::strerror(error)),
              "", trouble);
}

Result<Descriptor> open_regular(const fs::path& path, int flags, const char* what,
                                Trouble trouble) {
  Descriptor file(::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666));
  if (!file && errno == ELOOP)
    return fail(named_place(path.string()), "is a link, which is not followed here", "remove it",
                trouble);
  struct stat status {};
  const bool irregular = file ? ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)
                              : errno == ENXIO;  // a pipe that nobody reads
  if (irregular)
    return fail(named_place(path.string()), "is not a plain file", "remove it", trouble);
  if (!file) return cannot(what, path, errno, trouble);
  return file;
}

bool is_at(const fs::path& path, const Descriptor& file) {
  struct stat there {
  }, open{};
  return ::lstat(path.c_str(), &there) == 0 && ::fstat(file.get(), &open) == 0 &&
         there.st_dev == open.st_dev && there.st_ino == open.st_ino;
}

bool has_other_names(const Descriptor& file) {
  struct stat status {};
  return ::fstat(file.get(), &status) == 0 && status.st_nlink > 1;
}

Result<std::string> read_all(const Descriptor& file, const fs::path& path) {
  ::lseek(file.get(), 0, SEEK_SET);
  return read_to_end(file, path, {});
}

bool write_all(const Descriptor& file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

Result<std::string> read_file(const fs::path& path, const ReadLimits& limits) {
  const bool any_kind = limits.pipes || path == "-";
  const int wait = any_kind ? 0 : O_NONBLOCK;  // a pipe opens when somebody writes
  const Descriptor file(path == "-" ? STDIN_FILENO
                                    : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | wait));
  if (!file) return cannot("read", path, errno, Trouble::missing);
  if (!any_kind && is_pipe_or_device(file))
    return fail(named_place(path.string()), "is not a plain file", "", Trouble::missing);
  return read_to_end(file, path, limits);
}

Result<std::string> read_regular_file(const fs::path& path) {
  FLATRAY_TRY(file, open_regular(path, O_RDONLY, "read", Trouble::missing));
  return read_all(*file, path);
}

std::string part_name(const fs::path& path, std::uint64_t number) {
  return fmt::format(".{}.{:0{}x}{}", path.filename().string(), number, kPartDigits, kPartEnd);
}

NewFile::NewFile(const fs::path& path)
    : path_(path),
      temporary_(folder_of(path) / part_name(path, random_number())),
      file_(-1),
      in_flight_(std::make_unique<const InFlight>(temporary_)) {}

NewFile::NewFile(NewFile&&) noexcept = default;

NewFile::~NewFile() {
  if (file_ && !temporary_.empty()) ::unlink(temporary_.c_str());
}

Result<NewFile> NewFile::begin(const fs::path& path) {
  const fs::path folder = folder_of(path);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannot("make the folder", folder, error.value(), Trouble::output);
  for (;;) {
    NewFile made(path);  // all it needs memory for, so that what is made is removed whatever ends
    made.file_ = Descriptor(::open(made.temporary_.c_str(),
                                   O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!made.file_ && errno == EEXIST) continue;
    if (!made.file_) return cannot("write", path, errno, Trouble::output);
    // The lock tells that it lives. Who clears a folder may have come between; then another name.
    ::flock(made.file_.get(), LOCK_EX);
    if (!is_at(made.temporary_, made.file_)) {
      made.temporary_.clear();
      continue;
    }
    return made;
  }
}

Result<void> NewFile::add(std::span<const std::byte> bytes) const {
  if (!write_all(file_, bytes)) return cannot("write", path_, errno, Trouble::output);
  return {};
}

Result<void> NewFile::flush() const {
  if (::fsync(file_.get()) != 0) return cannot("write", path_, errno, Trouble::output);
  return {};
}

Result<NewFile> NewFile::write(const fs::path& path, std::span<const std::byte> bytes) {
  auto made = begin(path);
  if (!made) return made;
  if (auto added = made->add(bytes); !added) return fail(std::move(added));
  if (auto kept = made->flush(); !kept) return fail(std::move(kept));
  return made;
}

Result<void> NewFile::take_name() {
  if (::rename(temporary_.c_str(), path_.c_str()) != 0)
    return cannot("write", path_, errno, Trouble::output);
  temporary_.clear();
  in_flight_.reset();
  return {};
}

Result<void> write_file(const fs::path& path, std::span<const std::byte> bytes) {
  FLATRAY_TRY(made, NewFile::write(path, bytes));
  if (auto named = made->take_name(); !named) return named;
  flush_folder(folder_of(path));
  return {};
}

Result<void> flush_file(const fs::path& path) {
  FLATRAY_TRY(file, open_regular(path, O_WRONLY, "write", Trouble::output));
  if (::fsync(file->get()) != 0) return cannot("write", path, errno, Trouble::output);
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

Result<void> expect_writable(const fs::path& path) {
  const fs::path folder = folder_of(path);
  for (fs::path there = folder;; there = folder_of(there)) {
    if (::access((there / "").c_str(), W_OK | X_OK) == 0) return {};
    int why = errno;
    std::error_code ignored;  // a link that leads nowhere is there, as making the folder says
    if (why == ENOENT && fs::is_symlink(there, ignored)) why = EEXIST;
    if (why == ENOENT && there != folder_of(there)) continue;
    if (why == EEXIST || why == ENOTDIR || there != folder)
      return cannot("make the folder", folder, why, Trouble::output);
    return cannot("write", path, why, Trouble::output);
  }
}

std::vector<fs::path> leftovers(const fs::path& folder) {
  std::vector<fs::path> found;
  each_leftover(folder, [&](const fs::path& path) { found.push_back(path); });
  return found;
}

void remove_leftovers(const fs::path& folder) {
  each_leftover(folder, [](const fs::path& path) { ::unlink(path.c_str()); });
}

namespace {

// What has no memory is not what is not there.
std::error_code add_files(const fs::path& folder, std::vector<fs::path>& files) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    files.push_back(entry->path());
  if (error == std::errc::not_enough_memory) throw std::bad_alloc();
  return error;
}

}  // namespace

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  add_files(folder, files);
  std::ranges::sort(files);
  return files;
}

Result<std::vector<fs::path>> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  std::error_code error = add_files(folder, files);
  if (error) return cannot("read", folder, error.value(), Trouble::missing);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!fs::is_directory(fs::symlink_status(files[i]))) continue;
    const fs::path below = files[i];
    error = add_files(below, files);
    if (error) return cannot("read", below, error.value(), Trouble::missing);
  }
  std::ranges::sort(files);
  return files;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace flatray
