#include "mariotte/report/csv/csv.hpp"

#include <fmt/format.h>

#include <numeric>

#include "mariotte/impact/quantities/description.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

void append_from_one(const std::vector<Index>& positions, std::string& text) {
  text += ',';
  for (std::size_t k = 0; k < positions.size(); ++k)
    (text += k > 0 ? " " : "") += std::to_string(positions[k] + 1);
}

std::string names(std::string_view symbol, const std::vector<Index>& places, std::string_view unit) {
  std::string text;
  for (const Index place : places) text += fmt::format(",{}{} [{}]", symbol, place + 1, unit);
  return text;
}

/// Of velocities; balls that have several of them name their axes.
std::string velocity_names(std::string_view symbol, const std::vector<Index>& places, std::string_view unit,
                           Index dimension) {
  if (dimension == 1) return names(symbol, places, unit);
  std::string text;
  for (const Index place : places)
    text += fmt::format(",{}{}{} [{}]", symbol, place / dimension + 1, "xyz"[place % dimension], unit);
  return text;
}

std::vector<Index> all(std::size_t count) {
  std::vector<Index> places(count);
  std::iota(places.begin(), places.end(), 0);
  return places;
}

void append(std::string& text, const std::vector<double>& values) {
  for (const double value : values) append_exact(value, text += ',');
}

}  // namespace

std::string events_csv(const impact::ContactImpact& impact) {
  const bool yields = has_branches(impact.events);
  std::string text = yields ? "time [s],open,close,yield,unload\n" : "time [s],open,close\n";
  for (const auto& event : impact.events) {
    append_exact(event.time, text);
    for (const auto* contacts : {&event.open, &event.close}) append_from_one(*contacts, text);
    if (yields)
      for (const auto* contacts : {&event.yield, &event.unload}) append_from_one(*contacts, text);
    text += '\n';
  }
  return text;
}

std::string trace_header(const std::vector<Index>& balls, const std::vector<Index>& contacts,
                         const std::string& velocity_unit, Index dimension) {
  const auto& [time, velocity, gap, force] = impact::sampled;
  return fmt::format("{} [{}]", time.symbol, time.unit) +
         velocity_names(velocity.symbol, balls, velocity_unit.empty() ? "SI" : velocity_unit, dimension) +
         names(gap.symbol, contacts, gap.unit) + names(force.symbol, contacts, force.unit) + "\n";
}

std::string trace_row(double time, const std::vector<double>& velocity, const std::vector<double>& gap,
                      const std::vector<double>& force) {
  std::string text = exact(time);
  append(text, velocity);
  append(text, gap);
  append(text, force);
  return text + "\n";
}

std::string trace_csv(const impact::ContactImpact& impact) {
  const auto& trace = impact.trace;
  std::string text = trace_header(all(impact.velocity.size()), all(impact.contacts.size()),
                                  trace.velocity_unit, trace.dimension);
  for (std::size_t row = 0; row < trace.time.size(); ++row)
    text += trace_row(trace.time[row], trace.velocity[row], trace.gap[row], trace.force[row]);
  return text;
}

}  // namespace mariotte::report
