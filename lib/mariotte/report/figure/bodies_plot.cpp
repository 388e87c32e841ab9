#include "mariotte/report/figure/plot.hpp"

namespace mariotte::report {

RunPlot plot(const impact::BodiesImpact& impact, const std::string& title, const CurveNames& names,
             const scene::Figure& figure) {
  impact::ContactImpact same;
  same.trace = impact::contact_trace(impact.trace, impact.dimension);
  for (const auto& event : impact.events) {
    impact::Event marks{.time = event.time};
    marks.open = event.of(model::BodyEvent::open);
    marks.close = event.of(model::BodyEvent::close);
    if (!marks.open.empty() || !marks.close.empty()) same.events.push_back(std::move(marks));
  }
  return plot(same, title, names, figure);
}

std::vector<Window> windows_of_action(const impact::BodiesTrace& trace) {
  return windows_of_action(impact::contact_trace(trace, 2));
}

}  // namespace mariotte::report
