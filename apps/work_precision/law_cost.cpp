#include "law_cost.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"

namespace mariotte::work_precision {
namespace {

contact::LawNumbers numbers(const contact::NamedLaw& law) {
  return {.stiffness = 1,
          .exponent = law.exponent.value_or(1.5),
          .damping = law.damping() ? 0.3 : 0,
          .loading_stiffness = 1,
          .unloading_stiffness = 2,
          .effective_modulus = 1,
          .effective_radius = 1,
          .yield_pressure = 0.3,
          .work_of_adhesion = 0.01,
          .damping_hertz = 0.1,
          .damping_adhesion = 0.1};
}

/// Equal balls that meet at unit speed.
model::Chain pair(const contact::NamedLaw& law) {
  return {.mass = {1, 1}, .law = {law.make(numbers(law))}, .gap = {0}, .velocity = {1, 0}};
}

struct Cost {
  double seconds, velocity;
};

Cost cost(const model::Chain& chain, const hybrid::Options& options, const measuring::Patience& patience) {
  impact::ChainSolver solver;
  const auto run = [&] { solver.solve(chain, options); };
  const double seconds = measuring::least_seconds(run, measuring::timed(run), patience);
  return {seconds, solver.solve(chain, options).velocity[1]};
}

std::string line(const contact::NamedLaw& law, double accuracy, const measuring::Patience& patience) {
  const auto chosen = cost(pair(law), {.accuracy = accuracy}, patience);
  const auto adams = cost(pair(law), {.accuracy = accuracy, .flow = flow::Kind::cvode_adams}, patience);
  return fmt::format("{:<14}  {:>8.0e}  {:>8.1f}  {:>8.1f}  {:>6.1f}  {:>10.1e}\n", law.name, accuracy,
                     1e6 * chosen.seconds, 1e6 * adams.seconds, adams.seconds / chosen.seconds,
                     std::abs(chosen.velocity - adams.velocity));
}

}  // namespace

std::string law_cost(const measuring::Patience& patience) {
  std::string text = "pair            accuracy   auto/µs  Adams/µs   ratio  difference\n";
  for (const auto& law : contact::named_laws)
    if (!law.has_table)
      for (const double accuracy : {1e-6, 1e-10}) text += line(law, accuracy, patience);
  return text;
}

}  // namespace mariotte::work_precision
