#include <cstdio>
#include <exception>
#include <new>

#include "app/interrupt.h"
#include "app/verb.h"

int main(int argc, char** argv) {
  constexpr int kInternalError = 70;
  try {
    flatray::survive_file_limits();
    return flatray::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (const std::bad_alloc&) {
    std::fputs(
        "flatray: out of memory; fewer threads (-j), a smaller --size and a smaller scene need "
        "less, "
        "and lower limits refuse what does not fit: flatray help limits\n",
        stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flatray: internal error: %s\n", error.what());
  }
  return kInternalError;
}
