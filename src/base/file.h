#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "base/result.h"

namespace flatray {

/// Whole content of a file, or of standard input for "-".
/// Error   Trouble::missing, naming the path and the system's reason; also above `limit` bytes,
///         with `raise` as the hint.
Result<std::string> read_file(const std::filesystem::path& path,
                              std::size_t limit = std::size_t{1} << 32, std::string raise = {});

/// Writes `bytes` so that `path` holds either what it held before or all of them, whenever the
/// program or the machine stops: temporary name beside it, flush, rename, flush of the folder.
/// Makes missing folders. With Flush::later the machine may stop before the new name is kept, but
/// never with less than all bytes under it. Error   Trouble::output with the system's reason; the
/// temporary file is gone.
enum class Flush { now, later };
Result<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes,
                        Flush name = Flush::now);
Result<void> write_file(const std::filesystem::path& path, const std::string& text);

/// Removes from a folder what `write_file` left there when its process was killed: temporary files
/// whose process is gone and that nobody holds locked. What cannot be removed stays.
void remove_leftovers(const std::filesystem::path& folder);

/// The folder a file stands in, "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// The lines of a file that append_line has made longer. A last line without its end, as a killed
/// run or a full disk leaves it, is taken away from the file, too.
Result<std::string> read_whole_lines(const std::filesystem::path& path);

/// Adds one line to a file and flushes it, unless that is to be done later: one write, so that lines
/// of two writers do not mix.
Result<void> append_line(const std::filesystem::path& path, const std::string& line,
                         Flush flush = Flush::now);

/// What was left for later: of a file its bytes, of a folder the names in it.
/// Error   Trouble::output with the system's reason.
Result<void> flush_file(const std::filesystem::path& path);
void flush_folder(const std::filesystem::path& path);

}  // namespace flatray
