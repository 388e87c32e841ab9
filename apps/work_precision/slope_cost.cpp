#include "slope_cost.hpp"

#include <fmt/format.h>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::work_precision {
namespace {

using model::Chain;

struct Case {
  const char* name;
  double damping, gap;
};

Chain three_balls(const Case& c) {
  const contact::PowerLaw law{.stiffness = 1.09e10, .damping = c.damping, .exponent = 1.5};
  return {.mass = {0.0327, 0.0327, 0.0327}, .law = {law, law}, .gap = {0, c.gap}, .velocity = {1, 0, 0}};
}

double seconds_of(const std::function<void()>& action, const measuring::Patience& patience) {
  return measuring::least_seconds(action, measuring::timed(action), patience);
}

std::string line(const Case& c, double accuracy, const measuring::Patience& patience) {
  const auto chain = three_balls(c);
  const hybrid::Options options{.accuracy = accuracy};
  const auto seconds = [&](const std::function<void()>& action) { return seconds_of(action, patience); };
  const auto all = impact::parameters(chain);
  const std::vector<impact::Parameter<Chain>> one{all.front()};
  const double run = seconds([&] { impact::simulate(chain, options); });
  const double of_all = seconds([&] { impact::sensitivity(chain, all, options); });
  const double of_one = seconds([&] { impact::sensitivity(chain, one, options); });
  return fmt::format("{:<22}  {:>8.0e}  {:>9.1f}  {:>10}  {:>10.1f}  {:>9.1f}\n", c.name, accuracy, 1e6 * run,
                     all.size(), of_all / run, of_one / run);
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

/// Slopes of the last velocity by all masses, velocities, gaps and stiffnesses.
std::string line_of_row(std::size_t balls, double accuracy, const measuring::Patience& patience) {
  const auto row = row_of(balls);
  const hybrid::Options options{.accuracy = accuracy};
  std::vector<double> weights(balls);
  weights.back() = 1;
  std::size_t bytes = 0;
  const double run = seconds_of([&] { impact::simulate(row, options); }, patience);
  const double back = seconds_of([&] { bytes = impact::adjoint(row, weights, options).bytes; }, patience);
  return fmt::format("{:<22}  {:>8.0e}  {:>9.0f}  {:>10}  {:>10.1f}  {:>10}\n",
                     fmt::format("{} balls", balls), accuracy, 1e6 * run, 4 * balls - 2, back / run,
                     bytes / balls);
}

}  // namespace

std::string slope_cost(const measuring::Patience& patience) {
  std::string text = "three balls             accuracy     run/µs  parameters  all slopes  one slope\n";
  for (const Case& c :
       {Case{"Hertz, touching", 0, 0}, Case{"Hertz, with a gap", 0, 1e-5}, Case{"damped, touching", 1e4, 0}})
    for (const double accuracy : {1e-6, 1e-10}) text += line(c, accuracy, patience);
  text += "\nrows, swept back        accuracy     run/µs  parameters  all slopes  bytes/ball\n";
  for (const std::size_t balls : {100, 1000, 10000})
    for (const double accuracy : {1e-6, 1e-10}) text += line_of_row(balls, accuracy, patience);
  return text;
}

}  // namespace mariotte::work_precision
