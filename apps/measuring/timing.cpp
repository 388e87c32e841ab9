#include "measuring/timing.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace mariotte::measuring {

double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double timed(const std::function<void()>& action) {
  const double start = cpu_seconds();
  action();
  return cpu_seconds() - start;
}

double least_seconds(const std::function<void()>& action, double first, const Patience& patience) {
  const double total = patience.batch * patience.batches;
  const int batches = first > total ? 0 : patience.batches;
  const int repeats = std::max(1, static_cast<int>(std::ceil(patience.batch / first)));
  double least = first;
  for (int batch = 0; batch < batches; ++batch) {
    const double seconds = timed([&] {
      for (int i = 0; i < repeats; ++i) action();
    });
    least = std::min(least, seconds / repeats);
  }
  return least;
}

}  // namespace mariotte::measuring
