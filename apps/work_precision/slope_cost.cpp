#include "slope_cost.hpp"

#include <fmt/format.h>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "slope_rival.hpp"

namespace mariotte::work_precision {
namespace {

using model::Chain;

struct Case {
  const char* name;
  double damping, gap;
};

Chain three_balls(const Case& c) {
  const contact::PowerLaw law{.stiffness = 1, .damping = c.damping, .exponent = 1.5};
  return {.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, c.gap}, .velocity = {1, 0, 0}};
}

double seconds_of(const std::function<void()>& action, const measuring::Patience& patience) {
  return measuring::least_seconds(action, measuring::timed(action), patience);
}

/// Time of CVODES for all slopes, as right as that.
std::string rival(const Chain& chain, double accuracy, double run, const measuring::Patience& patience) {
  const auto right = impact::sensitivity(chain, impact::parameters(chain), {.accuracy = 1e-12});
  VelocitySlopes slopes(chain.mass.size());
  for (std::size_t i = 0; i < slopes.size(); ++i)
    for (const auto& slope : right.outcome[i].slope) slopes[i].push_back(slope.value());
  const auto found = slopes_by_cvodes(chain, impact::simulate(chain).time, slopes, accuracy, patience);
  return found ? fmt::format("{:.1f}", found->seconds / run) : "never";
}

std::string line(const Case& c, double accuracy, const measuring::Patience& patience) {
  const auto chain = three_balls(c);
  const hybrid::Options options{.accuracy = accuracy};
  const auto seconds = [&](const std::function<void()>& action) { return seconds_of(action, patience); };
  const auto all = impact::parameters(chain);
  const std::vector<impact::Parameter<Chain>> one{all.front()};
  impact::ChainSolver solver;
  const double run = seconds([&] { impact::simulate(chain, options); });
  const double brief = seconds([&] { solver.solve(chain, options); });
  const double of_all = seconds([&] { impact::sensitivity(chain, all, options); });
  const double of_one = seconds([&] { impact::sensitivity(chain, one, options); });
  return fmt::format("{:<22}  {:>8.0e}  {:>9.1f}  {:>8.1f}  {:>10}  {:>10.1f}  {:>9.1f}  {:>10}\n", c.name,
                     accuracy, 1e6 * run, 1e6 * brief, all.size(), of_all / run, of_one / run,
                     rival(chain, accuracy, run, patience));
}

/// Equal balls that touch, struck by the first.
Chain row_of(std::size_t balls) {
  Chain row{.mass = std::vector<double>(balls, 1),
            .law = std::vector<contact::Law>(balls - 1, contact::Hertz(1)),
            .gap = std::vector<double>(balls - 1),
            .velocity = std::vector<double>(balls)};
  row.velocity[0] = 1;
  return row;
}

/// Slopes of the last velocity by all masses, velocities, gaps and stiffnesses, beside a run that follows the
/// wave past every ball, as slopes have to.
std::string line_of_row(std::size_t balls, double accuracy, const measuring::Patience& patience) {
  const auto row = row_of(balls);
  const hybrid::Options options{.accuracy = accuracy};
  std::vector<double> weights(balls);
  weights.back() = 1;
  std::size_t bytes = 0;
  auto followed = options;
  followed.flow = flow::Kind::taylor;
  const double run = seconds_of([&] { impact::simulate(row, followed); }, patience);
  const double back = seconds_of([&] { bytes = impact::adjoint(row, weights, options).bytes; }, patience);
  return fmt::format("{:<22}  {:>8.0e}  {:>9.0f}  {:>10}  {:>10.1f}  {:>10}\n",
                     fmt::format("{} balls", balls), accuracy, 1e6 * run, 4 * balls - 2, back / run,
                     bytes / balls);
}

}  // namespace

std::string slope_cost(const measuring::Patience& patience) {
  std::string text =
      "three balls             accuracy     run/µs  brief/µs  parameters  all slopes  one slope  all "
      "CVODES\n";
  for (const Case& c :
       {Case{"Hertz, touching", 0, 0}, Case{"Hertz, with a gap", 0, 0.4}, Case{"damped, touching", 0.04, 0}})
    for (const double accuracy : {1e-6, 1e-10}) text += line(c, accuracy, patience);
  text += "\nrows, swept back        accuracy  follow/µs  parameters  all slopes  bytes/ball\n";
  for (const std::size_t balls : {100, 1000, 10000})
    for (const double accuracy : {1e-6, 1e-10}) text += line_of_row(balls, accuracy, patience);
  return text;
}

}  // namespace mariotte::work_precision
