#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "body_reference.hpp"
#include "cheng.hpp"
#include "strike.hpp"

namespace mariotte::paper_figures {
namespace {

constexpr double agreement = 1e-8;

/// Restitution along one parameter of a strike.
struct Line {
  Strike strike;
  double Strike::*along;
  std::vector<double> x, tip, centre;
};

Line follow(const Strike& strike, double Strike::*along, double last, double step) {
  Line line{strike, along, {}, {}, {}};
  for (double x = 0; x <= last; x += step) {
    line.strike.*along = x;
    const auto [tip, centre] = simulate(line.strike).restitution;
    line.x.push_back(x);
    line.tip.push_back(tip);
    line.centre.push_back(centre);
  }
  return line;
}

/// Where the mass centre ceases to rebound, by halving; NaN if it never does.
double turning_point(Strike strike, double Strike::*along, double from, double to) {
  const auto rebounds = [&](double x) {
    strike.*along = x;
    return simulate(strike).restitution.centre > 0;
  };
  if (!rebounds(from) || rebounds(to)) return NAN;
  while (to - from > 1e-6 * to) (rebounds((from + to) / 2) ? from : to) = (from + to) / 2;
  return to;
}

void add_curves(Picture& picture, const Line& line, const std::string& name) {
  const double colour = static_cast<double>(picture.curves.size()) / 8;
  picture.curves.push_back({"e_n, " + name, Style::line, line.x, line.tip, colour});
  picture.curves.push_back({"e_{nm}, " + name, Style::dashed, line.x, line.centre, colour});
}

/// Both coefficients of a line against the reference, in one number.
Check compare(const Line& line, const std::string& name) {
  double most = 0;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    auto strike = line.strike;
    strike.*line.along = line.x[i];
    const auto truth = body_reference(strike)["restitution"];
    most = std::max({most, std::abs(line.tip[i] - truth[0].get<double>()),
                     std::abs(line.centre[i] - truth[1].get<double>())});
  }
  return {name + ": largest difference of e_n, e_nm", most, 0, agreement};
}

Reproduction against(const std::vector<Line>& lines, const std::vector<std::string>& names) {
  Reproduction result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    add_curves(result.picture, lines[i], names[i]);
    result.checks.push_back(compare(lines[i], names[i]));
  }
  return result;
}

/// The four lines of figures 8 and 9: β = 20°, 45° without and with friction.
struct Lengths {
  std::vector<Line> lines;
  std::vector<std::string> names;

  explicit Lengths(const std::string& shape) {
    for (const double tilt : {20.0, 45.0})
      for (const double friction : {0.0, 0.15}) {
        lines.push_back(follow({.shape = shape, .tilt = tilt, .friction = friction, .speed = 2},
                               &Strike::length_ratio, 50, 0.5));
        names.push_back(fmt::format("β = {}°, μ = {}", tilt, friction));
      }
  }
};

/// Lines in pairs without and with friction.
Claim friction_claim(const std::vector<Line>& lines) {
  int points = 0, held = 0;
  for (std::size_t k = 0; k + 1 < lines.size(); k += 2)
    for (std::size_t i = 1; i < lines[k].x.size(); ++i) {
      ++points;
      held += lines[k + 1].tip[i] < lines[k].tip[i] && lines[k + 1].centre[i] > lines[k].centre[i];
    }
  return {"friction decreases e_n slightly and increases e_nm",
          held == points ? Verdict::yes : Verdict::partly,
          fmt::format("both at {} of {} points", held, points)};
}

/// e_n at ρ_r = 10 and at the end, with friction.
Claim flat_claim(const std::vector<Line>& lines) {
  double change = 0;
  std::vector<std::string> found;
  for (const auto* line : {&lines[1], &lines[3]}) {
    const double ten = line->tip[20], last = line->tip.back();
    change = std::max(change, std::abs(ten - last));
    found.push_back(fmt::format("{:.3f} to {:.3f} at {}°", ten, last, line->strike.tilt));
  }
  return {"e_n hardly changes beyond ρ_r = 10", change < 0.01 ? Verdict::yes : Verdict::partly,
          fmt::format("{} from there to ρ_r = 50 with μ = 0.15", fmt::join(found, ", "))};
}

/// e_n of a very long rod, and what it tends to: only the damping of the contact is left, to first order.
struct SlimRod {
  Strike strike{.length_ratio = 1e6, .tilt = 45, .friction = 0, .speed = 2};
  double found = simulate(strike).restitution.tip;
  double limit = 1 - 2.0 / 3 * microbody(strike).law[0].damping_hertz * strike.speed;
};

Claim limit_claim(const SlimRod& rod) {
  return {"e_n tends to 1 as ρ_r grows", yes_if(std::abs(1 - rod.found) < 0.1 * (1 - rod.limit)),
          fmt::format("{:.4f} at ρ_r = 10⁶, near 1 − ⅔ C_H v = {:.4f}", rod.found, rod.limit)};
}

/// Rods that may strike 200 times.
Claim repeated_claim() {
  int captured = 0, all = 0;
  std::size_t most = 0;
  for (const double ratio : {5.0, 10.0, 20.0})
    for (double tilt = 10; tilt < 90; tilt += 10) {
      auto body = microbody({.length_ratio = ratio, .tilt = tilt});
      body.impacts = 200;
      const auto impact = impact::simulate(body, {});
      ++all;
      captured += impact.ending == hybrid::Ending::captured;
      most = std::max(most, impact.impacts.size());
    }
  return {"repeated impacts capture slim bodies",
          captured == all ? Verdict::yes
          : captured == 0 ? Verdict::no
                          : Verdict::partly,
          fmt::format("{} of {} rods at 5 m/s; the others fly off after at most {} impacts", captured, all,
                      most)};
}

