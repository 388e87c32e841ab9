#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "acary.hpp"
#include "chain_reference.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/figure/event_marks.hpp"

namespace mariotte::paper_figures {
namespace {

constexpr double accuracy = 1e-12;
constexpr double agreement = 1e-9;  // instants of weak contacts are known less well than velocities

struct Panel {
  char letter;
  Triplet triplet;
  std::string_view shows;
};

constexpr std::array<Panel, 8> panels = {{
    {'a', {"hertz", 1, 0}, "two overlapping pulses"},
    {'b', {"hertz", 10, -1}, "contact 2 acts twice"},
    {'c', {"hertz", 100, -0.25}, "contact 2 acts three times"},
    {'d', {"hertz", 1, 0.25}, "contact 2 begins late"},
    {'e', {"linear", 1, 0}, "two overlapping pulses"},
    {'f', {"linear", 10, -0.5}, "contact 2 acts twice"},
    {'g', {"linear", 100, -0.25}, "contact 2 acts three times"},
    {'h', {"linear", 1, 0.25}, "contact 2 begins late"},
}};

std::vector<Check> checks(const impact::ChainImpact& impact, const nlohmann::json& truth) {
  std::vector<Check> list;
  for (std::size_t i = 0; i < impact.velocity.size(); ++i)
    list.push_back(
        {fmt::format("velocity of ball {}", i + 1), impact.velocity[i], truth["final"][i], agreement});
  for (std::size_t j = 0; j < impact.contacts.size(); ++j) {
    const auto& periods = impact.contacts[j].periods;
    const auto& true_periods = truth["periods"][j];
    list.push_back({fmt::format("periods of contact {}", j + 1), static_cast<double>(periods.size()),
                    static_cast<double>(true_periods.size()), 0});
    for (std::size_t k = 0; k < std::min(periods.size(), true_periods.size()); ++k) {
      // When a ball that rests against a neighbour begins to press it is a matter of accuracy.
      if (periods[k].start > 0 && true_periods[k][0] > 1e-3)
        list.push_back({fmt::format("contact {} closes again or late", j + 1), periods[k].start,
                        true_periods[k][0], agreement});
      list.push_back({fmt::format("contact {} opens", j + 1), periods[k].end.value_or(-1), true_periods[k][1],
                      agreement});
    }
  }
  return list;
}

Claim claim(const Panel& panel, const impact::ChainImpact& impact) {
  const auto& second = impact.contacts[1].periods;
  const auto finding = fmt::format("contact 1 acts {}×, contact 2 {}× from t = {:.4g}",
                                   impact.contacts[0].periods.size(), second.size(), second[0].start);
  const auto as = [&](std::string text, bool holds) {
    return Claim{std::move(text), yes_if(holds), finding};
  };
  if (panel.letter == 'b' || panel.letter == 'c' || panel.letter == 'f' || panel.letter == 'g')
    return as("several periods of contact may occur before the balls separate", second.size() > 1);
  if (panel.letter == 'd' || panel.letter == 'h')
    return as("a contact may begin later than the first", second[0].start > 0.1);
  return as("after one contact breaks and the other ends there is no further contact",
            impact.contacts[0].periods.size() == 1 && second.size() == 1);
}

Reproduction make(const Panel& panel) {
  const bool linear = panel.triplet.law == "linear";
  const auto impact = impact::simulate(chain(panel.triplet), {.accuracy = accuracy}, {.trace = true});
  const auto& trace = impact.trace;
  Reproduction result;
  result.picture = {.title = fmt::format("{} contacts, κ = {}, v₃ = {}: {}", linear ? "linear" : "Hertz",
                                         panel.triplet.ratio, panel.triplet.third_velocity, panel.shows),
                    .x_label = linear ? "time t / (m/k)^{1/2}" : "time t / (m^2/k^2v_1)^{1/5}",
                    .y_label = linear ? "force f / v_1(mk)^{1/2}" : "force f / m^{3/5}k^{2/5}v_1^{6/5}",
                    .commands = "set tmargin 4.5\nset title offset 0,1.3\n" +
                                report::event_marks(impact.events, {1, "", 3}, {0, impact.time}, 470),
                    .curves = {}};
  for (std::size_t j = 0; j < 2; ++j) {
    Curve curve{fmt::format("contact {}", j + 1), Style::line, trace.time, {}};
    for (const auto& row : trace.force) curve.y.push_back(row[j]);
    result.picture.curves.push_back(std::move(curve));
  }
  result.checks = checks(impact, reference(panel.triplet));
  result.claims = {claim(panel, impact)};
  result.remark =
      "The printed figure does not give κ and v₃; these show what the text says of it. m = k₁ = v₁ = 1.";
  return result;
}

}  // namespace

std::vector<Figure> acary_forces() {
  std::vector<Figure> list;
  for (const auto& panel : panels)
    list.push_back(
        {fmt::format("acary-1{}", panel.letter),
         fmt::format("Acary & Brogliato 2003, figure 1({}): forces between three balls", panel.letter),
         [&panel] { return make(panel); }});
  return list;
}

}  // namespace mariotte::paper_figures
