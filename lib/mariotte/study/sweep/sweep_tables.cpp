#include "mariotte/study/sweep/sweep_tables.hpp"

#include "mariotte/scene/sweep_shape.hpp"
#include "mariotte/study/fault.hpp"

namespace mariotte::study {

using scene::Document;
using scene::Field;

std::vector<Field> tables(const Document& document) {
  const auto list = find(Field{&document.tree, ""}, "sweep");
  if (!list)
    reject(document.source, scene::Place{}, fault::no_sweep,
           "the scene has no [[sweep]] that says what to vary");
  expect_sweeps(document.source, *list);
  std::vector<Field> all;
  for (Index i = 0; i < static_cast<Index>(list->node->array()->size()); ++i)
    all.push_back(element(*list, i));
  return all;
}

std::vector<Field> varied(const Document& document) {
  auto all = tables(document);
  std::erase_if(all, [](const Field& table) { return find(table, "expression").has_value(); });
  return all;
}
std::vector<Field> derived(const Document& document) {
  auto all = tables(document);
  std::erase_if(all, [](const Field& table) { return !find(table, "expression"); });
  return all;
}

Field end_of(const Field& table, bool last) {
  const auto mean = find(table, "mean");
  return mean ? *mean : *find(table, last ? "to" : "from");
}

}  // namespace mariotte::study
