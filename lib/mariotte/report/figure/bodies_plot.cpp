#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/plot.hpp"

namespace mariotte::report {
namespace {

/// Contacts that carry force from now on; those that were touching at rest are among them if they are
/// pressed.
std::vector<Index> closing(const impact::BodiesEvents& event) {
  auto all = event.of(model::BodyEvent::close);
  const auto& part = event.of(model::BodyEvent::part);
  const auto& touch = event.of(model::BodyEvent::touch);
  std::copy_if(touch.begin(), touch.end(), std::back_inserter(all),
               [&](Index j) { return std::find(part.begin(), part.end(), j) == part.end(); });
  std::sort(all.begin(), all.end());
  return all;
}

/// Of all that may touch, what belongs to contacts that have closed, in the order of the result.
template <class Value>
std::vector<Value> of_closed(const impact::BodiesImpact& impact, const std::vector<Value>& all) {
  std::vector<Value> some;
  for (const auto& one : impact.contacts)
    if (!one.periods.empty()) some.push_back(all[static_cast<std::size_t>(one.contact)]);
  return some;
}

/// "f_{2} (floor–rod.1)", with the number that events have; `index` stands before it.
std::vector<std::string> numbered(const impact::BodiesImpact& impact, const CurveNames& names,
                                  const char* index) {
  std::vector<std::string> all;
  if (names.contacts.empty()) return all;
  for (std::size_t j = 0; j < impact.contacts.size(); ++j)
    if (const auto& one = impact.contacts[j]; !one.periods.empty())
      all.push_back(fmt::format("f_{{{}{}}} ({})", index, j + 1,
                                plain(names.contacts[static_cast<std::size_t>(one.contact)])));
  return all;
}

/// Of those that have closed, from 1.
std::vector<Index> numbers_of_closed(const impact::BodiesImpact& impact) {
  std::vector<Index> all;
  for (std::size_t j = 0; j < impact.contacts.size(); ++j)
    if (!impact.contacts[j].periods.empty()) all.push_back(static_cast<Index>(j) + 1);
  return all;
}

/// What has a direction: a vector per row and owner, which are contacts or bodies.
struct Vectors {
  std::string file, quantity, along, unit;
  Names names;
  std::vector<std::string> owner;
  std::vector<std::vector<Vector3>> rows;
  std::vector<Index> number = {};
};

double largest(const Vectors& all) {
  double most = 0;
  for (const auto& row : all.rows)
    for (const auto& vector : row) most = std::max(most, norm(vector));
  return most;
}

/// Appends a curve, unless it is zero throughout, or looks so in a figure that shows `most`.
template <class Read>
void add(const Vectors& all, std::size_t owner, const std::string& name, const Read& read, double most,
         Series& series) {
  constexpr double seen = 2e-3;
  std::vector<double> values;
  for (const auto& row : all.rows) values.push_back(read(row[owner]));
  const auto is_flat = [&](double value) { return std::abs(value) <= seen * most; };
  if (std::all_of(values.begin(), values.end(), is_flat)) return;
  series.name.push_back(name);
  series.rows.resize(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) series.rows[k].push_back(values[k]);
}

/// A curve per component of each owner; a spin in the plane has one, which needs no name.
Series components(const Vectors& all, bool one_alone) {
  constexpr std::array axis = {" x", " y", " z"};
  Series series{all.file, all.quantity, all.along, all.unit, all.names, {}, {}};
  const double most = largest(all);
  for (std::size_t i = 0; i < all.owner.size(); ++i)
    for (std::size_t k = 0; k < axis.size(); ++k)
      add(
          all, i, all.owner[i] + (one_alone ? "" : axis[k]),
          [&](const Vector3& vector) { return component(vector, k); }, most, series);
  return series;
}

/// A curve or a line of an image per owner.
Series magnitudes(const Vectors& all) {
  Series series{all.file,  "magnitude of " + all.quantity, all.along, all.unit, all.names, all.owner, {},
                all.number};
  for (const auto& row : all.rows) {
    auto& values = series.rows.emplace_back();
    for (const auto& vector : row) values.push_back(norm(vector));
  }
  return series;
}

Series series(const Vectors& all, bool one_alone = false) {
  auto few = components(all, one_alone);
  return few.name.size() > most_curves ? magnitudes(all) : few;
}

Series friction(const impact::BodiesImpact& impact, const CurveNames& names) {
  Vectors all{"friction", "friction f_t",           "contact j",
              "N",        Names::at_peak,           numbered(impact, names, "t,"),
              {},         numbers_of_closed(impact)};
  for (const auto& row : impact.trace.friction) all.rows.push_back(of_closed(impact, row));
  return series(all);
}

Series spins(const impact::BodiesImpact& impact, const CurveNames& names) {
  Vectors all{"spins", "spin ω", "body i", "rad/s", Names::at_end, names.bodies, {}};
  for (const auto& row : impact.trace.body) {
    auto& spin = all.rows.emplace_back();
    for (const auto& body : row) spin.push_back(body.spin);
  }
  return series(all, impact.dimension == 2);
}

}  // namespace

RunPlot plot(const impact::BodiesImpact& impact, const std::string& title, const CurveNames& names,
             const scene::Figure& figure) {
  impact::ContactImpact same;
  same.trace = impact::contact_trace(impact, /*closed_alone=*/true);
  for (const auto& event : impact.events) {
    impact::Event marks{.time = event.time};
    marks.open = event.of(model::BodyEvent::open);
    marks.close = closing(event);
    if (!marks.open.empty() || !marks.close.empty()) same.events.push_back(std::move(marks));
  }
  auto of_result_alone = names;
  of_result_alone.contacts = numbered(impact, names, "");
  of_result_alone.numbers = numbers_of_closed(impact);
  return plot(same, title, of_result_alone, figure, {friction(impact, names), spins(impact, names)});
}

Action action_of(const impact::BodiesTrace& trace) {
  return action_of(impact::Trace{.time = trace.time, .velocity = {}, .gap = trace.gap, .force = trace.force});
}

}  // namespace mariotte::report
