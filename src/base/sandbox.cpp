// The system calls of Landlock, which the C library does not have; numbers and bits are those of
// linux/landlock.h, of which older systems know the first few.
#include "base/sandbox.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace flatray {
namespace {

constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1;
constexpr int kPathBeneath = 1;

// Rights to files and folders, by bit: execute, write, read a file, read a folder, remove a folder,
// remove a file; make a device, folder, file, socket, pipe, block device, link; then those of later
// versions: refer (2), truncate (3), ioctl of devices (5).
constexpr std::uint64_t kReadFile = 1 << 2, kReadFolder = 1 << 3, kExecute = 1 << 0;
constexpr std::uint64_t kRead = kReadFile | kReadFolder | kExecute;  // modules are executed
constexpr std::uint64_t kWriteFile = 1 << 1, kTruncate = 1 << 14;
constexpr std::uint64_t kMake = 1 << 5 | 1 << 7 | 1 << 8;  // and remove files: temporary ones
constexpr std::uint64_t kOfFiles = kReadFile | kWriteFile | kTruncate | kExecute;

std::uint64_t known_rights(long version) {
  return (1U << (version >= 5 ? 16 : version >= 3 ? 15 : version >= 2 ? 14 : 13)) - 1U;
}

struct Ruleset {
  std::uint64_t files, network, scope;
};
// As the kernel has it: 12 bytes.
struct [[gnu::packed]] PathRule {
  std::uint64_t rights;
  std::int32_t folder;
};

tl::unexpected<Diagnostics> unavailable(const char* what) {
  return fail(named_place("--sandbox"), fmt::format("{}: {}", what, std::strerror(errno)),
              "it needs Landlock, in Linux from 5.13 on; leave --sandbox out",
              Trouble::unavailable);
}

bool allow(int ruleset, const std::filesystem::path& path, std::uint64_t rights) {
  const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0) return true;
  struct stat status {};
  const bool folder = ::fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
  const PathRule rule{folder ? rights : rights & kOfFiles, file};
  const bool added = ::syscall(kAddRule, ruleset, kPathBeneath, &rule, 0U) == 0;
  ::close(file);
  return added;
}

}  // namespace

Result<void> enter_sandbox(const Sandbox& sandbox) {
  const long version = ::syscall(kCreateRuleset, nullptr, std::size_t{0}, kAskVersion);
  if (version < 1) return unavailable("this system has no sandbox");
  const std::uint64_t known = known_rights(version);
  const Ruleset all{known, version >= 4 ? 3U : 0U, version >= 6 ? 3U : 0U};
  const std::size_t size = version >= 6 ? sizeof all : version >= 4 ? 16 : 8;
  const long created = ::syscall(kCreateRuleset, &all, size, 0U);
  if (created < 0) return unavailable("no sandbox can be made");
  const int ruleset = static_cast<int>(created);
  bool allowed = true;
  for (const auto& path : sandbox.read) allowed = allowed && allow(ruleset, path, kRead & known);
  for (const auto& path : sandbox.write)
    allowed = allowed && allow(ruleset, path,
                               (kReadFile | kReadFolder | kWriteFile | kTruncate | kMake) & known);
  const bool entered = allowed && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                       ::syscall(kRestrictSelf, ruleset, 0U) == 0;
  if (!entered) return unavailable("the sandbox cannot be entered");
  ::close(ruleset);
  return {};
}

}  // namespace flatray
