#include "law_curves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "law_families.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/pair/pair_restitution.hpp"

namespace mariotte::paper_figures {
namespace {

/// Force and indentation of a pair of reduced mass 1 while it is in contact, and what it loses.
struct Cycle {
  std::vector<double> indentation, force;
  double lost;
};

Cycle cycle(const ShownLaw& one) {
  constexpr double samples = 400;  // in a natural time
  Cycle cycle;
  const auto take = [&](const impact::Sample& now) {
    if (now.force[0] == 0) return now.natural_time / samples;
    cycle.indentation.push_back(-now.gap[0]);
    cycle.force.push_back(now.force[0]);
    return now.natural_time / samples;
  };
  const auto impact =
      impact::simulate({.mass = {2, 2}, .law = {one.law}, .gap = {0}, .velocity = {one.speed, 0}}, {},
                       {.samplings = {{.contacts = {0}, .take = take, .restart = [&] { cycle = {}; }}}});
  const double e = (impact.velocity[1] - impact.velocity[0]) / one.speed;
  cycle.lost = 0.5 * one.speed * one.speed * (1 - e * e);
  return cycle;
}

/// ∮ f dδ by the trapezoidal rule.
double area(const Cycle& cycle) {
  double sum = 0;
  for (std::size_t i = 1; i < cycle.force.size(); ++i)
    sum += 0.5 * (cycle.force[i] + cycle.force[i - 1]) * (cycle.indentation[i] - cycle.indentation[i - 1]);
  return sum;
}

/// The contact jumps from no force to its first, and from its last to none.
Curve force_curve(const ShownLaw& one, const LawUnits& unit, const Cycle& cycle) {
  Curve curve{.name = one.name + one.at};
  const auto add = [&](double indentation, double force) {
    curve.x.push_back(indentation / unit.length);
    curve.y.push_back(force / unit.force);
  };
  add(cycle.indentation.front(), 0);
  for (std::size_t i = 0; i < cycle.force.size(); ++i) add(cycle.indentation[i], cycle.force[i]);
  add(cycle.indentation.back(), 0);
  return curve;
}

Reproduction forces(const LawFamily& family) {
  Reproduction result;
  result.picture = {.title = family.title,
                    .x_label = family.unit.length_label,
                    .y_label = family.unit.force_label,
                    .commands = "set xzeroaxis lc rgb '#555555'\n",
                    .curves = {}};
  for (const auto& one : family.laws) {
    const auto found = cycle(one);
    result.picture.curves.push_back(force_curve(one, family.unit, found));
    const double energy = 0.5 * one.speed * one.speed;
    result.checks.push_back({fmt::format("area of the loop of {}{}, by m*v²/2", one.name, one.at),
                             area(found) / energy, found.lost / energy, 5e-3});
  }
  return result;
}

Curve restitution_curve(const ShownLaw& one, const LawFamily& family) {
  constexpr int points = 161;
  Curve curve{.name = one.name};
  for (int i = 0; i < points; ++i) {
    const double speed = family.slowest * std::pow(family.fastest / family.slowest, i / (points - 1.0));
    curve.x.push_back(speed / family.unit.speed);
    curve.y.push_back(impact::restitution({one.law, 1}, speed));
  }
  return curve;
}

Reproduction restitutions(const LawFamily& family) {
  Reproduction result;
  result.picture = {.title = family.title,
                    .x_label = family.unit.speed_label,
                    .y_label = "restitution e",
                    .commands = "set logscale x\nset format x '%g'\nset yrange [0:1.05]\n",
                    .curves = {}};
  for (const auto& one : family.laws) {
    auto& curves = result.picture.curves;
    if (!curves.empty() && curves.back().name == one.name) continue;
    curves.push_back(restitution_curve(one, family));
    const impact::Pair pair{one.law, 1};
    for (const double share : {0.5, 1.0, 5.0}) {
      const double speed = share * one.speed;
      if (const auto closed = impact::closed_restitution(pair, speed))
        result.checks.push_back({fmt::format("e of {} at {:.3g} of its speed", one.name, share),
                                 impact::restitution(pair, speed), *closed, 1e-9});
    }
  }
  return result;
}

}  // namespace

std::vector<Figure> law_curves() {
  std::vector<Figure> list;
  for (const auto& family : law_families()) {
    list.push_back({"law-forces-" + family.name, fmt::format("Contact laws: forces of {}", family.what),
                    [family] { return forces(family); }});
    if (family.fastest == 0) continue;
    list.push_back({"law-restitution-" + family.name,
                    fmt::format("Contact laws: restitution of {}", family.what),
                    [family] { return restitutions(family); }});
  }
  return list;
}

}  // namespace mariotte::paper_figures
