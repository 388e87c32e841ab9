#include <algorithm>
#include <iterator>

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

}  // namespace

RunPlot plot(const impact::BodiesImpact& impact, const std::string& title, const CurveNames& names,
             const scene::Figure& figure) {
  impact::ContactImpact same;
  same.trace = impact::contact_trace(impact.trace, impact.dimension);
  for (const auto& event : impact.events) {
    impact::Event marks{.time = event.time};
    marks.open = event.of(model::BodyEvent::open);
    marks.close = closing(event);
    if (!marks.open.empty() || !marks.close.empty()) same.events.push_back(std::move(marks));
  }
  return plot(same, title, names, figure);
}

std::vector<Window> windows_of_action(const impact::BodiesTrace& trace) {
  return windows_of_action(impact::contact_trace(trace, 2));
}

}  // namespace mariotte::report
