// Loaded before a program (LD_PRELOAD), makes one call of one call stack fail, as a machine does that has no more
// memory, disk or threads.
//
//   FAULT_LIST=FILE  writes a line "KIND STACK" for each call stack from which the program allocates, writes, flushes,
//                    renames, opens for writing, makes a folder or starts a thread; nothing fails
//   FAULT_AT=STACK   the first call from this stack fails; FAULT_DONE=FILE is made when it did, and FAULT_SHOW=1 prints
//                    the stack on standard error (addresses, for addr2line)
//
// A stack is a hash of its return addresses, each counted from where its library lies, so that it is the same in every
// run of one program.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(size_t bytes);
void* __libc_calloc(size_t count, size_t bytes);
void* __libc_realloc(void* old, size_t bytes);
void* __libc_memalign(size_t alignment, size_t bytes);
}

namespace {

constexpr int kDeepest = 64;

std::uint64_t wanted = 0;
int list = -1;
std::atomic<bool> failed{false};
std::atomic<bool> ready{false};
thread_local bool inside = false;  // backtrace() and the lists below allocate

using StartThread = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
StartThread start_thread = nullptr;

// Stacks seen, open addressing; more are not listed.
std::array<std::atomic<std::uint64_t>, 1 << 17> seen{};

bool is_new(std::uint64_t stack) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    std::uint64_t there = 0;
    auto& place = seen[(stack + i) % seen.size()];
    if (place.compare_exchange_strong(there, stack)) return true;
    if (there == stack) return false;
  }
  return false;
}

__attribute__((noinline)) std::uint64_t stack_now(const char* kind) {
  std::array<void*, kDeepest> frames;
  const int count = ::backtrace(frames.data(), kDeepest);
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&hash](std::uint64_t part) {
    hash = (hash ^ part) * 1099511628211U;
    hash ^= hash >> 29;
  };
  for (const char* c = kind; *c != '\0'; ++c) add(static_cast<std::uint64_t>(*c));
  for (int i = 2; i < count; ++i) {  // without this function and fails()
    dl_find_object object{};
    void* frame = frames[static_cast<std::size_t>(i)];
    if (::_dl_find_object(frame, &object) == 0)
      add(static_cast<std::uint64_t>(static_cast<char*>(frame) -
                                     static_cast<char*>(object.dlfo_map_start)));
  }
  return std::max<std::uint64_t>(hash, 1);
}

void show_stack() {
  std::array<void*, kDeepest> frames;
  ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), kDeepest), STDERR_FILENO);
}

// Whether the call now made is to fail.
__attribute__((noinline)) bool fails(const char* kind) {
  if (!ready || inside || (list < 0 && failed)) return false;
  inside = true;
  const int error = errno;
  const std::uint64_t stack = stack_now(kind);
  bool fail = false;
  if (list >= 0) {
    if (is_new(stack)) ::dprintf(list, "%s %016lx\n", kind, stack);
  } else if (stack == wanted && !failed.exchange(true)) {
    fail = true;
    if (::getenv("FAULT_SHOW") != nullptr) show_stack();
    if (const char* done = ::getenv("FAULT_DONE"))
      ::syscall(SYS_close, ::syscall(SYS_openat, AT_FDCWD, done, O_CREAT | O_WRONLY, 0666));
  }
  errno = error;
  inside = false;
  return fail;
}

template <class Result>
Result failure(int error, Result result) {
  errno = error;
  return result;
}

__attribute__((constructor)) void begin() {
  inside = true;
  std::array<void*, 4> frames;
  ::backtrace(frames.data(), 4);  // loads what it needs
  start_thread = reinterpret_cast<StartThread>(::dlsym(RTLD_NEXT, "pthread_create"));
  if (const char* at = ::getenv("FAULT_AT")) wanted = std::strtoull(at, nullptr, 16);
  if (const char* file = ::getenv("FAULT_LIST"))
    list = static_cast<int>(
        ::syscall(SYS_openat, AT_FDCWD, file, O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0666));
  inside = false;
  ready = list >= 0 || wanted != 0;
}

}  // namespace

extern "C" {

void* malloc(size_t bytes) noexcept {
  return fails("alloc") ? failure<void*>(ENOMEM, nullptr) : __libc_malloc(bytes);
}
void* calloc(size_t count, size_t bytes) noexcept {
  return fails("alloc") ? failure<void*>(ENOMEM, nullptr) : __libc_calloc(count, bytes);
}
void* realloc(void* old, size_t bytes) noexcept {
  return fails("alloc") ? failure<void*>(ENOMEM, nullptr) : __libc_realloc(old, bytes);
}
void* aligned_alloc(size_t alignment, size_t bytes) noexcept {
  return fails("alloc") ? failure<void*>(ENOMEM, nullptr) : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** out, size_t alignment, size_t bytes) noexcept {
  if (fails("alloc")) return ENOMEM;
  *out = __libc_memalign(alignment, bytes);
  return *out == nullptr ? ENOMEM : 0;
}
ssize_t write(int file, const void* bytes, size_t count) {
  return fails("write") ? failure<ssize_t>(ENOSPC, -1) : ::syscall(SYS_write, file, bytes, count);
}
int fsync(int file) {
  return fails("fsync") ? failure(EIO, -1) : static_cast<int>(::syscall(SYS_fsync, file));
}
int rename(const char* from, const char* to) noexcept {
  if (fails("rename")) return failure(EIO, -1);
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int mkdir(const char* path, mode_t mode) noexcept {
  if (fails("mkdir")) return failure(ENOSPC, -1);
  return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}
int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if ((flags & (O_WRONLY | O_RDWR)) != 0 && fails("open")) return failure(ENOSPC, -1);
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* argument) noexcept {
  if (start_thread == nullptr || fails("thread")) return EAGAIN;
  return start_thread(thread, attributes, run, argument);
}

}  // extern "C"
