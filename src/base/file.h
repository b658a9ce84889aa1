#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/result.h"

namespace flatray {

class InFlight;

/// What may be read of a file.
struct ReadLimits {
  std::size_t bytes = std::size_t{1} << 30;
  std::string raise = {};  ///< the hint for a larger one
  /// Also pipes and devices, which may keep the reader for ever: of what the user names to be read.
  bool pipes = false;
  /// Where the content begins with none of these, no more of it is read.
  std::vector<std::string_view> begins = {};
};

/// Whole content of a file, or of standard input for "-".
/// Error   Trouble::missing, naming the path and the system's reason, or the limit.
Result<std::string> read_file(const std::filesystem::path& path, const ReadLimits& limits = {});

/// The same of a regular file alone, for what another program may have planted: links are not
/// followed, pipes not waited for. Error   Trouble::missing.
Result<std::string> read_regular_file(const std::filesystem::path& path);

/// A file under a hidden name beside `path`, which no other writer has, until it is whole and takes its
/// own; gone where it never does. What has the name before is replaced, and
/// neither followed nor written to, whatever it is.
class NewFile {
 public:
  /// An empty one, to be filled by `add` and `flush`ed before it takes its name. Makes missing folders.
  /// Error   Trouble::output with the system's reason, as all others.
  static Result<NewFile> begin(const std::filesystem::path& path);
  Result<void> add(std::span<const std::byte> bytes) const;
  Result<void> flush() const;
  const Descriptor& descriptor() const { return file_; }
  const std::filesystem::path& path() const { return path_; }
  /// One that is whole.
  static Result<NewFile> write(const std::filesystem::path& path, std::span<const std::byte> bytes);
  NewFile(NewFile&&) noexcept;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();
  /// The machine may stop before the name is kept, unless the folder is flushed.
  Result<void> take_name();

 private:
  /// Of no file yet, by its names.
  explicit NewFile(const std::filesystem::path& path);
  std::filesystem::path path_, temporary_;
  Descriptor file_;  ///< locked, which tells that its writer lives
  std::unique_ptr<const InFlight> in_flight_;
};

/// The hidden names: ".NAME.0123456789abcdef.part".
std::string part_name(const std::filesystem::path& path, std::uint64_t number);

/// Writes a file so that `path` holds either what it held before or all of the bytes, whenever the
/// program or the machine stops.
Result<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<void> write_file(const std::filesystem::path& path, const std::string& text);

/// Files with hidden names in a folder that nobody holds locked: their processes were killed. What
/// cannot be removed stays.
std::vector<std::filesystem::path> leftovers(const std::filesystem::path& folder);
void remove_leftovers(const std::filesystem::path& folder);

/// All that stands in a folder, sorted; none where it cannot be read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);
/// The same of all folders below it, too; links are not followed.
/// Error   Trouble::missing with the system's reason at a folder there that cannot be read.
Result<std::vector<std::filesystem::path>> files_below(const std::filesystem::path& folder);

/// Whether a file can be made or replaced at a path, as far as permissions tell. Nothing is written.
/// Error   Trouble::output with the system's reason.
Result<void> expect_writable(const std::filesystem::path& path);

/// The folder a file stands in, "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Keeps what was written: of a file its bytes, of a folder the names in it.
/// Error   Trouble::output with the system's reason.
Result<void> flush_file(const std::filesystem::path& path);
void flush_folder(const std::filesystem::path& path);

}  // namespace flatray
