#include "mariotte/study/sweep/sweep_reader.hpp"

#include <algorithm>

#include "mariotte/scene/field.hpp"
#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::study {
namespace {

using Keys = std::vector<std::string>;

/// The first point, or the last one if the first makes no sense.
scene::Scene example(Variation& points, const Design& design) try {
  return points.at(0);
} catch (const Error&) {
  return points.at(design.points() - 1);
}

/// Points whose scenes may have other numbers of balls than the first: every value of a list, the end of a
/// range, of one axis at a time.
std::vector<Index> other_points(const Design& design) {
  std::vector<Index> points;
  for (Index axis = 0; axis < std::ssize(design.axes); ++axis) {
    const auto& [count, stride] = design.axes[axis];
    const bool listed = std::any_of(design.parameters.begin(), design.parameters.end(),
                                    [&](const Parameter& one) { return one.axis == axis && !one.range; });
    for (Index k = listed ? 1 : count - 1; k < count; ++k) points.push_back(k * stride);
  }
  return points;
}

/// The columns of the example. An index that it has too few balls for is right if another point has enough.
std::vector<Column> expand(const Keys& keys, const scene::Scene& scene, Variation& points,
                           const Design& design) try {
  return expand_columns(keys, scene);
} catch (const BeyondEnd&) {
  for (const Index point : other_points(design)) try {
      return expand_columns(keys, points.at(point));
    } catch (const Error&) {  // not this one, either
    }
  throw;
}

/// Those of the scene file.
Keys own_columns(const scene::Document& document, const auto& check) {
  const auto list = find(scene::Field{&document.tree, ""}, "columns");
  if (!list) return {};
  Keys keys;
  for (Index i = 0; i < static_cast<Index>(list->node->array()->size()); ++i) {
    const auto field = element(*list, i);
    keys.push_back(text(document.source, field));
    try {
      check(keys.back());
    } catch (const ColumnError& error) {
      reject(document.source, field, error.fault, error.what());
    }
  }
  return keys;
}

}  // namespace

SweepPlan read_sweep(scene::Document document, const Keys& columns) {
  SweepPlan plan{.document = std::move(document), .design = {}, .columns = {}, .title = {}, .warnings = {}};
  plan.design = read_design(plan.document);
  Variation points(plan.document, plan.design, std::nullopt);
  const auto scene = example(points, plan.design);
  const auto written_out = [&](const Keys& keys) { return expand(keys, scene, points, plan.design); };
  const auto own = own_columns(plan.document, [&](const std::string& key) { written_out({key}); });
  plan.columns = written_out(columns.empty() ? own : columns);
  plan.title = scene.title;
  plan.warnings = scene.warnings;
  return plan;
}

}  // namespace mariotte::study
