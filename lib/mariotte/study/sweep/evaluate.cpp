#include "mariotte/study/sweep/evaluate.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <tuple>

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/chain/chain_batch.hpp"
#include "mariotte/impact/microbody/microbody_batch.hpp"
#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/impact/shallow.hpp"
#include "mariotte/scene/judge.hpp"
#include "mariotte/study/sweep/slope_columns.hpp"

namespace mariotte::study {
namespace {

template <class Impact>
Verdict verdict(const Impact& impact) {
  Verdict made{.ending = name(impact.ending), .estimated_accuracy = impact.estimated_accuracy};
  if (!made.has_numbers())
    made.reason = impact.message.empty() ? "the solver could not go on" : impact.message;
  return made;
}

/// The columns of scenes of one kind.
template <class Model>
class OfModel {
  using Impact = decltype(impact::unfilled(std::declval<const Model&>()));
  using Entry = std::optional<impact::Entry<Impact>>;

 public:
  using Brief = impact::Brief<Impact>;

  explicit OfModel(const std::vector<Column>& columns) {
    for (const auto& column : columns) {
      const auto key = impact::parse_key(column.key);
      entries_.push_back(key ? impact::find_entry<Impact>(*key) : Entry());
    }
    is_brief_ = true;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!is_slope(columns[i].key)) is_brief_ = is_brief_ && entries_[i] && impact::is_brief(*entries_[i]);
  }

  Verdict evaluate(const Model& model, const scene::Scene& scene, std::span<double> out) {
    if (is_brief(model, scene)) {
      const auto& impact = solver_->solve(model, scene.run);
      fill(Brief{model, impact}, out);
      return verdict(impact);
    }
    auto impact = impact::simulate(model, scene.run);
    judge(impact, scene);
    fill(impact, out);
    return verdict(impact);
  }
  /// Whether the quickest solver has all that is asked of a scene.
  bool is_brief(const Model& model, const scene::Scene& scene) const {
    return is_brief_ && Brief::serves(model) && impact::stays_shallow(model, scene.touching);
  }
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

  Verdict operator()(const scene::Scene& scene, std::span<double> out,
                     const scene::Document* document = nullptr) {
    auto verdict =
        std::visit(Overload{[&]<class Model>(const Model& model) {
                              return std::get<OfModel<Model>>(all_).evaluate(model, scene, out);
                            },
                            [](const scene::LawAlone& nothing) -> Verdict { scene::refuse(nothing); }},
                   scene.model);
    if (document && !slopes_.empty() && verdict.has_numbers())
      verdict.reason = fill_slopes({*document, scene}, slopes_, out);
    return verdict;
  }
  /// The model of a scene of which only what its quickest solver tells is asked; null of others.
  template <class Model>
  const Model* brief_model(const scene::Scene& scene) const {
    const auto* model = std::get_if<Model>(&scene.model);
    const bool is_brief = model && slopes_.empty() && std::get<OfModel<Model>>(all_).is_brief(*model, scene);
    return is_brief ? model : nullptr;
  }
  template <class Model, class Impact>
  Verdict fill(const Model& model, const Impact& impact, std::span<double> out) const {
    const auto& columns = std::get<OfModel<Model>>(all_);
    columns.fill(typename OfModel<Model>::Brief{model, impact}, out);
    return verdict(impact);
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

struct Evaluations::Parts {
  Evaluator evaluate;
  Take take;
  std::vector<double> numbers;
  impact::ChainBatch chains{[this](const auto&... result) { pass(result...); }};
  impact::MicrobodyBatch bodies{[this](const auto&... result) { pass(result...); }};

  void pass(Index which, const auto& model, const auto& impact) {
    auto verdict = evaluate.fill(model, impact, numbers);
    take(which, std::move(verdict), numbers);
  }
};

Evaluations::Evaluations(const std::vector<Column>& columns, Take take)
    : parts_(new Parts{Evaluator(columns), std::move(take), std::vector<double>(columns.size())}) {}
Evaluations::~Evaluations() = default;

void Evaluations::put(Index which, const scene::Scene& scene, const scene::Document* document) {
  auto& [evaluate, take, numbers, chains, bodies] = *parts_;
  if (const auto* chain = evaluate.brief_model<model::Chain>(scene))
    return chains.put(which, *chain, scene.run);
  if (const auto* body = evaluate.brief_model<model::Microbody>(scene))
    return bodies.put(which, *body, scene.run);
  auto verdict = evaluate(scene, numbers, document);
  take(which, std::move(verdict), numbers);
}

void Evaluations::finish() {
  parts_->chains.finish();
  parts_->bodies.finish();
}

}  // namespace mariotte::study
