#include "mariotte/study/sweep/evaluate.hpp"

#include <memory>

#include "mariotte/core/overload.hpp"
#include "mariotte/study/sweep/brief_quantities.hpp"

namespace mariotte::study {
namespace {

Verdict verdict(const std::string& ending, const std::string& message) {
  Verdict made{.ending = ending};
  if (!made.has_numbers()) made.reason = message.empty() ? "the solver could not go on" : message;
  return made;
}

/// Columns read from the brief result of one kind of scene, with the solver that makes it.
template <class Result, class Solver>
struct Brief {
  std::vector<BriefQuantity<Result>> columns;  ///< of those that the brief result has
  std::shared_ptr<Solver> solver = std::make_shared<Solver>();

  void add(const std::optional<BriefQuantity<Result>>& quantity) {
    if (quantity) columns.push_back(*quantity);
  }
  template <class Model>
  Verdict evaluate(const Model& model, const hybrid::Options& run, std::span<double> out) {
    const Result result{model, solver->solve(model, run)};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = columns[k].read(result, columns[k].index);
    return verdict(name(result.impact.ending), result.impact.message);
  }
};

class Evaluator {
 public:
  Evaluator(const std::vector<std::string>& columns, const Simulate& simulate) : simulate_(simulate) {
    for (const auto& column : columns) {
      keys_.push_back(result_key(column));
      chain_.add(brief_quantity_of_chain(column));
      body_.add(brief_quantity_of_body(column));
    }
  }

  Verdict operator()(const scene::Scene& scene, std::span<double> out) {
    return std::visit(
        Overload{[&](const model::Chain& chain) {
                   return has_all(chain_) ? chain_.evaluate(chain, scene.run, out) : whole(scene, out);
                 },
                 [&](const model::Network&) { return whole(scene, out); },
                 [&](const model::Microbody& body) {
                   return body.impacts == 1 && has_all(body_) ? body_.evaluate(body, scene.run, out)
                                                              : whole(scene, out);
                 },
                 [&](const scene::LawAlone&) { return whole(scene, out); }},
        scene.model);
  }

 private:
  bool has_all(const auto& brief) const { return brief.columns.size() == keys_.size(); }

  Verdict whole(const scene::Scene& scene, std::span<double> out) const {
    const Json result = simulate_(scene);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = number(result, keys_[k]);
    return verdict(result.at("ending").get<std::string>(), result.value("message", ""));
  }

  std::vector<ResultKey> keys_;
  Brief<BriefChain, impact::ChainSolver> chain_;
  Brief<BriefBody, impact::MicrobodySolver> body_;
  Simulate simulate_;
};

}  // namespace

bool Verdict::has_numbers() const {
  return ending != "failed" && ending != "unsure" && ending != "rejected";
}

Evaluate make_evaluate(const std::vector<std::string>& columns, const Simulate& simulate) {
  return Evaluator(columns, simulate);
}

}  // namespace mariotte::study
