// Fits to measurements: what the search finds, and the curves of its figure.
#include "mariotte/study/fit/fit.hpp"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interruption.hpp"
#include "mariotte/report/figure/fit_plot.hpp"
#include "scene_box.hpp"

namespace mariotte::python {
namespace {

namespace py = pybind11;

/// What was found, with the model that can be asked for more.
struct FitRun {
  std::unique_ptr<study::FitModel> model;
  study::Fit fit;
  std::string title, scene_sha256;

  report::FitReport report() const {
    return {.fit = fit, .measurements = model->measurements(), .title = title, .scene_sha256 = scene_sha256};
  }
};

std::shared_ptr<FitRun> fit(const SceneBox& box, const std::string& text, const std::string& name,
                            const std::vector<std::string>& free, double confidence) {
  auto model = std::make_unique<study::FitModel>(box.document, free, study::parse_measurements(text, name));
  model->watch(Interruption());
  auto found = study::fit(*model, free, confidence);
  return std::make_shared<FitRun>(
      FitRun{std::move(model), std::move(found), box.scene.title, box.scene.sha256});
}

py::tuple row_of(const study::FitCurve& curve, double factor) {
  auto abscissa = curve.abscissa;
  for (double& at : abscissa) at *= factor;
  const auto count = std::ssize(abscissa);
  return py::make_tuple(report::name_of(curve), owned(std::move(abscissa), {count}),
                        owned(curve.ordinate, {count}), curve.captured);
}

/// Names of the two axes, in gnuplot's enhanced text; key of the first, and the factor from SI to what it
/// shows; whether it is logarithmic; name, abscissa, ordinate and captures of each curve; the curve of each
/// measurement. None where no figure can be drawn.
py::object curves(FitRun& run) {
  std::optional<study::FitCurves> found;
  {
    const py::gil_scoped_release unlocked;
    found = study::fit_curves(*run.model, run.fit);
  }
  if (!found) return py::none();
  const auto& measurements = run.model->measurements();
  const auto& setting = measurements.settings[found->setting];
  const double factor = setting.unit == "rad" ? 180 / std::numbers::pi : 1;
  py::list rows;
  for (const auto& curve : found->curves) rows.append(row_of(curve, factor));
  return py::make_tuple(report::label_of(setting), report::label_of(measurements), setting.key, factor,
                        found->logarithmic, rows, found->curve_of_row);
}

}  // namespace

void add_fit(py::module_& module) {
  py::class_<FitRun, std::shared_ptr<FitRun>>(module, "FitRun")
      .def("json", [](const FitRun& run) { return report::text(report::json(run.report())); })
      .def("table", [](const FitRun& run) { return report::table(run.report()); })
      .def("warnings", [](FitRun& run) { return run.model->warnings_of_speeds(); })
      .def("curves", &curves);
  module.def("fit", &fit, py::arg("scene"), py::arg("text"), py::arg("name"), py::arg("free"),
             py::arg("confidence"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace mariotte::python
