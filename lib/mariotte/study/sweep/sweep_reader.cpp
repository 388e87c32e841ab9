#include "mariotte/study/sweep/sweep_reader.hpp"

#include <algorithm>
#include <optional>

#include "mariotte/core/overload.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/study/constant_restitution.hpp"
#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/formula_reader.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::study {
namespace {

using Keys = std::vector<std::string>;

/// A point that stands for all.
struct Example {
  scene::Scene scene;
  scene::Document document;
};
Example example_at(Variation& points, Index point) {
  auto scene = points.at(point);
  return {std::move(scene), points.document(point)};
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

std::size_t bodies(const scene::Scene& scene) {
  return std::visit(Overload{[](const model::Chain& chain) { return chain.mass.size(); },
                             [](const model::Network& network) { return network.velocity.size(); },
                             [](const model::Bodies& bodies) { return bodies.body.size(); },
                             [](const model::Microbody&) { return std::size_t(1); },
                             [](const scene::LawAlone&) { return std::size_t(0); }},
                    scene.model);
}

/// The point with the most bodies of the first and those that may have others, so that * stands for all of
/// them; the last point if none of these makes sense.
Example find_example(Variation& points, const Design& design) {
  constexpr std::size_t most_tried = 1000;
  std::optional<Example> found;
  const auto look_at = [&](Index point) {
    try {
      auto example = example_at(points, point);
      if (!found || bodies(found->scene) < bodies(example.scene)) found = std::move(example);
    } catch (const Error&) {  // not this one
    }
  };
  look_at(0);
  const auto others = other_points(design);
  for (std::size_t i = 0; i < std::min(others.size(), most_tried); ++i) look_at(others[i]);
  return found ? *std::move(found) : example_at(points, design.points() - 1);
}

/// The columns of the example. An index that it has too few balls for is right if another point has enough.
std::vector<Column> expand(const Keys& keys, const Example& example, Variation& points, const Design& design,
                           Counting counting) try {
  return expand_columns(keys, example.scene, counting, &example.document);
} catch (const BeyondEnd&) {
  for (const Index point : other_points(design)) try {
      const auto other = example_at(points, point);
      return expand_columns(keys, other.scene, counting, &other.document);
    } catch (const Error&) {  // not this one, either
    }
  throw;
}

/// Adds columns to a plan, each once.
class ColumnReader {
 public:
  ColumnReader(SweepPlan& plan, const Example& example, Variation& points,
               Counting counting = Counting::by_run)
      : plan_(plan), example_(example), points_(points), counting_(counting) {}

  void add(const std::string& text) {
    if (const auto sign = text.find('='); sign != text.npos) return add_formula(text, sign);
    add_keys({text});
  }
  /// Empty: those that say most.
  void add_keys(const Keys& keys) {
    for (auto& column : expand(keys, example_, points_, plan_.design, counting_)) {
      if (is_known(column.key)) continue;
      plan_.outputs.push_back({.result = result(column)});
      plan_.columns.push_back(std::move(column));
    }
  }

 private:
  static std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == text.npos ? "" : std::string(text.substr(first, last - first + 1));
  }
  bool is_known(const std::string& key) const {
    return std::any_of(plan_.columns.begin(), plan_.columns.end(),
                       [&](const Column& one) { return one.key == key; });
  }
  /// The sweep has a column of that name anyway.
  bool is_taken(const std::string& name) const {
    const auto& varied = plan_.design.parameters;
    if (name == "ending" || name == "reason") return true;
    return std::any_of(varied.begin(), varied.end(), [&](const auto& one) { return one.key == name; });
  }
  bool is_of_results(const std::string& name) const {
    try {
      expand({name}, example_, points_, plan_.design, Counting::without_run);
      return true;
    } catch (const Error&) {
      return false;
    }
  }
  /// Its place among the results.
  std::size_t result(const Column& column) {
    const auto found = std::find_if(plan_.results.begin(), plan_.results.end(),
                                    [&](const Column& one) { return one.key == column.key; });
    if (found != plan_.results.end()) return static_cast<std::size_t>(found - plan_.results.begin());
    plan_.results.push_back(column);
    return plan_.results.size() - 1;
  }
  Term term(const std::string& name) {
    if (is_input(name, plan_.design)) return input_term(name, plan_.document, plan_.design);
    const auto columns = expand({name}, example_, points_, plan_.design, counting_);
    return {.kind = Term::Kind::result, .which = result(columns.front())};
  }
  void add_formula(const std::string& text, std::size_t sign) try {
    const auto name = trimmed(text.substr(0, sign));
    if (name.empty()) throw ColumnError("'" + text + "' needs a name before '='");
    if (is_known(name) || is_taken(name)) throw ColumnError("there are two columns '" + name + "'");
    if (is_of_results(name))
      throw ColumnError("'" + name + "' is the key of a result; give the formula another name");
    if (text.find("[*]") != text.npos)
      throw ColumnError("'" + text + "': [*] stands for several numbers, an expression is one");
    Formula formula{.expression = Expression(trimmed(text.substr(sign + 1))), .terms = {}};
    for (const auto& one : formula.expression.names()) formula.terms.push_back(term(one));
    plan_.columns.push_back({.key = name, .written = text});
    plan_.outputs.push_back({.formula = std::move(formula)});
  } catch (const ExpressionError& error) {
    throw ColumnError(error.what());
  }

  SweepPlan& plan_;
  const Example& example_;
  Variation& points_;
  Counting counting_;
};

/// Those of the scene file; each is tried where it stands, without a run.
Keys own_columns(SweepPlan trial, const Example& example, Variation& points) {
  const auto& document = trial.document;
  ColumnReader reader(trial, example, points, Counting::without_run);
  const auto list = find(scene::Field{&document.tree, ""}, "columns");
  if (!list) return {};
  Keys keys;
  for (Index i = 0; i < static_cast<Index>(list->node->array()->size()); ++i) {
    const auto field = element(*list, i);
    keys.push_back(text(document.source, field));
    try {
      reader.add(keys.back());
    } catch (const ColumnError& error) {
      reject(document.source, field, error.fault, error.what());
    }
  }
  return keys;
}

/// Of the ends of an axis of speeds; points that make no sense say so themselves.
std::vector<std::string> warnings_of_speeds(const SweepPlan& plan, Variation& points) try {
  const auto& all = plan.design.parameters;
  const auto moved = std::ranges::find_if(all, [](const Parameter& one) { return is_speed(one.key); });
  if (moved == all.end()) return {};
  const auto& axis = plan.design.axes[static_cast<std::size_t>(moved->axis)];
  const auto slow = points.at(0);
  return warn_of_constant_restitution(plan.document, slow, points.at(axis.stride * (axis.count - 1)));
} catch (const Error&) {
  return {};
}

}  // namespace

SweepPlan read_sweep(scene::Document document, const Keys& columns) {
  SweepPlan plan;
  plan.document = std::move(document);
  plan.design = read_design(plan.document);
  Variation points(plan.document, plan.design, std::nullopt);
  const auto example = find_example(points, plan.design);
  const auto& scene = example.scene;
  const auto own = own_columns(plan, example, points);
  ColumnReader reader(plan, example, points);
  for (const auto& text : columns.empty() ? own : columns) reader.add(text);
  if (plan.columns.empty()) reader.add_keys({});
  plan.title = scene.title;
  plan.figure = scene.figure;
  plan.warnings = scene.warnings;
  for (auto& one : warnings_of_speeds(plan, points)) plan.warnings.push_back(std::move(one));
  return plan;
}

void expect_own_columns(const scene::Document& document, const Design& design) {
  SweepPlan plan;
  plan.document = document;
  plan.design = design;
  Variation points(document, design, std::nullopt);
  const auto example = find_example(points, design);
  own_columns(std::move(plan), example, points);
}

}  // namespace mariotte::study
