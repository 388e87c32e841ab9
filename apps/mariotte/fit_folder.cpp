#include "fit_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::command {
namespace {

/// What is there only if there are figures.
std::vector<std::string> figure_files() {
  auto names = report::fit_figures();
  names.insert(names.end(), {"curves.csv", "plot.gp"});
  return names;
}

/// Of those, what an earlier fit has left, and no file of somebody else.
std::vector<std::string> earlier_fit_files(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "fit.json")) return {};
  auto names = report::figures_of_script(folder / "plot.gp");
  names.insert(names.end(), {"curves.csv", "plot.gp"});
  return names;
}

}  // namespace

std::vector<std::string> fit_names() {
  std::vector<std::string> names = {"fit.json", "points.csv"};
  for (const auto& name : figure_files()) names.push_back(name);
  return names;
}

void prepare_fit_folder(const std::filesystem::path& folder, bool force) {
  report::prepare_folder(folder, fit_names(), force);
  report::remove_unfinished(folder, fit_names());
  report::remove_unfinished(folder, {"figures"});
}

std::string write_fit_folder(const std::filesystem::path& folder, const report::FitReport& report,
                             const std::optional<study::FitCurves>& curves) {
  report::remove_files(folder, earlier_fit_files(folder));
  report::write_file(folder / "fit.json", report::text(report::json(report)));
  report::write_file(folder / "points.csv", report::points_csv(report, curves));
  if (!curves) return "no column of numbers parts the measurements into few curves";
  report::write_file(folder / "curves.csv", report::curves_csv(*curves, report.measurements));
  report::write_file(folder / "plot.gp", report::fit_script(report, *curves));
  const auto problem = report::draw(folder, report::fit_figures());
  if (problem.empty()) return "";
  return fmt::format("{}; data and script are in {}", problem, (folder / "plot.gp").string());
}

}  // namespace mariotte::command
