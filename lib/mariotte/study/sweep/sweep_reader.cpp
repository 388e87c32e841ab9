#include "mariotte/study/sweep/sweep_reader.hpp"

#include "mariotte/scene/field.hpp"
#include "mariotte/study/sweep/design_reader.hpp"

namespace mariotte::study {
namespace {

struct Example {
  scene::Scene scene;
  Json result;
};

Example at(scene::Document document, const Design& design, const Simulate& simulate, Index point) {
  assign(document, design, values(design, point));
  auto scene = resolve(document);
  auto result = simulate(scene);
  return {std::move(scene), std::move(result)};
}

/// The first point, or the last one if the first makes no sense.
Example example(const scene::Document& document, const Design& design, const Simulate& simulate) try {
  return at(document, design, simulate, 0);
} catch (const Error&) {
  return at(document, design, simulate, design.points() - 1);
}

std::vector<std::string> own_columns(const scene::Document& document, const Json& result) {
  const auto list = find(scene::Field{&document.tree, ""}, "columns");
  if (!list) return {};
  std::vector<std::string> keys;
  for (Index i = 0; i < static_cast<Index>(list->node->array()->size()); ++i) {
    const auto field = element(*list, i);
    keys.push_back(text(document.source, field));
    try {
      expand_columns({keys.back()}, result);
    } catch (const ColumnError& error) {
      reject(document.source, field, error.fault, error.what());
    }
  }
  return keys;
}

}  // namespace

SweepPlan read_sweep(scene::Document document, const Simulate& simulate,
                     const std::vector<std::string>& columns) {
  SweepPlan plan{.document = std::move(document), .design = {}, .columns = {}, .title = {}, .warnings = {}};
  plan.design = read_design(plan.document);
  const auto [scene, result] = example(plan.document, plan.design, simulate);
  const auto own = own_columns(plan.document, result);
  plan.columns = expand_columns(columns.empty() ? own : columns, result);
  plan.title = scene.title;
  plan.warnings = scene.warnings;
  return plan;
}

}  // namespace mariotte::study
