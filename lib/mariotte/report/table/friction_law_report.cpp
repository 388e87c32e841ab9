#include "mariotte/report/table/friction_law_report.hpp"

#include <fmt/format.h>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using impact::FrictionOutcome;

double ratio(const impact::FirstImpact& impact, const FrictionOutcome& outcome) {
  return outcome.energy / impact.energy;
}

/// A column of numbers that share their unit.
template <class Number>
Display display_of(const impact::FirstImpact& impact, const char* unit, Number&& number) {
  std::vector<double> values;
  for (const auto& outcome : impact.outcomes) values.push_back(number(outcome));
  return display_for(values, unit);
}

std::string before(const impact::FirstImpact& impact) {
  const auto& v = impact.contact.velocity;
  const auto speed = display_for(std::vector{v.normal, v.tangential}, "m/s");
  const auto energy = display_for(std::vector{impact.energy}, "J");
  const auto line_of = [](const char* name, const Display& display, double value) {
    return line(name, shown(display, value) + " " + display.unit);
  };
  return "\nBefore\n" + line_of("closes with", speed, -v.normal) + line_of("slip", speed, v.tangential) +
         line_of("kinetic energy", energy, impact.energy);
}

std::string laws(const impact::FirstImpact& impact) {
  const auto impulse = display_of(impact, "N s", [](const auto& o) { return o.impulse.normal; });
  const auto speed = display_of(impact, "m/s", [](const auto& o) { return o.velocity.normal; });
  const auto loss = display_of(impact, "J", [](const auto& o) { return o.loss; });
  const auto row = [&](Index i) -> TableRow {
    const auto& o = impact.outcomes[static_cast<std::size_t>(i)];
    return {o.law,
            o.restitution ? fixed(*o.restitution, 6) : "",
            shown(impulse, o.impulse.normal),
            shown(impulse, o.impulse.tangential),
            shown(speed, o.velocity.normal),
            shown(speed, o.velocity.tangential),
            shown(loss, o.loss),
            fixed(ratio(impact, o), 6)};
  };
  return "\nLaws\n" + columns({"law", "e", "impulse [" + impulse.unit + "]",
                               "of friction [" + impulse.unit + "]", "opens with [" + speed.unit + "]",
                               "slip [" + speed.unit + "]", "loss [" + loss.unit + "]", "T⁺/T⁻"},
                              std::ssize(impact.outcomes), row);
}

Json velocities(const impact::PlaneMotion& body) {
  return {{"velocity", {body.velocity.e1, body.velocity.e2}}, {"spin", body.spin}};
}

}  // namespace

Json json(const FrictionLawReport& report) {
  const auto& [between, start, end, contact, energy, outcomes] = report.impact;
  Json result = {{"title", report.title}, {"model", "friction laws"}, {"between", between}};
  result["start"] = start;
  result["end"] = end;
  result["friction"] = contact.friction;
  result["response"] = {{contact.nn, contact.nt}, {contact.nt, contact.tt}};
  result["before"] = {
      {"gap_rate", contact.velocity.normal}, {"slip", contact.velocity.tangential}, {"energy", energy}};
  result["laws"] = list(outcomes, [&](const FrictionOutcome& o) {
    return Json{{"name", o.law},
                {"restitution", nullable(o.restitution)},
                {"normal_impulse", o.impulse.normal},
                {"tangential_impulse", o.impulse.tangential},
                {"gap_rate", o.velocity.normal},
                {"slip", o.velocity.tangential},
                {"loss", o.loss},
                {"energy", o.energy},
                {"energy_ratio", ratio(report.impact, o)},
                {"bodies", list(o.body, velocities)}};
  });
  result["provenance"] = provenance_json(report.scene_sha256);
  return result;
}

std::string table(const FrictionLawReport& report) {
  const auto& impact = report.impact;
  const auto time = display_for(std::vector{impact.start, impact.end}, "s");
  return heading(report.title.empty() ? "Impact laws with friction" : report.title) +
         fmt::format("{}–{} · closed from {} to {} {} · friction {:g}\n", impact.between[0],
                     impact.between[1], shown(time, impact.start), shown(time, impact.end), time.unit,
                     impact.contact.friction) +
         before(impact) + laws(impact);
}

}  // namespace mariotte::report
