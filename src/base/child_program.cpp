#include "base/child_program.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "base/in_flight.h"

namespace flatray {
namespace {

constexpr int kOutput = 3;  // its descriptor there

// What is closed, connected and set back in the new process.
class Spawn {
 public:
  Spawn(int input, int said, int output) {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_adddup2(&files_, input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files_, said, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files_, said, STDERR_FILENO);
    ::posix_spawn_file_actions_adddup2(&files_, output, kOutput);
    ::posix_spawnattr_init(&attributes_);
    sigset_t signals;
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes_, &signals);
    ::sigaddset(&signals, SIGPIPE);
    ::sigaddset(&signals, SIGXFSZ);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  Spawn(const Spawn&) = delete;
  Spawn& operator=(const Spawn&) = delete;
  ~Spawn() {
    ::posix_spawn_file_actions_destroy(&files_);
    ::posix_spawnattr_destroy(&attributes_);
  }

  int operator()(pid_t& process, std::vector<std::string>& words) const {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return ::posix_spawnp(&process, arguments[0], &files_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

// Above those that the new process has, so that connecting one closes none of the others.
Descriptor moved_up(Descriptor file) {
  return Descriptor(::fcntl(file.get(), F_DUPFD_CLOEXEC, kOutput + 1));
}

}  // namespace

Result<ChildProgram> ChildProgram::start(std::vector<std::string> words, const Descriptor& output,
                                         const char* remedy) {
  const std::string name = words.front();
  const auto cannot_start = [&](int error) {
    return fail(named_place(name), fmt::format("cannot be started: {}", std::strerror(error)),
                error == ENOENT ? remedy : "", Trouble::unavailable);
  };
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return cannot_start(errno);
  const Descriptor read_end = moved_up(Descriptor(ends[0]));
  ChildProgram program(name, moved_up(Descriptor(ends[1])),
                       moved_up(Descriptor(::memfd_create("said", MFD_CLOEXEC))));
  const Descriptor file(::fcntl(output.get(), F_DUPFD_CLOEXEC, kOutput + 1));
  if (!read_end || !program.input_ || !program.said_ || !file) return cannot_start(errno);
  words.push_back(fmt::format("/dev/fd/{}", kOutput));
  const Spawn spawn(read_end.get(), program.said_.get(), file.get());
  if (const int error = spawn(program.process_, words); error != 0) return cannot_start(error);
  set_program_in_flight(program.process_);
  return program;
}

ChildProgram::ChildProgram(ChildProgram&& other) noexcept
    : name_(std::move(other.name_)),
      input_(std::move(other.input_)),
      said_(std::move(other.said_)),
      process_(std::exchange(other.process_, -1)) {}

ChildProgram::~ChildProgram() {
  if (process_ < 0) return;
  set_program_in_flight(-1);
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::string ChildProgram::last_words() const {
  constexpr off_t kMost = 4096;
  std::string text(kMost, '\0');
  const off_t size = ::lseek(said_.get(), 0, SEEK_END);
  const ssize_t count =
      ::pread(said_.get(), text.data(), text.size(), std::max<off_t>(size - kMost, 0));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  text.resize(text.find_last_not_of(" \n") + 1);
  return text.substr(text.rfind('\n') + 1);
}

Result<void> ChildProgram::finish(bool (*stop)()) {
  constexpr std::chrono::milliseconds kPause{5};
  input_ = Descriptor(-1);
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(process_, &status, stop == nullptr ? 0 : WNOHANG);
    if (ended == process_) break;
    if (ended < 0 && errno != EINTR) {
      set_program_in_flight(-1);
      process_ = -1;  // it is gone, and its number may be another's
      return cannot("wait for", name_, errno, Trouble::output);
    }
    if (stop == nullptr) continue;
    if (stop()) ::kill(process_, SIGKILL);
    std::this_thread::sleep_for(kPause);
  }
  set_program_in_flight(-1);
  process_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string words = last_words();
  return fail(named_place(name_),
              WIFEXITED(status) ? fmt::format("ended with exit code {}", WEXITSTATUS(status))
                                : fmt::format("was ended by signal {}", WTERMSIG(status)),
              words.empty() ? "" : "it said: " + words, Trouble::output);
}

}  // namespace flatray
