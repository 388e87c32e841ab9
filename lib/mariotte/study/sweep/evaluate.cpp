#include "mariotte/study/sweep/evaluate.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <tuple>

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/impact/shallow.hpp"
#include "mariotte/scene/judge.hpp"
#include "mariotte/study/sweep/slope_columns.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"

namespace mariotte::study {
namespace {

template <class Impact>
Verdict verdict(const Impact& impact) {
  Verdict made{.ending = name(impact.ending)};
  if (!made.has_numbers())
    made.reason = impact.message.empty() ? "the solver could not go on" : impact.message;
  return made;
}

/// The columns of scenes of one kind.
template <class Model>
class OfModel {
  using Impact = decltype(impact::unfilled(std::declval<const Model&>()));
  using Brief = impact::Brief<Impact>;
  using Entry = std::optional<impact::Entry<Impact>>;

 public:
  explicit OfModel(const std::vector<Column>& columns) {
    for (const auto& column : columns) {
      const auto key = impact::parse_key(column.key);
      entries_.push_back(key ? impact::find_entry<Impact>(*key) : Entry());
    }
    is_brief_ = true;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!is_slope(columns[i].key)) is_brief_ = is_brief_ && entries_[i] && is_brief(*entries_[i]);
  }

  Verdict evaluate(const Model& model, const scene::Scene& scene, std::span<double> out) {
    if (is_brief_ && Brief::serves(model) && impact::stays_shallow(model, scene.touching)) {
      const auto& impact = solver_->solve(model, scene.run);
      fill(Brief{model, impact}, out);
      return verdict(impact);
    }
    auto impact = impact::simulate(model, scene.run);
    judge(impact, scene);
    fill(impact, out);
    return verdict(impact);
  }

 private:
  template <class Result>
  void fill(const Result& result, std::span<double> out) const {
    std::transform(entries_.begin(), entries_.end(), out.begin(), [&](const Entry& entry) {
      return entry ? number(*entry, result) : std::numeric_limits<double>::quiet_NaN();
    });
  }

  std::vector<Entry> entries_;  ///< empty where this kind of scene has no such number
  bool is_brief_ = false;       ///< the quickest solver has them all
  std::shared_ptr<typename Brief::Solver> solver_ = std::make_shared<typename Brief::Solver>();
};

class Evaluator {
 public:
  explicit Evaluator(const std::vector<Column>& columns) : all_{columns, columns, columns, columns} {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (is_slope(columns[i].key)) slopes_.push_back(slope_column(columns[i].key, i));
  }

  Verdict operator()(const scene::Scene& scene, std::span<double> out) {
    auto verdict =
        std::visit(Overload{[&]<class Model>(const Model& model) {
                              return std::get<OfModel<Model>>(all_).evaluate(model, scene, out);
                            },
                            [](const scene::LawAlone& nothing) -> Verdict { scene::refuse(nothing); }},
                   scene.model);
    if (!slopes_.empty() && verdict.has_numbers()) fill_slopes(scene, slopes_, out);
    return verdict;
  }

 private:
  std::tuple<OfModel<model::Chain>, OfModel<model::Network>, OfModel<model::Microbody>,
             OfModel<model::Bodies>>
      all_;
  std::vector<SlopeColumn> slopes_;
};

}  // namespace

bool Verdict::has_numbers() const {
  return ending != "failed" && ending != "unsure" && ending != "invalid" && ending != "rejected";
}

Evaluate make_evaluate(const std::vector<Column>& columns) {
  return Evaluator(columns);
}

EvaluatePoint make_evaluate_point(const SweepPlan& plan) {
  return [evaluate = make_evaluate(plan.results), design = plan.design, outputs = plan.outputs,
          numbers = std::vector<double>(plan.results.size())](const scene::Scene& scene, Index point,
                                                              std::span<double> out) mutable {
    auto verdict = evaluate(scene, numbers);
    for (std::size_t i = 0; i < outputs.size(); ++i)
      out[i] = outputs[i].formula ? number(design, *outputs[i].formula, point, numbers)
                                  : numbers[outputs[i].result];
    return verdict;
  };
}

}  // namespace mariotte::study