/// With length.
Claim rising_claim(const std::vector<Line>& lines) {
  std::vector<std::string> exceptions;
  for (const auto& line : lines)
    for (std::size_t i = 0; i + 1 < line.x.size(); ++i)
      if (line.tip[i + 1] < line.tip[i])
        exceptions.push_back(fmt::format("{} … {} at β = {}°, μ = {}", line.x[i], line.x[i + 1],
                                         line.strike.tilt, line.strike.friction));
  return {
      "e_n increases with ρ_r", exceptions.empty() ? Verdict::yes : Verdict::partly,
      exceptions.empty() ? "everywhere" : fmt::format("but not for ρ_r = {}", fmt::join(exceptions, ", "))};
}

Reproduction dumbbells() {
  const Lengths all("dumbbell");
  auto result = against(all.lines, all.names);
  result.picture.title = "two hemispheres on a massless rod, 2 m/s";
  result.picture.x_label = "length ratio ρ_r = L/r";
  result.picture.y_label = "restitution e_n, e_{nm}";
  bool above = true;
  for (const auto& line : all.lines)
    for (std::size_t i = 0; i < line.x.size(); ++i)
      if (line.x[i] > 1) above &= line.tip[i] > line.centre[i];
  result.claims = {friction_claim(all.lines),
                   flat_claim(all.lines),
                   {"e_n > e_nm for ρ_r > 1", yes_if(above), "at both tilts, with and without friction"}};
  return result;
}

double length_of_peak(const Line& line) {
  return line.x[static_cast<std::size_t>(std::max_element(line.centre.begin(), line.centre.end()) -
                                         line.centre.begin())];
}

Reproduction rods() {
  const Lengths all("rod");
  auto result = against(all.lines, all.names);
  result.picture.title = "rods with hemispherical ends, 2 m/s";
  result.picture.x_label = "length ratio ρ_r = L/r";
  result.picture.y_label = "restitution e_n, e_{nm}";
  const auto turn = [&](double friction) {
    return turning_point({.tilt = 45, .friction = friction, .speed = 2}, &Strike::length_ratio, 1, 50);
  };
  const SlimRod slim;
  result.checks.push_back({"e_n at ρ_r = 10⁶ against 1 − ⅔ C_H v", slim.found, slim.limit, 5e-4});
  const double smooth = turn(0), rough = turn(0.15), peak = length_of_peak(all.lines[1]);
  result.claims = {
      friction_claim(all.lines),
      rising_claim(all.lines),
      limit_claim(slim),
      {"at β = 20° e_nm rises to ρ_r = 2 and falls beyond", peak == 2 ? Verdict::yes : Verdict::partly,
       fmt::format("the largest of the points is at ρ_r = {} with μ = 0.15", peak)},
      {"at β = 45° e_nm < 0 for ρ_r > 5",
       std::abs(smooth - 5) < 0.05 && std::abs(rough - 5) < 0.05 ? Verdict::yes : Verdict::partly,
       fmt::format("for ρ_r > {:.3f} without friction, {:.2f} with μ = 0.15", smooth, rough)}};
  return result;
}

Reproduction tilts() {
  std::vector<Line> lines;
  std::vector<std::string> names;
  for (const double ratio : {10.0, 2.0, 0.0}) {
    lines.push_back(follow({.length_ratio = ratio}, &Strike::tilt, 90, 1));
    names.push_back(fmt::format("ρ_r = {}", ratio));
  }
  auto result = against(lines, names);
  result.picture.title = "rods at 5 m/s, μ = 0.15";
  result.picture.x_label = "tilt β [°]";
  result.picture.y_label = "restitution e_n, e_{nm}";
  const auto turn = [](double friction) {
    return turning_point({.friction = friction}, &Strike::tilt, 1, 89);
  };
  const double smooth = turn(0), usual = turn(0.15), rough = turn(0.7);
  const auto [least, most] = std::minmax_element(lines[2].tip.begin(), lines[2].tip.end());
  auto second = microbody({.tilt = 60});
  second.impacts = 2;
  const auto twice = impact::simulate(second, {});
  result.claims = {
      {"e_nm < 0 for ρ_r = 10 and β > 42°", std::abs(usual - 42) < 0.5 ? Verdict::yes : Verdict::partly,
       fmt::format("beyond {:.2f}° with μ = 0, {:.2f}° with 0.15, {:.2f}° with 0.7", smooth, usual, rough)},
      {"the restitution of a sphere does not depend on the tilt", yes_if(*most - *least < 1e-12),
       fmt::format("within {:.0e}", *most - *least)},
      {"a second impact follows, at the other end",
       yes_if(twice.impacts.size() == 2 && twice.impacts[1].tip == 1),
       fmt::format("at β = 60° after {:.2f} µs",
                   twice.impacts.size() == 2 ? 1e6 * twice.impacts[1].start : NAN)},
      repeated_claim()};
  return result;
}

}  // namespace

std::vector<Figure> cheng_shapes() {
  return {{"cheng-8", "Cheng, Brach & Dunn 2002, figure 8: dumbbells of any length", dumbbells},
          {"cheng-9", "Cheng, Brach & Dunn 2002, figure 9: rods of any length", rods},
          {"cheng-10", "Cheng, Brach & Dunn 2002, figure 10: rods of any tilt", tilts}};
}

}  // namespace mariotte::paper_figures
