#include "mariotte/report/table/ledger_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

std::string residual(const Display& display, double value, double scale) {
  const std::string note = scale > 0 ? fmt::format("(relative {:.1e})", std::abs(value) / scale) : "";
  return line("residual", fmt::format("{:.2e}", display.factor * value), note);
}

std::string ratio(const std::string& name, const std::optional<double>& value) {
  return value ? line(name, fmt::format("{:.10f}", *value)) : "";
}

double momentum_scale(const model::Chain& chain) {
  double scale = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    if (std::isfinite(chain.mass[i])) scale += chain.mass[i] * std::abs(chain.velocity[i]);
  return scale;
}

}  // namespace

std::string energy_table(const impact::EnergyLedger& ledger) {
  const auto display =
      display_for(std::vector{ledger.initial, ledger.final, ledger.stored, ledger.work}, "J");
  std::string text = fmt::format("\nEnergy [{}]\n", display.unit);
  text += line("before", shown(display, ledger.initial));
  if (ledger.work != 0) text += line("work done on the balls", shown(display, ledger.work));
  text += line("kinetic after", shown(display, ledger.final));
  if (ledger.stored != 0) text += line("stored in contacts", shown(display, ledger.stored));
  text += line("dissipated in contacts", shown(display, ledger.dissipated));
  text += residual(display, ledger.residual, ledger.initial + std::abs(ledger.work));
  text += ratio("T⁺/T⁻, given frame", ledger.ratio_lab);
  text += ratio("T⁺/T⁻, mass centre", ledger.ratio_centre);
  return text;
}

std::string momentum_table(const impact::MomentumLedger& ledger, const model::Chain& chain) {
  const auto display = display_for(std::vector{ledger.initial, ledger.final}, "N s");
  std::string text = fmt::format("\nMomentum [{}]\n", display.unit);
  text += line("before", shown(display, ledger.initial));
  text += line("after", shown(display, ledger.final));
  text += residual(display, ledger.residual, momentum_scale(chain));
  return text;
}

std::string momentum_table(const impact::NetworkImpact& impact) {
  return "\nMomentum\n" + line("relative residual", fmt::format("{:.2e}", impact.momentum_residual));
}

std::string flows_table(const std::vector<impact::FlowUse>& flows) {
  if (flows.empty()) return "";
  const auto row = [&](Index i) -> Row {
    const auto& use = flows[static_cast<std::size_t>(i)];
    return {use.name, fmt::format("{}", use.phases), fmt::format("{}", use.steps),
            fmt::format("{}", use.rhs)};
  };
  return "\nFlows\n" + columns({"flow", "phases", "steps", "right-hand sides"}, std::ssize(flows), row);
}

std::string skipped_table(const std::vector<impact::Skipped>& skipped) {
  if (skipped.empty()) return "";
  std::string text = "\nNot needed\n";
  for (const auto& one : skipped) text += fmt::format("  {}: {}\n", one.what, one.why);
  return text;
}

}  // namespace mariotte::report
