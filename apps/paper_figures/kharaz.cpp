#include "kharaz.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mariotte/impact/bodies/bodies_impact.hpp"

namespace mariotte::paper_figures {
namespace {

using model::TangentialLaw;

constexpr double radius = 2.5e-3, density = 4000, speed = 3.9, friction = 0.092;  // [Kharaz 2001]
constexpr double stiffness =
    4196771800.0;  // Hertz, alumina (380 GPa, 0.23) on glass (70 GPa, 0.25) [N/m^1.5]
constexpr double tangential = 5408444300.0;  // κ of the same [N/m^1.5]
constexpr double radian = std::numbers::pi / 180;
constexpr const char* digitised =
    "The points were digitised by a third party, the authors of the Lethe code. Friction is measured; moduli "
    "are "
    "handbook values. Below 5 degrees points are quotients of small numbers, and no law meets them.";

struct Rebound {
  double restitution, spin, angle;  ///< e_t, |ω| [rad/s], of the centre [°]
};

Rebound strike(double degrees, TangentialLaw law) {
  const double mass = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) * density,
               inertia = 0.4 * mass * radius * radius;
  const double along = speed * std::sin(radian * degrees), down = speed * std::cos(radian * degrees);
  model::Bodies bodies{.dimension = 2};
  bodies.body = {{.mass = mass,
                  .inertia = {inertia, inertia, inertia},
                  .spheres = {{{}, radius}},
                  .position = {0, radius, 0},
                  .velocity = {along, -down, 0}}};
  bodies.plane = {{.normal = {0, 1, 0}}};
  bodies.contact = {{.a = {0, -1},
                     .b = {0, 0},
                     .law = contact::Hertz{stiffness},
                     .tangential = {law, friction, tangential},
                     .share = 0,
                     .touching = true}};
  const auto impact = impact::simulate(bodies);
  const auto& after = impact.body[0];
  return {after.velocity.e1 / along, std::abs(after.spin.e3),
          std::atan2(after.velocity.e1, after.velocity.e2) / radian};
}

/// One quantity: what was measured, and what Mindlin's law gave an independent program at the same angles.
struct Quantity {
  double Rebound::*value;
  std::string label;
  double allowed;  ///< half a unit of the last digit that was given
  std::vector<double> angle, measured, computed;
};

Curve curve(const Quantity& quantity, TangentialLaw law, const char* name, Style style) {
  Curve curve{.name = name, .style = style};
  for (double angle = 0.5; angle <= 65; angle += 0.5) {
    curve.x.push_back(angle);
    curve.y.push_back(strike(angle, law).*quantity.value);
  }
  return curve;
}

/// Root of the mean square of measured less computed, from 9° on.
double scatter(const Quantity& quantity, TangentialLaw law) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < quantity.angle.size(); ++i) {
    if (quantity.angle[i] < 9) continue;
    const double apart = strike(quantity.angle[i], law).*quantity.value - quantity.measured[i];
    sum += apart * apart;
    ++count;
  }
  return std::sqrt(sum / count);
}

Reproduction make(const Quantity& quantity) {
  Reproduction result;
  result.picture = {
      .title = "alumina sphere of 5 mm on glass at 3.9 m/s",
      .x_label = "angle of incidence from the normal [°]",
      .y_label = quantity.label,
      .commands = "set xrange [0:65]\n",
      .curves = {curve(quantity, TangentialLaw::mindlin, "Mindlin", Style::line),
                 curve(quantity, TangentialLaw::rigid, "rigid", Style::dashed),
                 {.name = "measured", .style = Style::points, .x = quantity.angle, .y = quantity.measured}}};
  for (std::size_t i = 0; i < quantity.angle.size(); ++i)
    result.checks.push_back({fmt::format("Mindlin at {}°", quantity.angle[i]),
                             strike(quantity.angle[i], TangentialLaw::mindlin).*quantity.value,
                             quantity.computed[i], quantity.allowed});
  const double mindlin = scatter(quantity, TangentialLaw::mindlin),
               rigid = scatter(quantity, TangentialLaw::rigid);
  result.claims = {
      {"compliance along the plane brings the sphere nearer to what was measured than rigid stick",
       yes_if(mindlin < rigid),
       fmt::format("from 9° on off by {:.3g}, rigid by {:.3g} (root of the mean square)", mindlin, rigid)}};
  result.remark = digitised;
  return result;
}

Quantity restitution() {
  return {.value = &Rebound::restitution,
          .label = "tangential restitution e_t",
          .allowed = 5.1e-6,
          .angle = {1.84, 3.703, 9.496, 20.012, 30.127, 39.382, 49.694, 60.02},
          .measured = {0.79344, 0.74533, 0.67257, 0.59691, 0.68756, 0.77148, 0.84761, 0.90142},
          .computed = {0.87677, 0.87097, 0.72406, 0.6185, 0.68293, 0.77585, 0.84392, 0.89385}};
}
Quantity spin() {
  return {.value = &Rebound::spin,
          .label = "spin |ω| [rad/s]",
          .allowed = 5.1e-4,
          .angle = {6.143, 10.991, 21.251, 31.157, 39.143, 50.348, 60.328},
          .measured = {136.18, 265.69, 577.65, 612.88, 595.49, 453.21, 382.09},
          .computed = {65.472, 234.112, 536.154, 614.088, 556.551, 457.917, 355.236}};
}
Quantity rebound() {
  return {.value = &Rebound::angle,
          .label = "rebound angle of the centre [°]",
          .allowed = 5.1e-4,
          .angle = {0.016, 2.15, 4.096, 9.826, 20.567, 30.29, 39.535, 49.747, 60.208},
          .measured = {0.074, 1.733, 2.962, 6.518, 12.208, 21.67, 32.613, 45.125, 57.474},
          .computed = {0.014, 1.884, 3.559, 7.053, 13.082, 21.807, 32.675, 44.917, 57.383}};
}

Figure figure(const char* name, const char* what, Quantity (*quantity)()) {
  return {fmt::format("kharaz-{}", name),
          fmt::format("Kharaz, Gorham & Salman 2001: {} of an oblique impact", what),
          [quantity] { return make(quantity()); }};
}

}  // namespace

std::vector<Figure> kharaz_oblique() {
  return {figure("restitution", "tangential restitution", restitution), figure("spin", "spin", spin),
          figure("rebound", "rebound angle", rebound)};
}

}  // namespace mariotte::paper_figures
