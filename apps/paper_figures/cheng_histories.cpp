#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body_reference.hpp"
#include "cheng.hpp"
#include "strike.hpp"

namespace mariotte::paper_figures {
namespace {

constexpr double agreement = 1e-8;     // of velocities, relative to the incident speed
constexpr double same_instant = 1e-5;  // of instants [ns]
constexpr double tilts[] = {0, 10, 20, 30, 42, 45, 60, 80, 90};

/// A rod of ρ_r = 10 at 5 m/s and what is drawn of its contact.
struct History {
  double tilt;
  impact::MicrobodyImpact impact;
  std::vector<double> time;  ///< [ns]
};

std::vector<History> histories(double friction) {
  std::vector<History> list;
  for (const double tilt : tilts) {
    History one{tilt, simulate({.tilt = tilt, .friction = friction}, true), {}};
    for (const auto& state : one.impact.trace.state) one.time.push_back(1e9 * state.time);
    list.push_back(std::move(one));
  }
  return list;
}

/// One quantity of every sample.
template <class Of>
std::vector<double> column(const History& history, const Of& of) {
  std::vector<double> values;
  for (std::size_t row = 0; row < history.time.size(); ++row) values.push_back(of(history.impact.trace, row));
  return values;
}

double centre_normal(const impact::BodyTrace& trace, std::size_t row) {
  return trace.state[row].velocity.e1;
}
double centre_tangential(const impact::BodyTrace& trace, std::size_t row) {
  return trace.state[row].velocity.e3;
}
double tip_slip(const impact::BodyTrace& trace, std::size_t row) {
  return trace.slip[row][0].e3;
}
double normal_force(const impact::BodyTrace& trace, std::size_t row) {
  return 1e6 * trace.normal_force[row][0];
}
double tip_normal(const impact::BodyTrace& trace, std::size_t row) {
  static const auto rod = microbody({}).body;
  const auto& state = trace.state[row];
  return (state.velocity + cross(state.spin, rotate(state.attitude, rod.tips[0].centre))).e1;
}

using Quantity = double (*)(const impact::BodyTrace&, std::size_t);

/// `solid` over time for every tilt, and `dashed` if there is one.
Picture picture(const std::vector<History>& all, Quantity solid, Quantity dashed = nullptr) {
  Picture picture;
  for (const auto& one : all) {
    const double colour = one.tilt / 90;
    picture.curves.push_back(
        {fmt::format("β = {}°", one.tilt), Style::line, one.time, column(one, solid), colour});
    if (dashed) picture.curves.push_back({"", Style::dashed, one.time, column(one, dashed), colour});
  }
  picture.x_label = "time t [ns]";
  return picture;
}

double instant(const impact::MicrobodyImpact& impact, std::vector<Index> impact::TipEvents::*kind) {
  for (const auto& event : impact.events)
    if (!(event.*kind).empty()) return 1e9 * event.time;
  return NAN;
}

double true_instant(const nlohmann::json& truth, const std::string& kind) {
  for (const auto& event : truth["events"])
    if (event[0] == kind) return 1e9 * event[2].get<double>();
  return NAN;
}

/// Final velocities and instants of all tilts.
std::vector<Check> checks(const std::vector<History>& all, double friction) {
  std::vector<Check> list;
  for (const auto& [tilt, impact, time] : all) {
    const auto truth = rod_reference(tilt, friction);
    const auto& end = truth["final"];
    const auto& v = impact.final.velocity;
    const double off = std::max(std::abs(v.e1 - end[4].get<double>()), std::abs(v.e3 - end[6].get<double>()));
    list.push_back({fmt::format("β = {}°: difference of velocity / v_n", tilt), off / 5, 0, agreement});
    list.push_back({fmt::format("β = {}°: contact time [ns]", tilt), 1e9 * impact.final.time,
                    1e9 * end[0].get<double>(), same_instant});
    list.push_back({fmt::format("β = {}°: F_n turns positive [ns]", tilt),
                    instant(impact, &impact::TipEvents::push), true_instant(truth, "push"), same_instant});
    list.push_back({fmt::format("β = {}°: F_n turns negative [ns]", tilt),
                    instant(impact, &impact::TipEvents::pull), true_instant(truth, "pull"), same_instant});
  }
  return list;
}

Reproduction made(const std::vector<History>& all, double friction, Picture picture, std::string y_label,
                  std::string what) {
  Reproduction result;
  result.picture = std::move(picture);
  result.picture.y_label = std::move(y_label);
  result.picture.title = fmt::format("rods of length ratio 10 at 5 m/s, μ = {}: {}", friction, what);
  result.checks = checks(all, friction);
  result.remark = "The paper draws every degree, this figure nine of them.";
  return result;
}

Claim contact_time(const std::vector<History>& all) {
  bool falling = true;
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
    falling &= all[i + 1].impact.final.time < all[i].impact.final.time;
  return {"with more tilt contacts are shorter", yes_if(falling),
          fmt::format("{:.2f} ns at β = 0°, {:.2f} ns at 90°", 1e9 * all.front().impact.final.time,
                      1e9 * all.back().impact.final.time)};
}

/// Tilt [°] up to which every one of whole degrees ends without slip.
Claim no_slip() {
  double last = 0;
  for (double tilt = 0; tilt <= 90; ++tilt) {
    if (std::abs(simulate({.tilt = tilt, .friction = 0.7}).impacts[0].slip_out.e3) > 1e-3) break;
    last = tilt;
  }
  return {"with large friction the tip ends without tangential velocity",
          last < 90 ? Verdict::partly : Verdict::yes, fmt::format("less than 1 mm/s up to β = {}°", last)};
}

/// The first change of friction after the normal force has become positive is that slip turns round.
bool reverses(const impact::MicrobodyImpact& impact) {
  const double push = 1e-9 * instant(impact, &impact::TipEvents::push);
  for (const auto& event : impact.events)
    if (event.time > push && !(event.slip.empty() && event.stick.empty())) return !event.slip.empty();
  return false;
}

/// Largest slip [m/s] strictly between the events that begin and end sticking.
double slip_while_sticking(const History& history) {
  const auto& [tilt, impact, time] = history;
  double most = 0;
  for (std::size_t k = 0; k + 1 < impact.events.size(); ++k) {
    if (impact.events[k].stick.empty()) continue;
    for (std::size_t row = 0; row < impact.trace.state.size(); ++row)
      if (impact.trace.state[row].time > impact.events[k].time &&
          impact.trace.state[row].time < impact.events[k + 1].time)
        most = std::max(most, std::abs(impact.trace.slip[row][0].e3));
  }
  return most;
}

Claim rolling(const std::vector<History>& all) {
  double most = 0;
  for (const auto& one : all) most = std::max(most, slip_while_sticking(one));
  return {"v_t = ω × r while the tip sticks", yes_if(most < 1e-9), fmt::format("within {:.0e} m/s", most)};
}

Claim reversal() {
  double first = 90;
  for (double tilt = 89; tilt >= 1 && reverses(simulate({.tilt = tilt})); --tilt) first = tilt;
  return {
      "negative normal forces reverse the tangential motion of the tip",
      first <= 1 ? Verdict::yes : Verdict::partly,
      fmt::format("with μ = 0.15 slip turns round soon after the force has become a push, from β = {}° on; "
                  "below, the tip sticks first",
                  first)};
}

Claim pulls_at_both_ends(const std::vector<History>& all) {
  bool holds = true;
  for (const auto& one : all) {
    const auto force = column(one, normal_force);
    const double push = instant(one.impact, &impact::TipEvents::push),
                 pull = instant(one.impact, &impact::TipEvents::pull);
    for (std::size_t row = 0; row < force.size(); ++row) {
      const double t = one.time[row], margin = 1e-3;
      if (t > margin && t < push - margin) holds &= force[row] < 0;
      if (t > pull + margin && t < one.time.back() - margin) holds &= force[row] < 0;
      if (t > push + margin && t < pull - margin) holds &= force[row] > 0;
    }
  }
  return {"the normal force is negative at the beginning and the end of contact, positive between",
          yes_if(holds), "at every tilt shown"};
}

Claim tip_rebound(const std::vector<History>& all) {
  double least = INFINITY, most = 0;
  for (const auto& one : all) {
    least = std::min(least, one.impact.restitution.tip);
    most = std::max(most, one.impact.restitution.tip);
  }
  return {"the rebound of the tip hardly depends on the tilt", yes_if(most - least < 0.05),
          fmt::format("e_n = {:.4f} … {:.4f}", least, most)};
}

Reproduction centre_velocities(double friction) {
  const auto all = histories(friction);
  auto result = made(all, friction, picture(all, centre_normal, centre_tangential), "velocity v [m/s]",
                     "mass centre, normal (—) and tangential (- -)");
  result.claims = {contact_time(all)};
  return result;
}

Reproduction tip_normal_velocities() {
  const auto all = histories(0.7);
  auto result = made(all, 0.7, picture(all, tip_normal), "velocity v [m/s]", "tip, normal");
  result.claims = {tip_rebound(all), no_slip(), rolling(all)};
  return result;
}

Reproduction tip_velocities() {
  const auto all = histories(0.15);
  auto result = made(all, 0.15, picture(all, tip_normal, tip_slip), "velocity v [m/s]",
                     "tip, normal (—) and tangential (- -)");
  result.claims = {tip_rebound(all), reversal()};
  return result;
}

Reproduction forces() {
  const auto all = histories(0.15);
  auto result = made(all, 0.15, picture(all, normal_force), "normal force F_n [µN]", "normal force");
  result.claims = {pulls_at_both_ends(all)};
  return result;
}

Figure figure(int number, const std::string& what, std::function<Reproduction()> make) {
  return {fmt::format("cheng-{}", number),
          fmt::format("Cheng, Brach & Dunn 2002, figure {}: {}", number, what), std::move(make)};
}

}  // namespace

std::vector<Figure> cheng_histories() {
  return {figure(11, "velocities of the mass centre, μ = 0.7", [] { return centre_velocities(0.7); }),
          figure(12, "normal velocity of the tip, μ = 0.7", tip_normal_velocities),
          figure(13, "velocities of the mass centre, μ = 0.15", [] { return centre_velocities(0.15); }),
          figure(14, "velocities of the tip, μ = 0.15", tip_velocities),
          figure(15, "normal force, μ = 0.15", forces)};
}

}  // namespace mariotte::paper_figures
