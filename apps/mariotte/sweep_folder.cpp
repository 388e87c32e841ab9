#include "sweep_folder.hpp"

#include <fmt/format.h>

#include "mariotte/report/files.hpp"
#include "mariotte/report/gnuplot.hpp"
#include "mariotte/report/sweep_csv.hpp"
#include "mariotte/report/sweep_plot.hpp"

namespace mariotte::command {
namespace {

const std::vector<std::string> names = {"sweep.csv", "plot.csv", "plot.gp"};

/// Figures of another sweep must not be taken for those of this one.
void remove_figures(const std::filesystem::path& folder) {
  std::vector<std::string> figures;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (name.starts_with("sweep.") && (name.ends_with(".png") || name.ends_with(".svg")))
      figures.push_back(name);
  }
  report::remove_files(folder, figures);
}

}  // namespace

void prepare_sweep_folder(const std::filesystem::path& folder, bool force) {
  report::prepare_folder(folder, {}, force);
  if (force) {
    study::remove_journals(folder);
    report::remove_files(folder, names);
    remove_figures(folder);
  } else if (study::journals(folder).empty()) {
    report::prepare_folder(folder, names, false);
  }
}

void write_sweep(const std::filesystem::path& folder, const study::SweepPlan& plan, study::Journal& journal) {
  report::remove_unfinished(folder, names);
  report::remove_unfinished(folder, {"figures"});  // this process alone writes here: it holds the journal
  report::NewFile csv(folder / "sweep.csv"), drawn(folder / "plot.csv");
  csv.append(report::sweep_header(plan.design, plan.columns));
  drawn.append("# where a point stands in the figures, then its row of sweep.csv\n");
  journal.read([&](Index first, std::string_view rows) {
    csv.append(rows);
    std::string text;
    report::append_drawn(plan.design, first, rows, text);
    drawn.append(text);
  });
  drawn.commit();
  csv.commit();
}

std::string draw_sweep(const std::filesystem::path& folder, const study::SweepPlan& plan) {
  const auto plot = report::sweep_plot(plan.design, plan.columns, plan.title);
  if (plot.figures.empty()) return "no figures: " + plot.shortfall;
  report::write_file(folder / "plot.gp", plot.script);
  if (const auto problem = report::draw(folder, plot.figures); !problem.empty())
    return fmt::format("no figures: {}; data and script are in {}", problem, (folder / "plot.gp").string());
  return plot.shortfall.empty() ? "" : "figures: " + plot.shortfall;
}

}  // namespace mariotte::command
