#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "measuring/timing.hpp"
#include "method.hpp"
#include "row.hpp"

namespace mariotte::scaling_study {
namespace {

constexpr measuring::Patience patience{.batch = 0.05, .batches = 5};

}  // namespace

Measurement measure_own(std::size_t balls, double accuracy, Wave wave) {
  const auto chain = row(balls);
  hybrid::Options options{.accuracy = accuracy, .max_events = 10 * static_cast<Index>(balls)};
  if (wave == Wave::followed) options.flow = flow::Kind::taylor;
  impact::ChainSolver solver;
  const double start = measuring::cpu_seconds();
  const auto& impact = solver.solve(chain, options);
  const double first = measuring::cpu_seconds() - start;
  if (impact.ending != hybrid::Ending::separated) throw Error(impact.message);
  const auto again = [&] { solver.solve(chain, options); };
  return {.seconds = measuring::least_seconds(again, first, patience),
          .error = error_of(impact.velocity),
          .steps = impact.steps,
          .widest = impact.widest};
}

}  // namespace mariotte::scaling_study
