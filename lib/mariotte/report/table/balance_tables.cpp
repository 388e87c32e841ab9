#include "mariotte/report/table/balance_tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/table/quantity_table.hpp"

namespace mariotte::report {
namespace {

std::string ratio(const std::string& name, const std::optional<double>& value) {
  return value ? line(name, fixed(*value, 10)) : "";
}

double momentum_scale(const model::Chain& chain) {
  double scale = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    if (std::isfinite(chain.mass[i])) scale += chain.mass[i] * std::abs(chain.velocity[i]);
  return scale;
}

constexpr BalanceLine contact_energies[] = {{"before", "energy.initial"},
                                            {"work done on the balls", "energy.work", true},
                                            {"kinetic after", "energy.final"},
                                            {"stored in contacts", "energy.stored", true},
                                            {"dissipated in contacts", "energy.dissipated"},
                                            {"of it by yielding", "energy.plastic_work", true},
                                            {"of it by adhesion", "energy.adhesion_loss", true}};
constexpr BalanceLine momenta[] = {{"before", "momentum.initial"}, {"after", "momentum.final"}};

template <class Impact>
std::string energy(const Impact& impact) {
  const auto& e = impact.energy;
  return balance_table("Energy", impact, contact_energies, "energy.residual", e.initial + std::abs(e.work)) +
         ratio("T⁺/T⁻, given frame", e.ratio_lab) + ratio("T⁺/T⁻, mass centre", e.ratio_centre);
}

}  // namespace

std::string estimate(const std::optional<double>& accuracy) {
  return accuracy && std::isfinite(*accuracy) ? fmt::format(", {:.1e} estimated", *accuracy) : "";
}

std::string residual_line(const Display& display, double residual, double scale) {
  const std::string note = scale > 0 ? fmt::format("(relative {:.1e})", std::abs(residual) / scale) : "";
  return line("residual", fmt::format("{:.2e}", display.factor * residual), note);
}

std::string energy_table(const impact::ChainImpact& impact) {
  return energy(impact);
}

std::string energy_table(const impact::NetworkImpact& impact) {
  return energy(impact);
}

std::string momentum_table(const impact::ChainImpact& impact, const model::Chain& chain) {
  return balance_table("Momentum", impact, momenta, "momentum.residual", momentum_scale(chain));
}

std::string momentum_table(const impact::NetworkImpact& impact) {
  return "\nMomentum\n" + line("relative residual", fmt::format("{:.2e}", impact.momentum_residual));
}

}  // namespace mariotte::report
