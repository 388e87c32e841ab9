#include "measurement.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>

#include "mariotte/core/error.hpp"

namespace mariotte::scaling_study {
namespace {

/// Bytes in memory now.
double resident() {
  std::ifstream statistics("/proc/self/statm");
  double size = 0, pages = 0;
  statistics >> size >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// The most there ever were.
double most_resident() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<double>(usage.ru_maxrss);
}

/// In the child. Its answer is shorter than a pipe holds, so it is written whole.
[[noreturn]] void answer(int pipe, const std::function<Measurement()>& run) {
  int code = 1;
  try {
    const double before = resident();
    auto result = run();
    result.bytes = most_resident() - before;
    code = ::write(pipe, &result, sizeof result) == sizeof result ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
  }
  ::_exit(code);
}

}  // namespace

Measurement measured(const std::function<Measurement()>& run) {
  int ends[2];
  if (::pipe(ends) != 0) throw Error("no pipe to a process of its own");
  const pid_t child = ::fork();
  if (child == 0) answer(ends[1], run);
  ::close(ends[1]);
  Measurement result;
  const bool whole = child > 0 && ::read(ends[0], &result, sizeof result) == sizeof result;
  ::close(ends[0]);
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!whole) throw Error("a measurement died");
  return result;
}

}  // namespace mariotte::scaling_study
