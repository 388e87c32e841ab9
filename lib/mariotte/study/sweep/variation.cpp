#include "mariotte/study/sweep/variation.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/numbers.hpp"

namespace mariotte::study {
namespace {

constexpr Index points_tried = 64;     ///< of the whole grid
constexpr Index positions_tried = 64;  ///< of every parameter

/// Numbers of the scene, copied.
std::vector<double> copied(scene::Scene scene) {
  std::vector<double> copy;
  for (const double* number : numbers(scene)) copy.push_back(*number);
  return copy;
}

/// Keys by which numbers may follow from others at some points only, as a damping from the largest speed.
bool derives(const scene::Node& node) {
  constexpr std::array<std::string_view, 3> keys{"restitution", "start", "precompression"};
  if (const auto* array = node.array()) return std::any_of(array->begin(), array->end(), derives);
  const auto* table = node.table();
  return table && std::any_of(table->begin(), table->end(), [&](const scene::Entry& one) {
           return std::find(keys.begin(), keys.end(), one.key) != keys.end() || derives(one.node);
         });
}

/// `k` of `count` places among 0 … all − 1, from the first to the last.
Index spread(Index k, Index count, Index all) {
  const Index last = all - 1, parts = std::max<Index>(count - 1, 1);
  return last / parts * k + last % parts * k / parts;
}

scene::Scene resolved(scene::Document& document, const Design& design, Index point) {
  assign(document, design, values(design, point));
  return resolve(document);
}

/// The scene of the first point, but for one parameter, which has its value of another point.
scene::Scene moved(scene::Document& document, const Design& design, std::size_t parameter, Index point) {
  auto all = values(design, 0);
  all[parameter] = value(design, parameter, point);
  assign(document, design, all);
  return resolve(document);
}

/// The numbers of a scene that equal those of a parameter wherever it alone moves; empty unless it does move
/// and no other number does.
std::vector<std::size_t> slots_of(scene::Document& document, const Design& design, std::size_t parameter) {
  const auto first = resolved(document, design, 0);
  const auto before = copied(first);
  std::vector<bool> follows(before.size(), true), moves(before.size(), false);
  const auto& axis = design.axes[design.parameters[parameter].axis];
  const Index tried = std::min(axis.count, positions_tried);
  for (Index k = 0; k < tried; ++k) {
    const Index point = spread(k, tried, axis.count) * axis.stride;
    const auto scene = moved(document, design, parameter, point);
    if (!same_form(scene, first)) return {};
    const auto now = copied(scene);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i] != number(design, parameter, point)) follows[i] = false;
      if (now[i] != before[i]) moves[i] = true;
    }
  }
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (moves[i]) list.push_back(i);
  const bool all_follow = std::all_of(list.begin(), list.end(), [&](std::size_t i) { return follows[i]; });
  return all_follow ? list : std::vector<std::size_t>();
}

/// So many scenes are resolved to find the slots.
Index trials(const Design& design) {
  Index sum = std::min(design.points(), points_tried);
  for (const auto& one : design.parameters) sum += std::min(design.axes[one.axis].count, positions_tried);
  return sum;
}

std::optional<Slots> guess(scene::Document& document, const Design& design) {
  if (design.points() <= trials(design)) return {};
  if (!design.derived.empty() || derives(document.tree)) return {};
  Slots slots;
  for (std::size_t i = 0; i < design.parameters.size(); ++i) {
    if (!is_numeric(design.parameters[i]) || design.parameters[i].is_variable) return {};
    slots.push_back(slots_of(document, design, i));
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
  const Index tried = std::min(design.points(), points_tried);
  for (Index k = 0; k < tried; ++k)
    if (!right_at(document, design, direct, spread(k, tried, design.points()))) return {};
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
