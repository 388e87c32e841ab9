#include "result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mariotte/core/overload.hpp"
#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/figure/energy_plot.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/plot.hpp"
#include "mariotte/report/json/json_stream.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/page/motion.hpp"
#include "report_page.hpp"

namespace mariotte::command {
namespace {

using FileTexts = std::map<std::string, std::string>;  // by file name

/// Files by their names, and figures that plot.gp makes.
struct Files {
  FileTexts texts;
  std::vector<std::string> figures;
};

constexpr const char* result_json = "result.json";
constexpr const char* energy = "energy";
constexpr const char* spacetime = "spacetime";
constexpr std::size_t most_balls_traced = 1000;  // some thousand samples of these are about 100 MB of text

std::vector<std::string> files_of(const std::vector<std::string>& figures) {
  std::vector<std::string> names;
  for (const auto& figure : figures)
    for (auto& file : report::files_of_figure(figure)) names.push_back(std::move(file));
  return names;
}

// One sample or none makes no curve.
bool can_plot(const impact::Trace& trace) {
  return trace.time.size() > 1;
}
bool can_plot(const impact::BodyTrace& trace) {
  return trace.state.size() > 1;
}

bool can_plot(const impact::BodiesTrace& trace) {
  return trace.time.size() > 1;
}

bool is_image(const report::Spacetime* waves) {
  return waves && waves->is_image();
}

void add_energy(FileTexts& texts, const impact::ChainImpact& impact, const scene::Scene& scene,
                const report::TimeAxis& axis) {
  const auto& chain = std::get<model::Chain>(scene.model);
  if (!report::knows_energies(chain)) return;
  const auto course = report::energy_course(impact, chain);
  texts["energy.csv"] = report::energy_csv(course);
  texts["plot.gp"] += report::energy_script(course, scene.title, axis);
}

// Their samples are not turned into energies.
void add_energy(FileTexts&, const impact::NetworkImpact&, const scene::Scene&, const report::TimeAxis&) {}
void add_energy(FileTexts&, const impact::MicrobodyImpact&, const scene::Scene&, const report::TimeAxis&) {}
void add_energy(FileTexts&, const impact::BodiesImpact&, const scene::Scene&, const report::TimeAxis&) {}

report::RunPlot plot(const impact::ContactImpact& impact, const scene::Scene& scene) {
  return report::plot(impact, scene.title, report::curve_names(scene), scene.figure);
}
report::RunPlot plot(const impact::BodiesImpact& impact, const scene::Scene& scene) {
  return report::plot(impact, scene.title, report::curve_names(scene), scene.figure);
}
report::RunPlot plot(const impact::MicrobodyImpact& impact, const scene::Scene& scene) {
  return report::plot(impact, scene.title, scene.figure);
}

template <class Impact>
void add_figures(Files& files, const Impact& impact, const scene::Scene& scene) {
  auto plotted = plot(impact, scene);
  files.texts["plot.csv"] = std::move(plotted.data);
  files.texts["plot.gp"] = std::move(plotted.script);
  files.figures = std::move(plotted.figures);
  add_energy(files.texts, impact, scene, plotted.axis);
  if (files.texts.contains("energy.csv")) files.figures.emplace_back(energy);
}

template <class Impact>
Files files_of(const Impact& impact, const scene::Scene& scene, const report::Spacetime* waves) {
  Files files{.texts = {{"events.csv", report::events_csv(impact)}}, .figures = {}};
  if (can_trace(scene)) files.texts["trace.csv"] = report::trace_csv(impact);
  if (can_plot(impact.trace)) add_figures(files, impact, scene);
  if (const auto motion = report::motion(impact, scene); !motion.empty())
    files.texts[motion_file] = report::text(motion);
  if (is_image(waves)) {
    files.texts["spacetime.csv"] = waves->data();
    files.texts["plot.gp"] = report::script_head() + waves->script(scene.title);
    files.figures = {spacetime};
  }
  return files;
}

template <class Impact>
void write_json(const std::filesystem::path& path, const report::Json& more, const Impact& impact,
                const scene::Scene& scene) {
  report::NewFile file(path);
  report::JsonStream to_file([&](std::string_view piece) { file.append(piece); });
  report::write(to_file, impact, scene, more);
  file.commit();
}

const std::vector<std::string> data_names = {"events.csv", "trace.csv",     "plot.csv",  "plot.gp",
                                             "energy.csv", "spacetime.csv", motion_file, report_page};

/// What an earlier run has left, and no file of somebody else.
std::vector<std::string> earlier_run_files(const std::filesystem::path& folder) {
  if (!has_result(folder)) return {};
  auto names = report::figures_of_script(folder / "plot.gp");
  names.insert(names.end(), data_names.begin(), data_names.end());
  return names;
}

// A figure of an earlier run must not be taken for one of this run.
void remove_others(const std::filesystem::path& folder, std::vector<std::string> earlier,
                   const FileTexts& texts) {
  std::erase_if(earlier, [&](const std::string& name) { return texts.contains(name); });
  report::remove_files(folder, earlier);
}

template <class Impact>
std::string write(const std::filesystem::path& folder, const report::Json& more, const Impact& impact,
                  const scene::Scene& scene, const report::Spacetime* waves) {
  const auto earlier = earlier_run_files(folder);
  write_json(folder / result_json, more, impact, scene);
  const auto files = files_of(impact, scene, waves);
  remove_others(folder, earlier, files.texts);
  for (const auto& [name, text] : files.texts) report::write_file(folder / name, text);
  if (files.figures.empty()) return "the run has no duration";
  const std::string problem = report::draw(folder, files_of(files.figures));
  if (problem.empty()) return "";
  return fmt::format("{}; data and script are in {}", problem, (folder / "plot.gp").string());
}

}  // namespace

bool can_trace(const scene::Scene& scene) {
  const auto size = Overload{
      [](const model::Chain& chain) { return chain.mass.size(); },
      [](const model::Network& network) { return std::max(network.law.size(), network.velocity.size()); },
      [](const model::Microbody& body) { return body.law.size(); },
      [](const model::Bodies& bodies) { return std::max(bodies.body.size(), bodies.contact.size()); },
      [](const scene::LawAlone& nothing) -> std::size_t { scene::refuse(nothing); }};
  return std::visit(size, scene.model) <= most_balls_traced;
}

bool has_result(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / result_json);
}

