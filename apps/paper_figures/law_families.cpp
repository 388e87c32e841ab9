#include "law_families.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/impact/pair/pair_restitution.hpp"

namespace mariotte::paper_figures {
namespace {

using contact::Law;
using std::numbers::pi;

/// The law with the damping with which e is 0.6 at unit speed.
ShownLaw damped(const char* name, const std::function<Law(double)>& law) {
  double low = 0, high = 4;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (impact::restitution({law(middle), 1}, 1) > 0.6 ? low : high) = middle;
  }
  return {name, "", law(low), 1};
}

/// Points of a sponge: its cells fold, and push once they are closed.
contact::Law sponge() {
  return std::make_shared<contact::Tabulated>(std::vector<contact::LawPoint>{
      {0.2, 0.08}, {0.5, 0.16}, {0.9, 0.22}, {1.2, 0.35}, {1.4, 0.7}, {1.5, 1.3}});
}

LawFamily elastic_laws() {
  return {.name = "elastic",
          .what = "elastic laws",
          .title = "elastic laws",
          .laws = {{"linear", "", contact::Linear{1}, 1},
                   {"hertz", "", contact::Hertz{1}, 1},
                   {"tabulated", "", sponge(), 1}},
          .unit = {1, 1, 1, "indentation δ / L, kL^{n+1} = m*v_1^2", "force f / kL^n",
                   "speed of approach v / v_1"},
          .slowest = 0,
          .fastest = 0};
}

LawFamily damped_laws() {
  return {.name = "damped",
          .what = "laws with a damper",
          .title = "laws with a damper, e = 0.6 at v₁",
          .laws = {damped("kelvin-voigt",
                          [](double c) {
                            return contact::Viscoelastic{.stiffness = 1, .damping = c, .exponent = 1};
                          }),
                   damped("kuwabara-kono",
                          [](double c) { return contact::Viscoelastic{.stiffness = 1, .damping = c}; }),
                   damped("hunt-crossley",
                          [](double a) { return std::make_shared<contact::HuntCrossley>(1, a); }),
                   damped("tsuji", [](double c) { return std::make_shared<contact::Tsuji>(1, c); })},
          .unit = {1, 1, 1, "indentation δ / L, kL^{n+1} = m*v_1^2", "force f / kL^n",
                   "speed of approach v / v_1"},
          .slowest = 1e-2,
          .fastest = 1e2};
}

/// Balls of E* = R = 1 that yield at v_y = 0.05; k₁ is such that both laws of plastic contacts are about as
/// stiff.
LawFamily plastic_laws() {
  constexpr double yield_speed = 0.05;
  const double pressure = std::pow(yield_speed * std::pow(2 / pi, 2) * std::sqrt(15 / (8 * pi)), 0.4);
  const double length = std::pow(pi * pressure / 2, 2), force = pi * pressure * length;
  const auto thornton = contact::state(contact::Thornton(1, 1, pressure));
  return {.name = "plastic",
          .what = "laws that yield",
          .title = "laws that yield",
          .laws = {{"walton-braun", ", 10 v_y",
                    contact::state(contact::WaltonBraun(pi * pressure, 4 * pi * pressure)), 10 * yield_speed},
                   {"thornton", ", 10 v_y", thornton, 10 * yield_speed},
                   {"thornton", ", 3 v_y", thornton, 3 * yield_speed}},
          .unit = {length, force, yield_speed, "indentation δ / δ_y", "force f / πp_yRδ_y",
                   "speed of approach v / v_y"},
          .slowest = 0.1 * yield_speed,
          .fastest = 1e3 * yield_speed};
}

/// Balls of E* = R = w = 1; a JKR contact captures them below v_c.
LawFamily adhesive_laws() {
  const double capture = std::sqrt(2 * 7.0922);
  const double length = std::cbrt(pi * pi);
  return {.name = "adhesive",
          .what = "laws that adhere",
          .title = "laws that adhere",
          .laws = {{"jkr", ", 1.5 v_c", contact::state(contact::Jkr(1, 1, 1, 0)), 1.5 * capture},
                   {"dmt", ", 1.5 v_c", contact::state(contact::Dmt(1, 1, 1, 0)), 1.5 * capture},
                   {"thornton-ning", ", 1.5 v_c", contact::state(contact::ThorntonNing(1, 1, 1.2, 1)),
                    1.5 * capture}},
          .unit = {length, pi, capture, "indentation δ / (π^2w^2R/E*^2)^{1/3}", "force f / πwR",
                   "speed of approach v / v_c"},
          .slowest = 0.1 * capture,
          .fastest = 100 * capture};
}

}  // namespace

std::vector<LawFamily> law_families() {
  return {elastic_laws(), damped_laws(), plastic_laws(), adhesive_laws()};
}

}  // namespace mariotte::paper_figures
