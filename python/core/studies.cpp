// Studies of scenes: capture velocities, curves of restitution, natural modes and slopes.
#include <pybind11/stl.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interruption.hpp"
#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/report/json/sensitivity_json.hpp"
#include "mariotte/report/table/modes_report.hpp"
#include "mariotte/report/warnings.hpp"
#include "mariotte/study/capture.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/pair_choice.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "mariotte/study/sensitivity/swept_slopes.hpp"
#include "scene_box.hpp"

namespace mariotte::python {
namespace {

namespace py = pybind11;

py::tuple capture_velocity(const SceneBox& box, double tolerance) {
  std::optional<impact::CaptureVelocity> found;
  {
    const py::gil_scoped_release unlocked;
    found = study::capture_velocity(box.document, tolerance, Interruption());
  }
  if (!found) throw Error(study::no_capture_velocity, fault::no_capture);
  return py::make_tuple(found->captured, found->separated, found->runs);
}

/// What has to be said of the impact at a speed.
std::vector<std::string> warnings_at(const SceneBox& box, double speed) {
  const auto scene = study::at_speed(box.document, speed);
  return std::visit([&](const auto& impact) { return report::warnings(impact, scene.run.flow); },
                    scene::simulate(scene));
}

/// e at each speed, in closed form, nan where there is none, and warnings of the fastest impact.
py::tuple restitution(const SceneBox& box, const std::vector<double>& speeds) {
  std::vector<double> found, closed;
  std::vector<std::string> warnings;
  {
    const py::gil_scoped_release unlocked;
    const auto pair = study::pair_of(box.scene, box.name, "followed at other speeds");
    Interruption interruption;
    for (const double speed : speeds) {
      interruption();
      found.push_back(impact::restitution(pair, speed));
      closed.push_back(or_nan(impact::closed_restitution(pair, speed)));
    }
    if (!speeds.empty()) warnings = warnings_at(box, std::ranges::max(speeds));
  }
  const auto count = std::ssize(speeds);
  return py::make_tuple(owned(std::move(found), {count}), owned(std::move(closed), {count}), warnings);
}

/// JSON and table, as the command prints them, and a row of displacements per mode.
py::tuple modes(const SceneBox& box, const std::optional<double>& end_force) {
  std::optional<study::Modes> found;
  {
    const py::gil_scoped_release unlocked;
    found = study::modes(box.scene, end_force);
  }
  const auto& shape = found->vibrations.shape;
  std::vector<double> rows;
  for (const auto& one : shape) rows.insert(rows.end(), one.begin(), one.end());
  const auto count = std::ssize(shape), dofs = shape.empty() ? 0 : std::ssize(shape.front());
  return py::make_tuple(report::text(report::json(*found)), report::table(*found, box.scene.title),
                        owned(std::move(rows), {count, dofs}));
}

/// With parameters, their values, outcomes by name and notes.
std::string json_of(const impact::Sensitivity& found) {
  report::Json result = report::Json::object();
  report::add_slopes(found, result);
  for (const auto& one : found.outcome) {
    const report::Json value = one.value ? report::Json(*one.value) : report::Json(nullptr);
    if (one.index)
      result["values"][one.name].push_back(value);
    else
      result["values"][one.name] = value;
  }
  return report::text(result);
}

std::string sensitivity(const SceneBox& box, const std::vector<std::string>& to) {
  return json_of(study::sensitivity(box.document, box.scene, to, {}, Interruption()));
}

std::string sensitivity_of_sum(const SceneBox& box, const std::vector<std::string>& to,
                               const std::vector<double>& weights) {
  return json_of(study::sensitivity_of_sum(box.document, box.scene, to, weights, Interruption()));
}

template <class... Impacts>
bool any_has(const std::string& text) {
  const auto key = impact::parse_key(text);
  return key && (impact::find_entry<Impacts>(*key) || ...);
}

/// Whether this is the key of a number that results of some model have.
bool is_of_results(const std::string& key) {
  return any_has<impact::ChainImpact, impact::NetworkImpact, impact::MicrobodyImpact, impact::BodiesImpact>(
      key);
}

bool sweeps_back(const SceneBox& box) {
  return study::sweeps_back(box.scene);
}

}  // namespace

void add_studies(py::module_& module) {
  module.def("capture_velocity", &capture_velocity, py::arg("scene"), py::arg("tolerance"));
  module.def("restitution", &restitution, py::arg("scene"), py::arg("speed"));
  module.def("modes", &modes, py::arg("scene"), py::arg("force"));
  module.def("sensitivity", &sensitivity, py::arg("scene"), py::arg("to"),
             py::call_guard<py::gil_scoped_release>());
  module.def("sensitivity_of_sum", &sensitivity_of_sum, py::arg("scene"), py::arg("to"), py::arg("weights"),
             py::call_guard<py::gil_scoped_release>());
  module.def("is_of_results", &is_of_results, py::arg("key"));
  module.def("sweeps_back", &sweeps_back, py::arg("scene"));
}

}  // namespace mariotte::python
