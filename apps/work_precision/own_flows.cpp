// Our own solver: left to itself, and with each of its flows asked for by name.
#include <memory>
#include <string_view>

#include "mariotte/core/error.hpp"
#include "mariotte/flow/choose.hpp"
#include "mariotte/impact/chain_impact.hpp"
#include "mariotte/impact/chain_solver.hpp"
#include "method.hpp"

namespace mariotte::work_precision {
namespace {

/// One solver for all cases, as a sweep would have it.
void solve(impact::ChainSolver& solver, const model::Chain& chain, const hybrid::Options& options,
           Answer& answer) {
  const auto& impact = solver.solve(chain, options);
  if (impact.ending != hybrid::Ending::separated) throw Error(impact.message);
  answer.velocity = impact.velocity;
  answer.events = impact.events;
  answer.rhs = impact.rhs;
  answer.steps = impact.steps;
  answer.periods = impact.periods;
}

/// A flow that does not admit a phase is replaced in silence; closed forms of free flight and of single
/// contacts stand beside any flow.
bool admits(const Case& first, const hybrid::Options& options) {
  bool found = false;
  for (const auto& use : impact::simulate(first.chain, options).flows) {
    if (use.name != options.flow && use.name != "ballistic" && use.name != "pair") return false;
    found = found || use.name == options.flow;
  }
  return found;
}

Solve prepare(const Problem& problem, const hybrid::Options& options) {
  if (options.flow != "auto" && !admits(problem.cases.front(), options)) return {};
  return [options, solver = std::make_shared<impact::ChainSolver>(),
          answer = std::make_shared<Answer>()](const Case& one) -> const Answer& {
    solve(*solver, one.chain, options, *answer);
    return *answer;
  };
}

Method method(std::string_view flow) {
  const std::string name(flow);
  return {.name = name,
          .family = name.starts_with("cvode") ? Family::sundials : Family::own,
          .prepare = [name](const Problem& problem, double accuracy) {
            return prepare(problem, {.accuracy = accuracy, .flow = name});
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
