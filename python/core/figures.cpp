// What figures of a run show, and where their words go; matplotlib draws them.
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "impact.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/label_places.hpp"
#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/report/figure/window.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::python {
namespace {

/// Friction along e2 and e3 of each tip, a row per sample; no columns for others.
py::array friction(const scene::Impact& traced) {
  const auto* const body = std::get_if<impact::MicrobodyImpact>(&traced);
  if (!body) return owned(std::vector<double>(), {0, 0});
  const auto& rows = body->trace.friction;
  std::vector<double> all;
  for (const auto& row : rows)
    for (const auto& force : row) all.insert(all.end(), {force.e2, force.e3});
  const py::ssize_t columns = rows.empty() ? 0 : 2 * std::ssize(rows.front());
  return owned(std::move(all), {std::ssize(rows), columns});
}

/// Where forces can be seen, what moves, and in which unit.
struct Seen {
  report::Action action;
  std::string moving, unit;
};

Seen seen(const scene::Impact& traced) {
  return std::visit(
      Overload{[](const impact::ContactImpact& one) {
                 return Seen{report::action_of(one.trace), one.trace.moving, one.trace.velocity_unit};
               },
               [](const auto& one) {
                 return Seen{report::action_of(one.trace), "body", "m/s"};
               }},
      traced);
}

py::list pairs(const std::vector<report::Window>& windows) {
  py::list all;
  for (const auto& [start, end] : windows) all.append(py::make_tuple(start, end));
  return all;
}

/// Friction of tips, start and end of every panel and of those of forces [s], what the axis of the latter
/// says beside its name, whether images are logarithmic, what moves, and its unit.
py::tuple picture(const Impact& impact) {
  std::optional<scene::Impact> traced;
  {
    const py::gil_scoped_release unlocked;
    traced = simulate(impact.box(), impact.options(), {.trace = true});
  }
  const auto& figure = impact.box().scene.figure;
  const auto [action, moving, unit] = seen(*traced);
  const auto axis = report::time_axis(action, {}, figure), of_forces = report::axis_of_forces(axis);
  return py::make_tuple(friction(*traced), pairs(axis.windows), pairs(of_forces.windows), of_forces.note,
                        figure.logarithmic, moving, unit, figure.balls, figure.contacts);
}

/// A row per sample, three numbers for each of `count`.
py::array rows_of(const std::vector<std::vector<Vector3>>& rows, Index count) {
  std::vector<double> numbers;
  for (const auto& row : rows)
    for (const auto& one : row) numbers.insert(numbers.end(), {one.e1, one.e2, one.e3});
  return owned(std::move(numbers), {std::ssize(rows), count, Index{3}});
}

/// Of bodies: times of the samples, spins of the bodies, and friction of the contacts of the result.
py::tuple turning(const Impact& impact) {
  if (!std::holds_alternative<model::Bodies>(impact.box().scene.model))
    throw InvalidParameter("bodies alone have friction and spins over time");
  std::optional<scene::Impact> traced;
  {
    const py::gil_scoped_release unlocked;
    traced = simulate(impact.box(), impact.options(), {.trace = true});
  }
  const auto& bodies = std::get<impact::BodiesImpact>(*traced);
  std::vector<std::vector<Vector3>> spins, friction;
  for (const auto& row : bodies.trace.body) {
    auto& spin = spins.emplace_back();
    for (const auto& body : row) spin.push_back(body.spin);
  }
  for (const auto& row : bodies.trace.friction) {
    auto& forces = friction.emplace_back();
    for (const auto& contact : bodies.contacts)
      forces.push_back(row[static_cast<std::size_t>(contact.contact)]);
  }
  auto time = bodies.trace.time;
  const auto count = std::ssize(time);
  return py::make_tuple(owned(std::move(time), {count}), rows_of(spins, std::ssize(bodies.body)),
                        rows_of(friction, std::ssize(bodies.contacts)));
}

using Rectangle = std::tuple<double, double, double, double>;

report::Box box(const Rectangle& one) {
  const auto& [x, y, width, height] = one;
  return {x, y, width, height};
}

Rectangle free_place(const Rectangle& wanted, const std::vector<Rectangle>& taken) {
  std::vector<report::Box> boxes;
  for (const auto& one : taken) boxes.push_back(box(one));
  const auto place = report::free_place(box(wanted), boxes);
  return {place.x, place.y, place.width, place.height};
}

std::pair<double, std::string> display(const std::vector<double>& values, const std::string& unit) {
  const auto shown = report::display_for(values, unit);
  return {shown.factor, shown.unit};
}

}  // namespace

void add_figures(py::module_& module) {
  module.def("picture", &picture, py::arg("impact"));
  module.def("turning", &turning, py::arg("impact"));
  module.def("spread", &report::spread, py::arg("wanted"), py::arg("space"));
  module.def("free_place", &free_place, py::arg("wanted"), py::arg("taken"));
  module.def("rows_of_words", &report::rows_of_words, py::arg("at"), py::arg("width"), py::arg("rows"));
  module.def("display", &display, py::arg("values"), py::arg("unit"));
  module.def("with_unit", &report::with_unit, py::arg("name"), py::arg("unit"));
}

}  // namespace mariotte::python
