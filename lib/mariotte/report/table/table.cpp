#include "mariotte/report/table/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/reason.hpp"
#include "mariotte/report/table/background.hpp"
#include "mariotte/report/table/balance_tables.hpp"
#include "mariotte/report/table/network_table.hpp"
#include "mariotte/report/table/pair_speeds.hpp"
#include "mariotte/report/table/quantity_table.hpp"

namespace mariotte::report {
namespace {

Display time_display(const impact::ContactImpact& impact) {
  return display_for(std::vector{impact.time}, "s");
}

std::string summary(const impact::ContactImpact& impact, const std::string& size, const scene::Scene& scene,
                    const Display& time) {
  std::string text =
      fmt::format("{} at {} {} · {} · accuracy {:.3g} requested", ending_name(impact.ending, scene),
                  shown(time, impact.time), time.unit, size, impact.requested_accuracy);
  text += estimate(impact.estimated_accuracy);
  if (const auto why = reason(impact.ending, impact.message, scene); !why.empty()) text += "\n" + why;
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  if (impact.ending == hybrid::Ending::separated && chain && falls_back(*chain))
    text += "\ngravity brings balls back to the wall; run.until follows them on";
  for (const double one : impact.bound_frequency)
    text += fmt::format("\nheld together by adhesion, rings on at {:.6g} Hz", one);
  if (impact.ending == hybrid::Ending::bound)
    text += "\nall numbers are those of this instant; run.until follows the motion on";
  return text + "\n";
}

std::string events(const impact::ContactImpact& impact, const Display& time) {
  if (impact.events.empty()) return "\nEvents: none\n";
  const bool yields = has_branches(impact.events);
  const auto row = [&](Index i) -> TableRow {
    const auto& event = impact.events[static_cast<std::size_t>(i)];
    TableRow cells = {shown(time, event.time), numbers(event.close), numbers(event.open)};
    if (yields) cells.insert(cells.end(), {numbers(event.yield), numbers(event.unload)});
    return cells;
  };
  TableRow header = {"time [" + time.unit + "]", "contacts close", "contacts open"};
  if (yields) header.insert(header.end(), {"yield", "unload"});
  return "\nEvents\n" + columns(header, std::ssize(impact.events), row);
}

std::string balls(const impact::ChainImpact& impact, const model::Chain& chain) {
  auto all = chain.velocity;
  all.insert(all.end(), impact.velocity.begin(), impact.velocity.end());
  const auto velocity = display_for(all, "m/s");
  const auto row = [&](Index i) -> TableRow {
    const auto k = static_cast<std::size_t>(i);
    return {std::isinf(chain.mass[k]) ? "wall" : fmt::format("{}", i + 1), shown(velocity, chain.velocity[k]),
            shown(velocity, impact.velocity[k])};
  };
  return "\nBalls\n" +
         columns({"ball", "velocity before [" + velocity.unit + "]", "after [" + velocity.unit + "]"},
                 std::ssize(impact.velocity), row);
}

/// The first one, and how many more.
std::string periods(const impact::ContactHistory& contact, const Display& time) {
  if (contact.periods.empty()) return "never";
  const auto& [start, end] = contact.periods.front();
  const auto more = contact.periods.size() - 1;
  return fmt::format("{:.5g}–{}{}", time.factor * start, end ? rounded(time.factor * *end, 5) : "",
                     more > 0 ? fmt::format(" +{}", more) : "");
}

/// `name` tells what each contact joins, where that is not clear.
template <class Impact>
std::string contacts(const Impact& impact, const Display& time, const std::vector<std::string>& name) {
  const NumberColumn numbers[] = {number_column("impulse", "contacts[].impulse", impact),
                                  number_column("peak force", "contacts[].peak_force", impact, 2),
                                  number_column("indentation", "contacts[].peak_indentation", impact, 2),
                                  number_column("meets", "contacts[].approach_speed", impact, 2),
                                  number_column("dissip.", "contacts[].dissipated", impact, 2)};
  const auto row = [&](Index j) {
    TableRow cells = {fmt::format("{}", j + 1)};
    if (!name.empty()) cells.push_back(name[j]);
    for (const auto& column : numbers) cells.push_back(column.cell(j));
    cells.push_back(periods(impact.contacts[j], time));
    return cells;
  };
  TableRow header = {"contact"};
  if (!name.empty()) header.push_back("balls");
  for (const auto& column : numbers) header.push_back(column.head());
  header.push_back("closed [" + time.unit + "]");
  return "\nContacts\n" + columns(header, std::ssize(impact.contacts), row);
}

std::string ratios(const impact::ContactImpact& impact) {
  if (impact.icr.empty()) return "";
  const auto row = [&](Index j) -> TableRow {
    const auto& ratio = impact.icr[static_cast<std::size_t>(j)];
    return {fmt::format("{}/{}", j + 1, j + 2), ratio ? fixed(*ratio, 10) : "undefined"};
  };
  return "\nImpulse correlation ratios\n" + columns({"contacts", "α"}, std::ssize(impact.icr), row);
}

/// Of the only contact.
std::string pair(const impact::ContactImpact& impact) {
  if (impact.contacts.size() != 1) return "";
  return pair_table(impact.contacts[0].meeting, impact.contacts[0].periods.size());
}

std::string head(const impact::ContactImpact& impact, const scene::Scene& scene, const char* otherwise,
                 const std::string& size) {
  return heading(scene.title.empty() ? otherwise : scene.title) +
         summary(impact, size, scene, time_display(impact)) + events(impact, time_display(impact));
}

}  // namespace

std::string size_of(const model::Chain& chain) {
  const auto walls =
      std::count_if(chain.mass.begin(), chain.mass.end(), [](double mass) { return std::isinf(mass); });
  const auto balls = counted(std::ssize(chain.mass) - walls, "ball");
  return walls > 0 ? balls + " and " + counted(walls, "wall") : balls;
}

std::string table(const impact::ChainImpact& impact, const scene::Scene& scene, Detail detail) {
  const auto& chain = std::get<model::Chain>(scene.model);
  return head(impact, scene, "Chain of balls", size_of(chain)) + balls(impact, chain) + pair(impact) +
         contacts(impact, time_display(impact), {}) + ratios(impact) + energy_table(impact) +
         momentum_table(impact, chain) + (detail == Detail::full ? background(impact, "contact") : "");
}

std::string table(const impact::NetworkImpact& impact, const scene::Scene& scene, Detail detail) {
  const auto& network = std::get<model::Network>(scene.model);
  return head(impact, scene, "Contact network", size_of(network)) + motion_table(network, impact.velocity) +
         pair(impact) + contacts(impact, time_display(impact), contact_names(network)) +
         direction_table(impact) + energy_table(impact) + momentum_table(impact) + neglected_table(impact) +
         (detail == Detail::full ? background(impact, "contact") : "");
}

}  // namespace mariotte::report