std::vector<std::string> result_names() {
  std::vector<std::string> names = {result_json};
  names.insert(names.end(), data_names.begin(), data_names.end());
  std::vector<std::string> figures(report::figures_of_runs.begin(), report::figures_of_runs.end());
  figures.insert(figures.end(), {energy, spacetime});
  for (const auto& name : files_of(figures)) names.push_back(name);
  return names;
}

std::vector<std::string> result_files(const std::filesystem::path& folder) {
  auto names = result_names();
  std::erase_if(names, [&](const std::string& name) { return !std::filesystem::exists(folder / name); });
  return names;
}

void prepare_result_folder(const std::filesystem::path& folder, bool force) {
  const auto names = result_names();
  report::prepare_folder(folder, names, force);
  report::remove_unfinished(folder, names);
  report::remove_unfinished(folder, {"figures"});
}

std::string write_result_folder(const std::filesystem::path& folder, const report::Json& more,
                                const impact::ChainImpact& impact, const scene::Scene& scene,
                                const report::Spacetime* waves) {
  return write(folder, more, impact, scene, waves);
}

std::string write_result_folder(const std::filesystem::path& folder, const report::Json& more,
                                const impact::NetworkImpact& impact, const scene::Scene& scene) {
  return write(folder, more, impact, scene, nullptr);
}

std::string write_result_folder(const std::filesystem::path& folder, const report::Json& more,
                                const impact::MicrobodyImpact& impact, const scene::Scene& scene) {
  return write(folder, more, impact, scene, nullptr);
}

std::string write_result_folder(const std::filesystem::path& folder, const report::Json& more,
                                const impact::BodiesImpact& impact, const scene::Scene& scene) {
  return write(folder, more, impact, scene, nullptr);
}

}  // namespace mariotte::command
