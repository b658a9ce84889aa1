#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <tuple>

#include "app/interrupt.h"
#include "app/options/resource_limits.h"
#include "app/verb.h"
#include "base/in_flight.h"
#include "geom/exact.h"

namespace {

// Says what stopped the program. Gives   the exit code.
int report(const std::exception_ptr& error) {
  try {
    if (error) std::rethrow_exception(error);
    std::fputs("flatray: internal error\n", stderr);
  } catch (const std::bad_alloc&) {
    std::fputs(
        "flatray: out of memory; fewer threads (-j), a smaller --size and a smaller scene need "
        "less, "
        "and lower limits refuse what does not fit: flatray help limits\n",
        stderr);
    return flatray::out_of_memory_code();
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "flatray: internal error: %s\n", problem.what());
  }
  constexpr int kInternalError = 70;
  return kInternalError;
}

// Where an exception may not pass, as out of what moves a value.
[[noreturn]] void end_at_once() {
  const int code = report(std::current_exception());
  flatray::remove_in_flight();
  std::_Exit(code);
}

// Before any object outside of functions is made, which may lack memory, too.
[[gnu::constructor(101)]] void prepare() { std::set_terminate(&end_at_once); }

// A file that is opened must not get the number of standard output or error where these are closed:
// messages would be written into it. What stands there instead fails to be read or written as
// before.
void hold_closed_files() {
  for (int file = 0; file <= 2; ++file)
    if (::fcntl(file, F_GETFD) < 0)
      std::ignore = ::open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    hold_closed_files();
    flatray::survive_file_limits();
    flatray::throw_where_numbers_lack_memory();
    return flatray::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (...) {
    return report(std::current_exception());
  }
}
