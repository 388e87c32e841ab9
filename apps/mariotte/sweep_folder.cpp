#include "sweep_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/report/csv/sweep_rows.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_plot.hpp"
#include "mariotte/report/json/sweep_json.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/sweep_file.hpp"
#include "report_page.hpp"

namespace mariotte::command {
namespace {

constexpr const char* hdf5_name = "sweep.h5";
const std::vector<std::string> names = {"sweep.csv", "sweep.json", hdf5_name,
                                        "plot.csv",  "plot.gp",    report_page};

bool is_random(const study::Design& design) {
  return std::any_of(design.parameters.begin(), design.parameters.end(),
                     [](const study::Parameter& one) { return one.range && one.range->seed; });
}

/// What another sweep has left must not be taken for this one's; files of somebody else stay.
void remove_earlier(const std::filesystem::path& folder) {
  if (study::journals(folder).empty() && !std::filesystem::exists(folder / "sweep.json")) return;
  study::remove_journals(folder);
  report::remove_files(folder, report::figures_of_script(folder / "plot.gp"));
  report::remove_files(folder, names);
}

/// All but figures and page; sweep.csv, without which there is no result, comes last. sweep.json tells the
/// statistics of a random design, too.
Written write_tables(const SweepFiles& files, const study::SweepPlan& plan, report::Json what,
                     study::Journal& journal) {
  Written written;
  auto& statistics = written.statistics;
  if (is_random(plan.design)) statistics.emplace(report::sweep_header(plan.design, plan.columns));
  report::NewFile csv(files.folder / "sweep.csv"), drawn(files.folder / "plot.csv");
  std::unique_ptr<report::SweepFile> table;
  if (files.hdf5)
    table = report::new_hdf5_sweep(files.folder / hdf5_name, plan.design, plan.columns,
                                   report::attributes(what["provenance"]));
  csv.append(report::sweep_header(plan.design, plan.columns));
  drawn.append("# where a point stands in the figures, then its row of sweep.csv\n");
  journal.read([&](Index first, std::string_view rows) {
    csv.append(rows);
    std::string text;
    report::append_drawn(plan.design, first, rows, text);
    drawn.append(text);
    if (table) table->add(rows);
    if (statistics) statistics->add(rows);
    written.limited += report::count_limited(rows);
    written.doubtful += report::count_doubtful(rows);
  });
  drawn.commit();
  if (table) table->commit();
  if (statistics) what["statistics"] = statistics->json();
  report::write_file(files.folder / "sweep.json", report::text(what));
  csv.commit();
  return written;
}

std::string draw(const std::filesystem::path& folder, const study::SweepPlan& plan) {
  const auto plot = report::sweep_plot(plan.design, plan.columns, plan.title, plan.figure);
  if (plot.figures.empty()) return "no figures: " + plot.shortfall;
  report::write_file(folder / "plot.gp", plot.script);
  if (const auto problem = report::draw(folder, plot.figures); !problem.empty())
    return fmt::format("no figures: {}; data and script are in {}", problem, (folder / "plot.gp").string());
  return plot.shortfall.empty() ? "" : "figures: " + plot.shortfall;
}

}  // namespace

void prepare(const SweepFiles& files, const study::SweepPlan& plan, bool force) {
  const auto& folder = files.folder;
  report::prepare_folder(folder, {}, force);
  if (force) {
    remove_earlier(folder);
  } else if (study::journals(folder).empty()) {
    report::prepare_folder(folder, names, false);
  }
  // What cannot be written is better refused before the sweep than after it.
  if (files.hdf5) report::new_hdf5_sweep(folder / hdf5_name, plan.design, plan.columns);
}

Written write(const SweepFiles& files, const study::SweepPlan& plan, const report::Json& what,
              study::Journal& journal) {
  // This process alone writes here: it holds the journal.
  report::remove_unfinished(files.folder, names);
  report::remove_unfinished(files.folder, {"figures"});
  auto written = write_tables(files, plan, what, journal);
  if (!files.no_figures) written.shortfall = draw(files.folder, plan);
  if (files.report) write_report_page(files.folder, read_result(files.folder));
  return written;
}

}  // namespace mariotte::command
