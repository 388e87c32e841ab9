// For authors of rigid-body codes: take impulse ratios from a compliant simulation once, then apply them as
// an impact law in one step, with other losses, other speeds, and in generalised coordinates.
#include <cstdio>

#include "mariotte/mariotte.hpp"

namespace {

using namespace mariotte;

void show(const char* what, const impact::LawOutcome& outcome) {
  std::printf("%-22s %-21s", what, impact::name(outcome.status));
  for (const double velocity : outcome.velocity) std::printf("%12.8f", velocity);
  std::printf("\n");
}

}  // namespace

int main() {
  // 1. Physics: three steel-like balls, the second contact damped.
  const model::Chain chain{.mass = {1, 1, 1},
                           .law = {contact::Hertz{1}, contact::Viscoelastic{.stiffness = 1, .damping = 0.1}},
                           .gap = {0, 0},
                           .velocity = {1, 0, 0}};
  const auto run = impact::simulate(chain, {.accuracy = 1e-12});
  auto law = impact::parameters_of(run, impact::EnergyFrame::mass_centre);
  std::printf("ratio %.8f, energy ratio relative to the mass centre %.8f\n", *run.icr[0], law.energy_ratio);

  // 2. The law gives the simulated velocities back, and answers for others.
  const auto balls = [](double first) { return impact::chain_configuration({1, 1, 1}, {first, 0, 0}); };
  show("simulated parameters", impact::multiple_impact(balls(1), law));
  show("twice as fast", impact::multiple_impact(balls(2), law));
  law.energy_ratio = 1;
  show("without loss", impact::multiple_impact(balls(1), law));

  // 3. Impossible demands are answers, too; never a silent number.
  law.energy_ratio = 0.1;
  const auto impossible = impact::multiple_impact(balls(1), law);
  show("nearly plastic", impossible);
  std::printf("%s\n", impact::reason(impossible).c_str());

  // 4. Any mass matrix M and contact directions G (gap rates = G v): a rod of mass 3 and inertia 1 about its
  //    centre falls on both ends, 1 to the left and to the right; v = (height rate, spin).
  const impact::Configuration rod{
      .mass = {3, 0, 0, 1}, .contact = {{{0, 1}, {1, -1}}, {{0, 1}, {1, 1}}}, .velocity = {-1, 0.2}};
  show("rod on two supports", impact::multiple_impact(rod, {.direction = {1.05, 0.95}, .energy_ratio = 0.7}));
}
