#include "mariotte/study/sweep/variation.hpp"

#include <algorithm>

#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/numbers.hpp"

namespace mariotte::study {
namespace {

constexpr Index points_tried = 8;  ///< of the whole grid

/// Numbers of the scene, copied.
std::vector<double> copied(scene::Scene scene) {
  std::vector<double> copy;
  for (const double* number : numbers(scene)) copy.push_back(*number);
  return copy;
}

/// The numbers that equal the parameter's value at every trial.
struct Candidate {
  std::size_t parameter;
  std::vector<bool> follows;

  void keep_those_of(const std::vector<double>& numbers, double value) {
    follows.resize(numbers.size(), true);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (numbers[k] != value) follows[k] = false;
  }
  std::vector<std::size_t> slots() const {
    std::vector<std::size_t> list;
    for (std::size_t k = 0; k < follows.size(); ++k)
      if (follows[k]) list.push_back(k);
    return list;
  }
};

/// Both ends and the middle of one axis, all others at their first position.
std::vector<Index> along(const Axis& axis) {
  return {0, axis.count / 2 * axis.stride, (axis.count - 1) * axis.stride};
}

scene::Scene resolved(scene::Document& document, const Design& design, Index point) {
  assign(document, design, values(design, point));
  return resolve(document);
}

std::optional<Slots> guess(scene::Document& document, const Design& design) {
  Slots slots;
  if (!design.derived.empty()) return {};
  for (std::size_t i = 0; i < design.parameters.size(); ++i) {
    if (!is_numeric(design.parameters[i]) || design.parameters[i].is_variable) return {};
    Candidate candidate{.parameter = i, .follows = {}};
    for (const Index point : along(design.axes[design.parameters[i].axis])) {
      const auto scene = resolved(document, design, point);
      if (const auto all = copied(scene); candidate.follows.empty() || candidate.follows.size() == all.size())
        candidate.keep_those_of(all, number(design, i, point));
      else
        return {};
    }
    slots.push_back(candidate.slots());
    if (slots.back().empty()) return {};
  }
  return slots;
}

/// Setting the slots gives the very scene that the reader makes of the point.
bool right_at(scene::Document& document, const Design& design, Variation& direct, Index point) {
  const auto& quick = direct.at(point);
  const auto full = resolved(document, design, point);
  return same_form(quick, full) && copied(quick) == copied(full);
}

}  // namespace

std::optional<Slots> find_slots(const scene::Document& original, const Design& design) try {
  scene::Document document = original;
  const auto slots = guess(document, design);
  if (!slots) return {};
  Variation direct(original, design, slots);
  const Index last = design.points() - 1;
  for (Index k = 0; k <= points_tried; ++k)
    if (!right_at(document, design, direct, last / points_tried * k + last % points_tried * k / points_tried))
      return {};
  return slots;
} catch (const scene::SceneError&) {
  return {};  // some points are no scenes, so each has to be asked
}

Variation::Variation(scene::Document document, const Design& design, const std::optional<Slots>& slots)
    : document_(std::move(document)), design_(design) {
  if (!slots) return;
  scene_ = resolve(document_);
  const auto all = numbers(scene_);
  for (const auto& of_parameter : *slots)
    for (auto& list = numbers_.emplace_back(); const std::size_t slot : of_parameter)
      list.push_back(all[slot]);
}

const scene::Document& Variation::document(Index point) {
  assign(document_, design_, values(design_, point));
  return document_;
}

const scene::Scene& Variation::at(Index point) {
  if (numbers_.empty()) return scene_ = resolved(document_, design_, point);
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const double value = number(design_, i, point);
    for (double* const target : numbers_[i]) *target = value;
  }
  return scene_;
}

}  // namespace mariotte::study
