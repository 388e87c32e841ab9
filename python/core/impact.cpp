#include "impact.hpp"

#include <algorithm>
#include <cmath>

#include "arrays.hpp"
#include "interruption.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/watch/chain_run.hpp"
#include "mariotte/report/warnings.hpp"
#include "mariotte/scene/judge.hpp"

namespace mariotte::python {
scene::Impact simulate(const SceneBox& box, const hybrid::Options& options, impact::RunObserver observers,
                       bool estimate) {
  observers.gives_up = [interruption = Interruption()]() mutable { return interruption(), false; };
  const auto result = [&](const auto& model) -> scene::Impact {
    auto impact = impact::simulate(model, options, observers);
    if (estimate) impact.estimated_accuracy = impact::estimate_accuracy(model, options, impact);
    scene::judge(impact, box.scene);
    return impact;
  };
  return std::visit(Overload{[&](const model::Chain& chain) { return result(chain); },
                             [&](const model::Network& network) { return result(network); },
                             [&](const model::Microbody& body) { return result(body); },
                             [&](const model::Bodies& bodies) { return result(bodies); },
                             [](const scene::LawAlone& nothing) -> scene::Impact { scene::refuse(nothing); }},
                    box.scene.model);
}

Impact::Impact(SharedScene box, const hybrid::Options& options, bool until, bool estimate)
    : box_(std::move(box)), options_(options), until_(until) {
  const py::gil_scoped_release unlocked;
  if (estimate || !solve_quickly()) whole_ = simulate(*box_, options_, {}, estimate);
  keep_ratios();
}

/// The solver tells nobody how far it is, so it gets so few events that it is done before a hand has moved,
/// and no time limit, up to which a phase may last. It knows no indentations, so a chain that might end
/// `invalid`, or with a warning of them, is not for it; nor does it know flows, of which one may be asked
/// for.
bool Impact::solve_quickly() {
  constexpr Index few = 1000;
  const auto* const chain = std::get_if<model::Chain>(&box_->scene.model);
  if (!chain || impact::divides(options_, *chain) || std::isfinite(options_.max_time)) return false;
  if (options_.flow || has_validity(box_->scene)) return false;
  auto quick = options_;
  quick.max_events = std::min(quick.max_events, few);
  thread_local impact::ChainSolver solver(impact::Course::of_simulate);
  const auto& impact = solver.solve(*chain, quick);
  if (impact.ending == hybrid::Ending::event_limit && quick.max_events < options_.max_events) return false;
  brief_ = impact;
  return true;
}

void Impact::keep_ratios() {
  if (brief_) {
    icr_ = or_nan(impact::correlation_ratios(brief_->impulse));
    return;
  }
  std::visit(Overload{[&](const impact::ContactImpact& impact) { icr_ = or_nan(impact.icr); },
                      [](const impact::MicrobodyImpact&) {}, [](const impact::BodiesImpact&) {}},
             *whole_);
}

const scene::Impact& Impact::whole() const {
  if (whole_) return *whole_;
  std::optional<scene::Impact> made;
  {
    const py::gil_scoped_release unlocked;
    made = simulate(*box_, options_);
  }
  if (!whole_) whole_ = std::move(made);  // unless another thread was quicker
  return *whole_;
}

std::vector<std::string> Impact::warnings() const {
  auto list = box_->scene.warnings;
  if (brief_ && brief_->events > 0 && !brief_->estimated_accuracy) return list;
  const auto of_run = [&](const auto& one) { return report::warnings(one, options_.flow); };
  for (auto& one : std::visit(of_run, whole())) list.push_back(std::move(one));
  return list;
}

scene::Scene Impact::scene() const {
  auto scene = box_->scene;
  scene.run = options_;
  scene.until = until_;
  return scene;
}

}  // namespace mariotte::python
