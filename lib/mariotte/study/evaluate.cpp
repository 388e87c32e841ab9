#include "mariotte/study/evaluate.hpp"

#include <memory>

#include "mariotte/study/brief_quantities.hpp"

namespace mariotte::study {
namespace {

Verdict verdict(const std::string& ending, const std::string& message) {
  Verdict made{.ending = ending};
  if (!made.has_numbers()) made.reason = message.empty() ? "the solver could not go on" : message;
  return made;
}

class Evaluator {
 public:
  Evaluator(const std::vector<std::string>& columns, const Simulate& simulate) : simulate_(simulate) {
    for (const auto& column : columns) {
      keys_.push_back(result_key(column));
      if (const auto quantity = brief_quantity(column)) brief_.push_back(*quantity);
    }
  }

  Verdict operator()(const scene::Scene& scene, std::span<double> out) {
    const bool is_chain = !scene.chain.mass.empty();
    return is_chain && brief_.size() == keys_.size() ? brief(scene, out) : whole(scene, out);
  }

 private:
  Verdict brief(const scene::Scene& scene, std::span<double> out) {
    const BriefResult result{scene.chain, solver_->solve(scene.chain, scene.run)};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = brief_[k].read(result, brief_[k].index);
    return verdict(name(result.impact.ending), result.impact.message);
  }

  Verdict whole(const scene::Scene& scene, std::span<double> out) const {
    const Json result = simulate_(scene);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = number(result, keys_[k]);
    return verdict(result.at("ending").get<std::string>(), result.value("message", ""));
  }

  std::vector<ResultKey> keys_;
  std::vector<BriefQuantity> brief_;  ///< of those columns that have one
  Simulate simulate_;
  std::shared_ptr<impact::ChainSolver> solver_ = std::make_shared<impact::ChainSolver>();
};

}  // namespace

bool Verdict::has_numbers() const {
  return ending != "failed" && ending != "rejected";
}

Evaluate make_evaluate(const std::vector<std::string>& columns, const Simulate& simulate) {
  return Evaluator(columns, simulate);
}

}  // namespace mariotte::study
