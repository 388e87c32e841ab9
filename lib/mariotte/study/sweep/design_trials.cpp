#include "mariotte/study/sweep/design_trials.hpp"

#include <algorithm>

#include "mariotte/model/fault.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/sweep_tables.hpp"

namespace mariotte::study {

using scene::Document;
using scene::Field;
using scene::Node;

namespace {

std::vector<Node> raw_values(const std::vector<Field>& tables, bool last) {
  std::vector<Node> raw;
  for (const auto& table : tables)
    if (const auto list = find(table, "values"))
      raw.push_back(last ? list->node->array()->back() : list->node->array()->front());
    else
      raw.push_back(*end_of(table, last).node);
  return raw;
}

/// Nothing if the scene is accepted, else why not.
std::optional<scene::SceneError> rejection(const Document& document, scene::ReadingLog* watch = nullptr) {
  try {
    resolve(document, scene::Purpose::simulation, watch);
    return {};
  } catch (const scene::SceneError& error) {
    return error;
  }
}

Meaning add(Meaning meaning, const Meaning& more) {
  for (std::size_t i = 0; i < meaning.size(); ++i)
    if (!meaning[i]) meaning[i] = more[i];
  return meaning;
}

struct Trial {
  Meaning meaning;
  std::optional<scene::SceneError> rejection;
};

/// What the reader makes of the first or last values of all parameters, as they are written.
Trial attempt(Document document, const Design& design, bool last) {
  assign(document, design, raw_values(varied(document), last));
  scene::ReadingLog watch;
  for (const auto& one : design.parameters)
    watch.readings.push_back(
        {.node = one.is_variable ? nullptr : &locate(document.source, document.tree, one.key, one.place)});
  Trial trial{.meaning = {}, .rejection = rejection(document, &watch)};
  for (const auto& reading : watch.readings) trial.meaning.push_back(reading.dimension);
  return trial;
}

/// The least and the largest number, which have all others between them; each at the place it was written.
std::vector<Node> extremes(const Parameter& parameter, const Field& table) {
  if (parameter.range)
    return {{parameter.range->from, end_of(table, false).place()},
            {parameter.range->to, end_of(table, true).place()}};
  if (!is_numeric(parameter)) return {};
  const auto less = [](const Node& a, const Node& b) {
    return std::get<double>(a.value) < std::get<double>(b.value);
  };
  const auto [least, most] = std::minmax_element(parameter.list.begin(), parameter.list.end(), less);
  return {*least, *most};
}

}  // namespace

Meaning read_meaning(const Document& document, const Design& design) {
  const auto first = attempt(document, design, false), last = attempt(document, design, true);
  if (first.rejection && last.rejection) throw scene::SceneError(*first.rejection);
  for (std::size_t i = 0; i < design.parameters.size(); ++i)
    if (first.meaning[i] && last.meaning[i] && !same(*first.meaning[i], *last.meaning[i]))
      reject(document.source, design.parameters[i].place, fault::sweep_key,
             "the unit of '" + design.parameters[i].key + "' depends on another key that is varied");
  return add(first.meaning, last.meaning);
}

void expect_possible(const Document& document, const Design& design) {
  const auto all = varied(document);
  Document trial = document;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (design.parameters[i].is_variable) continue;
    for (const auto& extreme : extremes(design.parameters[i], all[i])) {
      std::optional<scene::SceneError> why;
      const auto refused = [&](Index point) {
        auto company = values(design, point);
        company[i] = extreme;
        assign(trial, design, company);
        why = rejection(trial);
        return why && why->fault.code != fault::unrepresentable.code &&
               std::string_view(why->what()).starts_with(where(document.source, extreme.place) + ": ");
      };
      if (refused(0) && refused(design.points() - 1)) throw scene::SceneError(*why);
    }
  }
}

}  // namespace mariotte::study
