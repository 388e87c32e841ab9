#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/named_files.hpp"
#include "command_line/terminal.hpp"
#include "fit_folder.hpp"
#include "mariotte/core/counted.hpp"
#include "mariotte/report/limit_count.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct FitOptions {
  SceneChoice scene;
  std::string data;
  std::vector<std::string> free;
  double confidence = 0.95;
  bool differences = false;
  std::string out;
  bool json = false;
  bool force = false;
};

/// Where restitution falls to zero the fit has no slope to go by.
void warn_of_captured(const study::Fit& fit, const study::Measurements& measurements) {
  Index count = 0;
  for (std::size_t row = 0; row < fit.predicted.size(); ++row)
    count += fit.predicted[row].captured && measurements.rows[row].measured > 0;
  if (count > 0)
    warning(fmt::format("{} of {} {} predicted to be {}", count,
                        counted(measurements.rows.size(), "measured rebound"), count == 1 ? "is" : "are",
                        count == 1 ? "a capture" : "captures"));
}

/// Runs of some measurements, at the values that were found.
int tell_limits(study::FitModel& model, const study::Fit& fit, bool quiet) {
  const auto rows = report::some_of(std::ssize(fit.predicted));
  report::LimitCount limits;
  for (const Index row : rows) limits.look(model.scene_of_row(static_cast<std::size_t>(row), fit.values()));
  if (!quiet)
    for (const auto& one : limits.sentences(rows.size(), "measurements")) warning(one);
  if (limits.invalid() == 0) return ExitCode::ok;
  error(fmt::format("at {} of {} measurements that were looked at, a contact is deeper than any law holds",
                    limits.invalid(), rows.size()),
        fault::invalid);
  return ExitCode::solver_failed;
}

int finish(const FitOptions& options, const scene::Scene& scene, study::FitModel& model,
           const study::Fit& fit) {
  const report::FitReport report{
      .fit = fit, .measurements = model.measurements(), .title = scene.title, .scene_sha256 = scene.sha256};
  if (!options.scene.quiet) warn_of_captured(fit, model.measurements());
  if (!options.scene.quiet)
    for (const auto& one : fit.warnings) warning(fmt::format("{} [{}]", one, fault::undetermined.code));
  if (!options.scene.quiet)
    for (const auto& one : model.warnings_of_speeds()) warning(one);
  if (!options.out.empty()) {
    const auto shortfall = write_fit_folder(options.out, report, study::fit_curves(model, fit));
    if (!shortfall.empty() && !options.scene.quiet) warning("no figures: " + shortfall);
  }
  print(options.json ? report::text(report::json(report)) : report::table(report));
  return tell_limits(model, fit, options.scene.quiet);
}

/// Of a body its damping, unless the user says otherwise.
std::vector<std::string> free_keys(const FitOptions& options, const scene::Scene& scene) {
  if (!options.free.empty()) return options.free;
  if (std::holds_alternative<model::Microbody>(scene.model))
    return {"surface.zeta_hertz", "surface.zeta_adhesion"};
  throw UsageError("--free says which keys of the scene are to be found");
}

int fit(const FitOptions& options) try {
  expect_distinct({{"SCENE", {options.scene.path}},
                   {"DATA", {options.data}},
                   {"--out", within(options.out, fit_names())}});
  auto document = open(options.scene);
  const auto scene = resolve(options.scene, document);
  const auto free = free_keys(options, scene);
  study::FitModel model(std::move(document), free, study::read_measurements(options.data));
  if (options.differences) model.leave_out_slopes();
  if (!options.out.empty()) prepare_fit_folder(options.out, options.force);
  return finish(options, scene, model, study::fit(model, free, options.confidence));
} catch (const study::FitError& problem) {
  error(problem.what(), problem.fault);
  return ExitCode::check_failed;
}

constexpr const char* fit_examples = R"(Examples:
  mariotte fit sphere.toml measured.csv
  mariotte fit sphere.toml measured.csv --free surface.zeta_hertz,surface.work_of_adhesion
  mariotte fit rod.toml measured.csv --free surface.friction --json

The first line of DATA names its columns: speed, diameter or any key of the scene; restitution, or the key of
any other number of a result, as contacts[0].peak_force; and deviation if it is known. A unit may follow, as
in "diameter [um]". Values of the scene are where the search starts; what it finds stays positive.
With --out DIR: fit.json, points.csv, curves.csv, plot.gp and, by gnuplot, fit and residuals as pdf, png and
svg.
Measurements that do not determine the values: exit code 1.
)";

OptionList declare(FitOptions& options) {
  return joined(
      {{{"SCENE", &options.scene.path, "Scene file (TOML), with all that is known", {.required = true}},
        {"DATA", &options.data, "What was measured (CSV)", {.required = true}}},
       override_options(options.scene),
       {{"--free",
         &options.free,
         "Keys whose values are to be found, between commas; of a body its damping if none are named",
         {.value = "KEYS", .takes_one = true, .between_commas = true}},
        {"--confidence",
         &options.confidence,
         "Of the intervals",
         {.check = Range{0.01, 0.9999}, .shows_default = true}},
        {"--differences", &options.differences, "Slopes by differences of runs alone, to compare"}},
       run_options(options.scene),
       {{"--out", &options.out, "Write result files and figures into this folder", {.value = "DIR"}},
        {"--json", &options.json, "One JSON object on stdout instead of the table"},
        {"--force", &options.force, "Overwrite files of an earlier fit", {.needs = {"--out"}}}}});
}

}  // namespace

Command fit_command() {
  auto options = std::make_shared<FitOptions>();
  return {.name = "fit",
          .about = "Find values of a scene from measured restitution, or any other number of its result",
          .footer = fit_examples,
          .options = declare(*options),
          .act = [options] { return fit(*options); }};
}

}  // namespace mariotte::command
