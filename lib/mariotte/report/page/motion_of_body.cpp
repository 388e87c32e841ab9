#include <nlohmann/json.hpp>

#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/report/page/motion.hpp"
#include "mariotte/report/page/motion_frames.hpp"

namespace mariotte::report {
namespace {

/// Between two states, turned and not cut short.
impact::BodyState state_between(const impact::BodyState& a, const impact::BodyState& b, double part) {
  const auto mixed = [&](double x, double y) { return x + part * (y - x); };
  impact::BodyState state = a;
  state.position = a.position + part * (b.position - a.position);
  state.attitude = normalized({mixed(a.attitude.w, b.attitude.w), mixed(a.attitude.x, b.attitude.x),
                               mixed(a.attitude.y, b.attitude.y), mixed(a.attitude.z, b.attitude.z)});
  return state;
}

/// Forces at the samples of a trace, normal and along e3 for each tip in turn.
Rows tip_forces(const impact::BodyTrace& trace) {
  Rows rows;
  for (std::size_t row = 0; row < trace.state.size(); ++row) {
    rows.emplace_back();
    for (std::size_t i = 0; i < trace.gap[row].size(); ++i)
      rows.back().insert(rows.back().end(), {trace.normal_force[row][i], trace.friction[row][i].e3});
  }
  return rows;
}

/// Places of the tips, e3 to the right and e1 up, and forces on them.
Course course_of(const impact::BodyTrace& trace, const std::vector<model::Tip>& tips,
                 const scene::Figure& figure) {
  Course samples{{}, {}, tip_forces(trace)};
  for (const auto& state : trace.state) samples.time.push_back(state.time);
  const auto windows = time_axis(action_of(trace), {}, figure).windows;
  Course course{instants(windows, samples.time, samples.force), {}, {}};
  for (const double time : course.time) {
    const auto at = position(samples.time, time);
    const auto state = state_between(trace.state[at.first], trace.state[at.first + 1], at.second);
    course.place.emplace_back();
    for (const auto& tip : tips) {
      const auto centre = state.position + rotate(state.attitude, tip.centre);
      course.place.back().insert(course.place.back().end(), {centre.e3, centre.e1});
    }
    course.force.push_back(between(samples.force, at));
  }
  return course;
}

}  // namespace

Json motion(const impact::MicrobodyImpact& impact, const scene::Scene& scene) {
  const auto& tips = std::get<model::Microbody>(scene.model).body.tips;
  const auto& trace = impact.trace;
  if (trace.state.size() < 2) return {};
  std::vector<Disc> discs;
  std::vector<DiscContact> contacts;
  for (const auto& tip : tips) {
    discs.push_back({0, 0, tip.radius});
    const int on = static_cast<int>(discs.size()) - 1;
    if (discs.size() <= trace.gap.front().size())
      contacts.insert(contacts.end(), {{-1, on, 0, 1}, {-1, on, 1, 0}});
  }
  auto all = as_json(discs, contacts, course_of(trace, tips, scene.figure));
  all["floor"] = true;
  if (tips.size() == 2) all["links"] = {{0, 1}};
  return all;
}

}  // namespace mariotte::report
