// Our own solver: left to itself, and with each of its flows asked for by name.
#include <memory>
#include <string_view>

#include "mariotte/core/error.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/flow/choose.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "method.hpp"

namespace mariotte::work_precision {
namespace {

template <class Impact>
void count(const Impact& impact, Answer& answer) {
  if (impact.ending != hybrid::Ending::separated) throw Error(impact.message);
  answer.events = impact.events;
  answer.rhs = impact.rhs;
  answer.steps = impact.steps;
}

/// One solver for all cases, as a sweep would have it.
struct Solvers {
  impact::ChainSolver chains;
  impact::MicrobodySolver bodies;

  void solve(const model::Chain& chain, const hybrid::Options& options, Answer& answer) {
    const auto& impact = chains.solve(chain, options);
    count(impact, answer);
    answer.velocity = impact.velocity;
    answer.periods = impact.periods;
  }
  void solve(const Body& body, const hybrid::Options& options, Answer& answer) {
    const auto& impact = bodies.solve(body.stated, options);
    count(impact, answer);
    const double unit = 1 / (body.scaled.speed * body.scaled.scale.velocity);
    const Vector3 v = unit * impact.velocity, w = (unit * reach(body.stated.body)) * impact.spin;
    answer.velocity = {v.e1, v.e2, v.e3, w.e1, w.e2, w.e3};
  }
};

/// A flow that does not admit a phase is replaced in silence; closed forms of free flight and of single
/// contacts stand beside any flow.
bool admits(const Case& first, const hybrid::Options& options) {
  bool found = false;
  const auto asked = flow::name(options.flow);
  const auto flows =
      std::visit(Overload{[&](const model::Chain& chain) { return impact::simulate(chain, options).flows; },
                          [&](const Body& body) { return impact::simulate(body.stated, options).flows; }},
                 first.model);
  for (const auto& use : flows) {
    if (use.name != asked && use.name != "ballistic" && use.name != "pair") return false;
    found = found || use.name == asked;
  }
  return found;
}

Solve prepare(const Problem& problem, const hybrid::Options& options) {
  if (options.flow && !admits(problem.cases.front(), options)) return {};
  return [options, solvers = std::make_shared<Solvers>(),
          answer = std::make_shared<Answer>()](const Case& one) -> const Answer& {
    std::visit([&](const auto& model) { solvers->solve(model, options, *answer); }, one.model);
    return *answer;
  };
}

Method method(std::string_view flow) {
  const std::string name(flow);
  return {.name = name,
          .family = name.starts_with("cvode") ? Family::sundials : Family::own,
          .prepare = [name](const Problem& problem, double accuracy) {
            return prepare(problem, {.accuracy = accuracy, .flow = flow::parse_kind(name)});
          }};
}

}  // namespace

std::vector<Method> own_methods() {
  std::vector<Method> list = {method("auto")};
  for (const auto kind : flow::kinds)
    if (kind != flow::Kind::ballistic) list.push_back(method(flow::name(kind)));
  return list;
}

}  // namespace mariotte::work_precision
