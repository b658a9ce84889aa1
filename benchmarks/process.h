#pragma once
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "measure.h"

namespace bench {

/// What a program took from start to end.
struct ProcessCost {
  bool worked = false;
  double cpu = 0, wall = 0;  ///< seconds, all threads
  double peak_mb = 0;        ///< largest resident set
};

/// Runs a program, its output thrown away, and waits for it.
inline ProcessCost run_process(const std::vector<std::string>& arguments) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const double start = seconds(CLOCK_MONOTONIC);
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  ProcessCost cost;
  cost.worked = child > 0 && wait4(child, &status, 0, &used) == child && WIFEXITED(status) &&
                WEXITSTATUS(status) == 0;
  const auto time = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  cost.cpu = time(used.ru_utime) + time(used.ru_stime);
  cost.wall = seconds(CLOCK_MONOTONIC) - start;
  cost.peak_mb = static_cast<double>(used.ru_maxrss) / 1024;
  return cost;
}

}  // namespace bench
