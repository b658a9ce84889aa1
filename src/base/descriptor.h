#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "base/result.h"

namespace flatray {

/// A file descriptor that closes itself, and lets go of its locks.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor();
  explicit operator bool() const { return fd_ >= 0; }
  int get() const { return fd_; }

 private:
  int fd_;
};

/// Opens a regular file with `flags` of open(2). A link is not followed, a pipe is not waited for.
/// Error   `trouble`, that one cannot `what` ("read", "write"), or what stands there instead.
Result<Descriptor> open_regular(const std::filesystem::path& path, int flags, const char* what,
                                Trouble trouble);

/// Whether it is this file that `path` names.
bool is_at(const std::filesystem::path& path, const Descriptor& file);

/// Whether the file has hard links, so that a change of it would show under other names.
bool has_other_names(const Descriptor& file);

/// From its beginning to its end. Error   Trouble::missing.
Result<std::string> read_all(const Descriptor& file, const std::filesystem::path& path);

/// All bytes, or false with errno.
bool write_all(const Descriptor& file, std::span<const std::byte> bytes);

/// "cannot WHAT: " and the reason of errno's `error`.
tl::unexpected<Diagnostics> cannot(const char* what, const std::filesystem::path& path, int error,
                                   Trouble trouble);

}  // namespace flatray
