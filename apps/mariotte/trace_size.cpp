#include "trace_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::command {
namespace {

constexpr double bytes_per_number = 20;  // of CSV; HDF5 needs less

std::string bytes_text(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.3g} kB", bytes / 1e3);
  if (bytes < 1e9) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} GB", bytes / 1e9);
}

TraceSize size_of(const RunningTrace& trace, double duration, double every, const char* bound = "") {
  const auto& chosen = trace.sampling;
  const double columns = static_cast<double>(1 + chosen.velocities.size() + 2 * chosen.contacts.size());
  const double rows = duration / every + 2;
  return {.duration = duration, .rows = rows, .bytes = rows * columns * bytes_per_number, .bound = bound};
}

}  // namespace

TraceSize measure(const RunningTrace& trace, const model::Chain& chain, const hybrid::Options& options,
                  const std::function<bool()>& interrupted) {
  if (trace.every > 0)
    if (const auto most = size_of(trace, options.max_time, trace.every, "at most "); !most.is_large())
      return most;
  TraceSize size;
  impact::RunObserver observers;
  observers.samplings = {{.take = [&](const impact::Sample& sample) {
    size = size_of(trace, sample.time, trace.every > 0 ? trace.every : sample.natural_time);
    return std::max(sample.time, sample.natural_time);  // few samples, and one of the ending
  }}};
  observers.gives_up = [&] { return size.is_absurd() || interrupted(); };
  const auto ending = impact::simulate(chain, options, observers).ending;
  if (ending == hybrid::Ending::interrupted) size.bound = "at least ";
  return size;
}

std::string text(const TraceSize& size) {
  const auto time = report::display_for(std::vector{size.duration}, "s");
  return fmt::format("{}{:.4g} rows over {:.4g} {}, about {}", size.bound, size.rows,
                     time.factor * size.duration, time.unit, bytes_text(size.bytes));
}

}  // namespace mariotte::command
