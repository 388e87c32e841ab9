#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/plot.hpp"

namespace mariotte::report {
namespace {

/// Contacts that carry force from now on; those that were touching at rest are among them if they are
/// pressed.
std::vector<Index> closing(const impact::BodiesEvents& event) {
  auto all = event.of(model::BodyEvent::close);
  const auto& part = event.of(model::BodyEvent::part);
  const auto& touch = event.of(model::BodyEvent::touch);
  std::copy_if(touch.begin(), touch.end(), std::back_inserter(all),
               [&](Index j) { return std::find(part.begin(), part.end(), j) == part.end(); });
  std::sort(all.begin(), all.end());
  return all;
}

/// Of all that may touch, what belongs to the contacts of the result, in its order.
template <class Value>
std::vector<Value> of_result(const impact::BodiesImpact& impact, const std::vector<Value>& all) {
  std::vector<Value> some;
  for (const auto& one : impact.contacts) some.push_back(all[static_cast<std::size_t>(one.contact)]);
  return some;
}

/// "f_{2} (floor–rod.1)", with the number that events have.
CurveNames numbered(const impact::BodiesImpact& impact, CurveNames names) {
  if (names.contacts.empty()) return names;
  names.contacts = of_result(impact, names.contacts);
  for (std::size_t j = 0; j < names.contacts.size(); ++j)
    names.contacts[j] = fmt::format("f_{{{}}} ({})", j + 1, plain(names.contacts[j]));
  return names;
}

}  // namespace

RunPlot plot(const impact::BodiesImpact& impact, const std::string& title, const CurveNames& names,
             const scene::Figure& figure) {
  impact::ContactImpact same;
  same.trace = impact::contact_trace(impact.trace, impact.dimension);
  for (auto* rows : {&same.trace.gap, &same.trace.force})
    for (auto& row : *rows) row = of_result(impact, row);
  for (const auto& event : impact.events) {
    impact::Event marks{.time = event.time};
    marks.open = event.of(model::BodyEvent::open);
    marks.close = closing(event);
    if (!marks.open.empty() || !marks.close.empty()) same.events.push_back(std::move(marks));
  }
  return plot(same, title, numbered(impact, names), figure);
}

std::vector<Window> windows_of_action(const impact::BodiesTrace& trace) {
  return windows_of_action(impact::contact_trace(trace, 2));
}

}  // namespace mariotte::report
