#include "slope_cost.hpp"

#include <fmt/format.h>

#include "mariotte/impact/chain/chain_impact.hpp"
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

std::string line(const Case& c, double accuracy, const measuring::Patience& patience) {
  const auto chain = three_balls(c);
  const hybrid::Options options{.accuracy = accuracy};
  const auto seconds = [&](const std::function<void()>& action) {
    return measuring::least_seconds(action, measuring::timed(action), patience);
  };
  const auto all = impact::parameters(chain);
  const std::vector<impact::Parameter<Chain>> one{all.front()};
  const double run = seconds([&] { impact::simulate(chain, options); });
  const double of_all = seconds([&] { impact::sensitivity(chain, all, options); });
  const double of_one = seconds([&] { impact::sensitivity(chain, one, options); });
  return fmt::format("{:<22}  {:>8.0e}  {:>9.1f}  {:>10}  {:>10.1f}  {:>9.1f}\n", c.name, accuracy, 1e6 * run,
                     all.size(), of_all / run, of_one / run);
}

}  // namespace

std::string slope_cost(const measuring::Patience& patience) {
  std::string text = "three balls             accuracy     run/µs  parameters  all slopes  one slope\n";
  for (const Case& c :
       {Case{"Hertz, touching", 0, 0}, Case{"Hertz, with a gap", 0, 1e-5}, Case{"damped, touching", 1e4, 0}})
    for (const double accuracy : {1e-6, 1e-10}) text += line(c, accuracy, patience);
  return text;
}

}  // namespace mariotte::work_precision
