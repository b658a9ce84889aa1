#include "app/files/journal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "base/hash.h"
#include "base/json.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kPause{1};
constexpr int kMostPauses = 30'000;  // of one lock: no process holds one for so long

// The part up to the end of the last whole line.
void drop_torn_line(std::string& text) { text.resize(text.rfind('\n') + 1); }

// Opens the file, made where it is missing, with a lock that `lock(file)` gets or does not; of what
// has that name once the lock is there.
template <class Lock>
Result<Descriptor> open_locked(const fs::path& path, int flags, const Lock& lock) {
  std::error_code error;
  fs::create_directories(folder_of(path), error);
  if (error) return cannot("make the folder", folder_of(path), error.value(), Trouble::output);
  for (int pauses = 0; pauses < kMostPauses;) {
    FLATRAY_TRY(file, open_regular(path, flags | O_RDWR | O_CREAT, "write", Trouble::output));
    if (lock(*file)) {
      if (is_at(path, *file)) return file;
    } else if (errno == EWOULDBLOCK || errno == EINTR) {
      ++pauses;
      std::this_thread::sleep_for(kPause);
    } else {
      return cannot("lock and write", path, errno, Trouble::output);
    }
  }
  return fail(named_place(path.string()), "has been locked by another process for long",
              "end that process", Trouble::output);
}

bool try_lock(const Descriptor& file, int kind) { return ::flock(file.get(), kind | LOCK_NB) == 0; }

}  // namespace

Result<std::string> Journal::read() const {
  std::error_code ignored;
  if (fs::symlink_status(path_, ignored).type() == fs::file_type::not_found) return std::string();
  Result<std::string> text = read_regular_file(path_);
  if (text)
    drop_torn_line(*text);
  else
    for (Diagnostic& problem : text.error()) problem.trouble = Trouble::output;
  return text;
}

Result<Descriptor> Journal::lock() const {
  for (;;) {
    auto file =
        open_locked(path_, O_APPEND, [](const Descriptor& one) { return try_lock(one, LOCK_EX); });
    if (!file || !has_other_names(*file)) return file;
    FLATRAY_TRY(text, read_all(*file, path_));
    if (auto copied = write_file(path_, *text); !copied) return fail(std::move(copied));
  }
}

Result<void> Journal::merge(const Change& change) const {
  FLATRAY_TRY(file, lock());
  FLATRAY_TRY(text, read_all(*file, path_));
  const std::size_t size = text->size();
  drop_torn_line(*text);
  FLATRAY_TRY(changed, change(*text));
  if (*changed == *text && text->size() == size) return {};
  return write_file(path_, *changed);
}

Result<void> Journal::mend() const {
  FLATRAY_TRY(text, read_regular_file(path_));
  if (text->empty() || text->back() == '\n') return {};
  return merge([](const std::string& whole) -> Result<std::string> { return whole; });
}

Result<void> Journal::add(const std::string& lines, const Step& first, Flush flush) const {
  FLATRAY_TRY(file, lock());
  if (first)
    if (auto done = first(); !done) return done;
  struct stat status {};
  char last = '\n';
  if (::fstat(file->get(), &status) != 0) return cannot("read", path_, errno, Trouble::output);
  off_t size = status.st_size;
  if (size > 0 && ::pread(file->get(), &last, 1, size - 1) == 1 && last != '\n') {
    FLATRAY_TRY(text, read_all(*file, path_));
    drop_torn_line(*text);
    size = static_cast<off_t>(text->size());
    if (::ftruncate(file->get(), size) != 0) return cannot("write", path_, errno, Trouble::output);
  }
  const std::string all = (size == 0 ? head_ : std::string()) + lines;
  const bool written = write_all(*file, std::as_bytes(std::span(all)));
  if (written && (flush == Flush::later || ::fsync(file->get()) == 0)) return {};
  const int error = errno;
  (void)!::ftruncate(file->get(), size);
  return cannot("write", path_, error, Trouble::output);
}

Result<void> Journal::remove() const {
  std::error_code error;
  fs::remove(path_, error);
  if (error) return fail(named_place(path_.string()), error.message(), "", Trouble::output);
  return {};
}

Claim::Claim(fs::path path, Descriptor file)
    : path_(std::move(path)),
      file_(std::move(file)),
      in_flight_(std::make_unique<const InFlight>(path_, file_.get())) {}

Claim::~Claim() {
  if (file_ && try_lock(file_, LOCK_EX) && is_at(path_, file_)) ::unlink(path_.c_str());
}

Result<Claim> Claim::take(const fs::path& folder, const std::string& what,
                          const std::string& setting, bool force) {
  // A name that remove_leftovers knows: what a killed run leaves of it goes with the rest.
  const fs::path path = folder / part_name(what, 0);
  for (;;) {
    bool planted = false;
    auto file = open_locked(path, 0, [&](const Descriptor& one) {
      if (try_lock(one, LOCK_EX)) {  // nobody is at work
        planted = has_other_names(one);
        if (!planted && (::ftruncate(one.get(), 0) != 0 ||
                         !write_all(one, std::as_bytes(std::span(setting))))) {
          const int error = errno;
          ::unlink(path.c_str());
          errno = error;
          return false;
        }
      }
      return try_lock(one, LOCK_SH);
    });
    if (!file) {
      std::error_code ignored;  // of a hidden file that cannot be made, what it is for is told
      const bool is_there = fs::exists(fs::symlink_status(path, ignored));
      Place& where = file.error().front().where;
      if (!is_there && where.source->name() == path.string())
        where = named_place((folder / what).string());
      return fail(std::move(file));
    }
    if (!planted) {
      FLATRAY_TRY(theirs, read_all(*file, path));
      if (*theirs == setting) return Claim(path, std::move(*file));
      if (!force)
        return fail(named_place((folder / what).string()),
                    "another run is at work on it: " + differences(*theirs, setting),
                    "wait for it, or name another folder; --force ends the other", Trouble::output);
    }
    ::unlink(path.c_str());
  }
}

Result<void> Claim::expect_held() const {
  if (is_at(path_, file_)) return {};
  return fail(named_place(path_.parent_path().string()), "another run goes on here, by --force",
              "name another folder", Trouble::output);
}

std::string checked(const std::string& line) { return line + ",#" + Hash().add(line).hex(); }

std::optional<std::string_view> unchecked(std::string_view line) {
  const std::size_t end = line.rfind(",#");
  if (end == std::string_view::npos) return line;
  const std::string_view text = line.substr(0, end);
  return Hash().add(text).hex() == line.substr(end + 2) ? std::optional(text) : std::nullopt;
}

std::string differences(const std::string& there, const std::string& here) {
  const auto theirs = parse_json(there), ours = parse_json(here);
  const auto fields_of = [](const auto& value) {
    return value ? std::get_if<Fields>(&value->data) : nullptr;
  };
  const Fields *before = fields_of(theirs), *now = fields_of(ours);
  if (before == nullptr || now == nullptr) return "of another version";
  std::string text;
  const auto note = [&](const std::string& name) {
    const JsonValue *was = theirs->find(name), *is = ours->find(name);
    const auto shown = [](const JsonValue* value) { return value ? json_text(*value) : "none"; };
    if (shown(was) != shown(is))
      text += fmt::format("{}its {} is {}, not {}", text.empty() ? "" : "; ", name, shown(was),
                          shown(is));
  };
  for (const auto& field : *now) note(field.first);
  for (const auto& field : *before)
    if (ours->find(field.first) == nullptr) note(field.first);
  return text;
}

}  // namespace flatray
