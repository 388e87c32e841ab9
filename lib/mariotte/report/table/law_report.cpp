#include "mariotte/report/table/law_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/impact/impulses.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using impact::LawStatus;

/// Numbers of outcomes that have any.
bool is_real(const LawReport& report) {
  return report.outcome.status != LawStatus::complex;
}

/// "balls", "coordinates", "degrees of freedom".
std::string plural(const std::string& thing) {
  return thing == "degree of freedom" ? "degrees of freedom" : thing + "s";
}

std::string summary(const LawReport& report) {
  const auto& p = report.parameters;
  auto text =
      fmt::format("{} · {} {} · e = {:.10g} ({})", impact::name(report.outcome.status),
                  report.before.velocity.size(), plural(report.moving), p.energy_ratio,
                  p.frame == impact::EnergyFrame::given ? "given frame" : "relative to the mass centre");
  if (!report.simulated.empty()) text += ", direction and e from a simulation";
  if (report.velocity_error)
    text += fmt::format(", both from a table\ninterpolation moves velocities by at most {:.1e} m/s",
                        *report.velocity_error);
  if (const auto why = reason(report.outcome); !why.empty()) text += "\n" + why;
  return text + "\n";
}

std::string velocities(const LawReport& report) {
  const auto& before = report.before.velocity;
  const auto& after = report.outcome.velocity;
  auto all = before;
  all.insert(all.end(), after.begin(), after.end());
  const auto velocity = display_for(all, report.velocity_unit);
  TableRow header = {report.moving, "velocity before [" + velocity.unit + "]",
                     "after [" + velocity.unit + "]"};
  if (!report.simulated.empty()) header.push_back("simulated [" + velocity.unit + "]");
  const auto row = [&](Index i) -> TableRow {
    const auto k = static_cast<std::size_t>(i);
    TableRow cells = {fmt::format("{}", i + 1), shown(velocity, before[k]), shown(velocity, after[k])};
    if (!report.simulated.empty()) cells.push_back(shown(velocity, report.simulated[k]));
    return cells;
  };
  return (report.moving == "ball" ? "\nBalls\n" : "\nVelocities\n") + columns(header, std::ssize(after), row);
}

std::string contacts(const LawReport& report) {
  const auto& p = report.outcome.impulse;
  const auto rates = gap_rates(report.before, report.outcome.velocity);
  const auto impulse = display_for(p, "N s"), rate = display_for(rates, "m/s");
  const auto icr = impact::correlation_ratios(p);
  const auto row = [&](Index j) -> TableRow {
    const auto k = static_cast<std::size_t>(j);
    const bool ratio = k < icr.size() && icr[k];
    return {fmt::format("{}", j + 1), shown(impulse, p[k]), ratio ? fixed(*icr[k], 10) : "",
            shown(rate, rates[k])};
  };
  return "\nContacts\n" + columns({"contact", "impulse [" + impulse.unit + "]", "α to the next",
                                   "opens with [" + rate.unit + "]"},
                                  std::ssize(p), row);
}

std::string ratio(const char* name, const std::optional<double>& value) {
  return value ? line(name, fixed(*value, 10)) : "";
}

std::string energy_ratios(const LawReport& report) {
  return "\nEnergy\n" + ratio("T⁺/T⁻, given frame", report.outcome.ratio_lab) +
         ratio("T⁺/T⁻, mass centre", report.outcome.ratio_centre) +
         ratio("least possible e", report.outcome.least_energy_ratio);
}

