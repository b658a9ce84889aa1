#pragma once
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/file.h"
#include "base/in_flight.h"

namespace flatray {

/// Lines of finished work in one file, which runs of several processes make longer at once: frames
/// of a sequence, blocks of an experiment, chunks of `stability`. A line is added whole, and none
/// is lost: every change is made under a lock, at the end or by replacing the file. Hard links of
/// it, as a copy of the folder may have, keep what they hold.
class Journal {
 public:
  /// `head` is the first line of a file that is begun, "" for none.
  explicit Journal(std::filesystem::path path, std::string head = {})
      : path_(std::move(path)), head_(std::move(head)) {}

  const std::filesystem::path& path() const { return path_; }

  /// The whole lines, "" where there is no file: what a full disk left of a line is not told.
  /// Writes nothing. Error   Trouble::output for what cannot be read, or is no regular file.
  Result<std::string> read() const;

  /// Replaces the lines by what `change` makes of them, while nobody else adds any.
  using Change = std::function<Result<std::string>(const std::string& text)>;
  Result<void> merge(const Change& change) const;

  /// Takes away what a full disk or a kill left of a line; nothing is written where there is none.
  Result<void> mend() const;

  /// Adds lines, `first` having been done under the same lock. With Flush::later the machine may
  /// stop before they are kept.
  using Step = std::function<Result<void>()>;
  enum class Flush : std::uint8_t { now, later };
  Result<void> add(const std::string& lines, const Step& first = {},
                   Flush flush = Flush::now) const;

  /// Removes the file, if there. Error   Trouble::output with the system's reason.
  Result<void> remove() const;

 private:
  Result<Descriptor> lock() const;

  std::filesystem::path path_;
  std::string head_;
};

/// A line with the hash of it as one more cell, ",#89abcdef01234567": one that is changed is told.
std::string checked(const std::string& line);
/// The line before that cell, or all of one that has none, as those of before; nullopt where the
/// hash is another.
std::optional<std::string_view> unchecked(std::string_view line);

/// `take(line)` of each line of a text.
template <class Take>
void each_line(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// That a run is at work on one thing in a folder, until it ends: who comes to do the same in
/// another way is told so. Runs that do it in the same way share it.
class Claim {
 public:
  /// `setting` is an object of JSON: all that the bytes depend on. With `force` the others lose it.
  /// Error   Trouble::output, with what differs.
  static Result<Claim> take(const std::filesystem::path& folder, const std::string& what,
                            const std::string& setting, bool force);
  Claim(Claim&&) = default;
  Claim& operator=(Claim&&) = delete;
  ~Claim();
  /// Error   Trouble::output: another run has taken it by force.
  Result<void> expect_held() const;

 private:
  Claim(std::filesystem::path path, Descriptor file);
  std::filesystem::path path_;
  Descriptor file_;
  std::unique_ptr<const InFlight> in_flight_;
};

/// Fields of an object of JSON, `there`, that are not those of another: "its seed is 1, not 2".
std::string differences(const std::string& there, const std::string& here);

}  // namespace flatray
