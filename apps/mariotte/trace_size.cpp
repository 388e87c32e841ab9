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

}  // namespace

TraceSize measure(const RunningTrace& trace, const model::Chain& chain, const hybrid::Options& options,
                  impact::RunObserver observers) {
  impact::Sample last;
  observers.samplings = {{.take = [&last](const impact::Sample& sample) {
    last = sample;
    return std::max(sample.time, sample.natural_time);  // few samples, and one of the ending
  }}};
  impact::simulate(chain, options, observers);
  const double every = trace.every > 0 ? trace.every : last.natural_time;
  const auto& chosen = trace.sampling;
  const double columns = static_cast<double>(1 + chosen.velocities.size() + 2 * chosen.contacts.size());
  const double rows = last.time / every + 2;
  return {.duration = last.time, .rows = rows, .bytes = rows * columns * bytes_per_number};
}

std::string text(const TraceSize& size) {
  const auto time = report::display_for(std::vector{size.duration}, "s");
  return fmt::format("{:.4g} rows over {:.4g} {}, about {}", size.rows, time.factor * size.duration,
                     time.unit, bytes_text(size.bytes));
}

}  // namespace mariotte::command