/// The velocities that others are compared with: the simulated ones or, without, those of the law.
const std::vector<double>& reference(const LawReport& report) {
  return report.simulated.empty() ? report.outcome.velocity : report.simulated;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Shares in the energy are those of the dofs, if these are not coupled.
std::string dispersion(const LawReport& report, const impact::LawOutcome& outcome) {
  const auto& before = report.before;
  if (!model::is_diagonal(before.mass, std::ssize(before.velocity))) return "";
  return fixed(energy_dispersion(before, outcome.velocity), 6);
}

std::string rivals(const LawReport& report) {
  if (report.rivals.empty()) return "";
  auto laws = report.rivals;
  if (is_real(report)) laws.insert(laws.begin(), {"multiple-impact", report.outcome});
  if (!report.simulated.empty()) {
    auto p = parameters_of(report.before, report.outcome.impulse, report.simulated);
    laws.insert(
        laws.begin(),
        {"simulation",
         {.status = LawStatus::admissible, .velocity = report.simulated, .ratio_lab = p.energy_ratio}});
  }
  const auto row = [&](Index i) -> TableRow {
    const auto& [name, outcome] = laws[static_cast<std::size_t>(i)];
    return {name, impact::name(outcome.status), fixed(outcome.ratio_lab.value_or(1), 6),
            dispersion(report, outcome),
            reference(report).empty() ? "" : fixed(difference(outcome.velocity, reference(report)), 6)};
  };
  return fmt::format("\nLaws, others with restitution {:g}\n", report.restitution) +
         columns({"law", "outcome", "T⁺/T⁻", "dispersion", "velocities differ by [m/s]"}, std::ssize(laws),
                 row);
}

Json rival(const impact::NamedOutcome& rival) {
  const auto& outcome = rival.outcome;
  Json result = {{"name", rival.name}, {"status", impact::name(outcome.status)}};
  if (const auto why = reason(outcome); !why.empty()) result["reason"] = why;
  result["velocity"] = outcome.velocity;
  result["impulse"] = outcome.impulse;
  result["ratio_lab"] = nullable(outcome.ratio_lab);
  result["ratio_centre"] = nullable(outcome.ratio_centre);
  return result;
}

Json energy(const LawReport& report) {
  Json energy = {{"initial", kinetic_energy(report.before, report.before.velocity)}, {"final", nullptr}};
  if (is_real(report)) energy["final"] = kinetic_energy(report.before, report.outcome.velocity);
  energy["ratio"] = report.parameters.energy_ratio;
  energy["frame"] = frame_name(report.parameters.frame);
  energy["ratio_lab"] = nullable(report.outcome.ratio_lab);
  energy["ratio_centre"] = nullable(report.outcome.ratio_centre);
  energy["least_ratio"] = nullable(report.outcome.least_energy_ratio);
  return energy;
}

}  // namespace

const char* frame_name(impact::EnergyFrame frame) {
  return frame == impact::EnergyFrame::given ? "given" : "mass-centre";
}

Json json(const LawReport& report) {
  const auto& outcome = report.outcome;
  Json result = {{"status", impact::name(outcome.status)}, {"title", report.title}, {"model", "law"}};
  if (const auto why = reason(outcome); !why.empty()) result["reason"] = why;
  result["final"] = {{"velocity", outcome.velocity}};
  result["contacts"] = list(outcome.impulse, [](double p) { return Json{{"impulse", p}}; });
  result["icr"] = list(impact::correlation_ratios(report.parameters.direction), nullable);
  result["impulse_direction"] = impact::direction(report.parameters.direction);
  result["energy"] = energy(report);
  if (!report.simulated.empty()) result["simulated"] = {{"velocity", report.simulated}};
  if (report.velocity_error) result["interpolation"] = {{"velocity_error", *report.velocity_error}};
  if (!report.rivals.empty()) {
    result["restitution"] = report.restitution;
    result["rivals"] = list(report.rivals, rival);
  }
  result["provenance"] = provenance_json(report.scene_sha256);
  return result;
}

std::string table(const LawReport& report) {
  std::string text = heading(report.title.empty() ? "Multiple-impact law" : report.title) + summary(report);
  if (is_real(report)) text += velocities(report) + contacts(report);
  return text + energy_ratios(report) + rivals(report);
}

}  // namespace mariotte::report
