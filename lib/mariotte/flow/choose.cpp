#include "mariotte/flow/choose.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/flows.hpp"

namespace mariotte::flow {
namespace {

// Measured by stiffness_study --study crossover and --study ratio.

/// Damping ratios c/√(k m) from which BDF costs less than Adams. Its Newton matrices are sparse: KLU is
/// hardly dearer than a dense or a band matrix at any size, and mostly cheaper.
constexpr double stiff_for_adams = 5;
/// Natural modes of n contacts cost n³, series √κ of the ratio of fastest to slowest rate squared: equal near
/// κ = 10^{0.8 n}. Two contacts are followed by modes whatever κ, to the last digit.
constexpr Index always_modal = 2;
constexpr double decades_per_contact = 0.8;

/// Closed contacts of a network up to which its modes cost less than CVODE; integrals of the work of damped
/// contacts cost the cube of their number.
constexpr Index most_linked_modes = 50, most_damped_linked_modes = 8;

/// Of the two heaviest bodies that contacts may push, but for a second wall: between them the slowest motion
/// takes place, however quick light bodies are.
double least_mobility(const SerialPhase& phase) {
  const auto& contact = phase.contact;
  const auto is_joined = [&](std::size_t i) {
    return (i > 0 && contact[i - 1].role != Role::open) ||
           (i < contact.size() && contact[i].role != Role::open);
  };
  double least = infinity, next = infinity;
  for (std::size_t i = 0; i < phase.body.size(); ++i) {
    const double mobility = phase.body[i].inverse_mass;
    if (!is_joined(i) || (mobility == 0 && least == 0)) continue;
    next = std::min(next, std::max(least, mobility));
    least = std::min(least, mobility);
  }
  return least + next;
}

/// Largest over smallest of the rates squared: k/m* and (c/m*)² of the contacts that carry force, and what
/// the softest of them would have between the heaviest bodies.
double spread(const SerialPhase& phase) {
  double softest = infinity, most = 0;
  for (std::size_t j = 0; j < phase.contact.size(); ++j) {
    const auto& c = phase.contact[j];
    if (c.role == Role::open) continue;
    const double mobility = phase.body[j].inverse_mass + phase.body[j + 1].inverse_mass;
    const double decay = c.damping * mobility;
    softest = std::min(softest, c.stiffness);
    most = std::max({most, c.stiffness * mobility, decay * decay});
  }
  return most / (softest * least_mobility(phase));
}

Index pushing(const std::vector<PhaseContact>& contacts) {
  return std::count_if(contacts.begin(), contacts.end(), [](const PhaseContact& c) { return c.pushes(); });
}

bool modes_pay(const LinkedPhase& phase) {
  const auto is_damped = [](const PhaseContact& c) { return c.pushes() && c.damping > 0; };
  const bool damped = std::any_of(phase.contact.begin(), phase.contact.end(), is_damped);
  return pushing(phase.contact) <= (damped ? most_damped_linked_modes : most_linked_modes);
}

bool modes_pay(const SerialPhase& phase) {
  const auto contacts = pushing(phase.contact);
  return contacts <= always_modal ||
         spread(phase) > std::pow(10, decades_per_contact * static_cast<double>(contacts));
}

/// True unless another flow that admits the phase costs less.
bool pays(Kind kind, const Problem& problem) {
  if (problem.tip() || problem.recorded()) return kind == Kind::taylor;
  const auto* row = problem.serial();
  if (kind == Kind::pair) return row;
  const auto* linked = problem.linked();
  if (!row && !linked) return false;
  if (kind == Kind::modal && !are_linear(row ? row->contact : linked->contact)) return false;
  if (kind == Kind::modal) return row ? modes_pay(*row) : modes_pay(*linked);
  return true;
}

std::unique_ptr<Flow> make(Kind kind, const Problem& problem) {
  if (is_cvode(kind)) return make_cvode_flow(kind, problem);
  if (kind == Kind::pair) return make_pair_flow();
  if (kind == Kind::modal) return make_modal_flow();
  if (kind == Kind::taylor) {
    if (problem.tip()) return make_tip_flow();
    if (problem.recorded()) return make_recorded_flow();
    return make_taylor_flow();
  }
  if (problem.free_body()) return make_flight_flow();
  if (problem.free_motion()) return make_drift_flow();
  return make_ballistic_flow();
}

/// Those that follow some phases only, the cheapest first; where they do not, another takes over.
constexpr std::array special = {Kind::pair, Kind::modal, Kind::taylor};

}  // namespace

Choice Flows::choose(const Problem& problem, std::optional<Kind> requested) {
  const auto take = [&](Kind kind) -> Choice { return {kind, get(kind, problem)}; };
  if (problem.is_ballistic()) return take(Kind::ballistic);
  const bool any = requested && std::find(special.begin(), special.end(), *requested) == special.end();
  if (any) return take(*requested);
  for (const auto kind : special)
    if (requested ? requested == kind : pays(kind, problem))
      if (auto choice = take(kind); choice.flow.admits(problem)) return choice;
  return take(problem.damping_group() < stiff_for_adams ? Kind::cvode_adams : Kind::cvode_bdf_klu);
}

std::optional<Choice> Flows::instead_of(Kind kind, bool stiff, const Problem& problem,
                                        std::optional<Kind> requested) {
  if (kind == Kind::ballistic || (!stiff && (kind == Kind::cvode_adams || requested))) return std::nullopt;
  if (kind == Kind::pair)
    if (auto& taylor = get(Kind::taylor, problem); taylor.admits(problem))
      return Choice{Kind::taylor, taylor};
  const bool adams = kind == Kind::cvode_bdf_klu || (kind != Kind::cvode_adams && problem.recorded() &&
                                                     problem.damping_group() < stiff_for_adams);
  const auto next = adams ? Kind::cvode_adams : Kind::cvode_bdf_klu;
  return Choice{next, get(next, problem)};
}

Flow& Flows::get(Kind kind, const Problem& problem) {
  auto& flow = flows_[static_cast<std::size_t>(kind)];
  if (!flow || !flow->fits(problem)) flow = make(kind, problem);
  return *flow;
}

}  // namespace mariotte::flow
