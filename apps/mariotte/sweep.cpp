#include "mariotte/study/sweep/sweep.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "cores.hpp"
#include "interruption.hpp"
#include "mariotte/core/counted.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/report/csv/sweep_rows.hpp"
#include "mariotte/report/json/sweep_json.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/page/provenance.hpp"
#include "mariotte/report/sweep_warnings.hpp"
#include "mariotte/scene/sha256.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "progress_line.hpp"
#include "ranks.hpp"
#include "scene_choice.hpp"
#include "sweep_folder.hpp"
#include "sweep_notes.hpp"

namespace mariotte::command {
namespace {

constexpr auto patience = std::chrono::seconds(3);  // for what a killed mpirun leaves behind to end

struct SweepOptions {
  SceneChoice scene;
  std::vector<std::string> columns;
  SweepFiles files;
  int threads = cores();
  bool force = false;
  bool verbose = false;
};

study::SweepPlan read(const SweepOptions& options, const Ranks& ranks) try {
  auto plan = study::read_sweep(open(options.scene), options.columns);
  if (!options.scene.quiet && ranks.first())
    for (const auto& one : plan.warnings) warning(one);
  return plan;
} catch (const study::ColumnError& problem) {
  throw UsageError(problem.what(), problem.fault);
}

/// What must be the same for a journal to be gone on with.
std::string identity(const study::SweepPlan& plan) {
  std::string formulas;
  for (const auto& column : plan.columns) formulas += column.written + "\n";
  return scene::sha256(plan.document.sha256 + report::sweep_header(plan.design, plan.columns) + formulas +
                       report::provenance().version);
}

study::Progress compute(const SweepOptions& options, const study::SweepPlan& plan, study::Journal& journal,
                        Ranks& ranks) {
  const auto missing = journal.missing();
  ProgressLine line(total(missing), options.scene.quiet || !ranks.first());
  const auto append_rows = [&](const auto& batch, auto& text) {
    report::append_rows(plan.design, batch, text);
  };
  const study::Dealer dealer(missing, {.rank = ranks.rank(), .ranks = ranks.count()});
  return run(plan, dealer, options.threads, append_rows, journal, [&](const auto& progress) {
    line.show(ranks.tell(progress.done));
    return interruption() == 0;
  });
}

/// The sweep as a whole, and what it takes to repeat it.
report::Json description(const SweepOptions& options, const study::SweepPlan& plan,
                         const study::Journal& journal) {
  auto what = report::json(plan, journal.failed());
  what["provenance"]["scene"] = options.scene.path;
  what["provenance"]["overrides"] = options.scene.set;
  return what;
}

std::string table(const report::ColumnStatistics& columns) {
  const auto all = columns.statistics();
  const auto row = [&](Index i) -> report::TableRow {
    const auto& one = all[static_cast<std::size_t>(i)];
    report::TableRow cells = {one.key};
    for (const double value : {one.mean, one.deviation, one.q05, one.q50, one.q95})
      cells.push_back(report::rounded(value, 5));
    return cells;
  };
  return report::columns({"column [SI]", "mean", "deviation", "5 %", "median", "95 %"}, std::ssize(all), row);
}

/// "all with a result", or how many have none or ended at a limit.
std::string outcome(Index failed, Index limited) {
  auto text = failed == 0 ? "all with a result" : fmt::format("{} without a result", failed);
  return limited == 0 ? text : fmt::format("{}, {} ended at a limit", text, limited);
}

void warn(const study::SweepPlan& plan, Index doubtful) {
  for (const auto& one : report::warnings(plan)) warning(one);
  if (doubtful > 0) warning(report::less_exact(doubtful));
}

int finish(const SweepOptions& options, const study::SweepPlan& plan, study::Journal& journal) {
  const auto written = write(options.files, plan, description(options, plan, journal), journal);
  if (!written.shortfall.empty() && !options.scene.quiet) warning(written.shortfall);
  const Index points = plan.design.points(), failed = journal.failed();
  print(fmt::format("{}, {}: {}\n", counted(points, "point"), outcome(failed, written.limited),
                    (options.files.folder / "sweep.csv").string()));
  if (written.statistics) print(table(*written.statistics));
  if (!options.scene.quiet) warn(plan, written.doubtful);
  return failed < points ? ExitCode::ok : ExitCode::solver_failed;
}

/// All ranks see what is done before one of them adds to it; what is wrong the first one says alone.
void open(const Ranks& ranks, const std::function<void()>& open_one) {
  if (!ranks.first()) ranks.meet();
  open_one();
  if (ranks.first()) ranks.meet();
  ranks.meet();
}

int sweep(const SweepOptions& options, Ranks& ranks) {
  const auto start = std::chrono::steady_clock::now();
  await_interruption();
  study::SweepPlan plan;
  std::optional<study::Journal> journal;
  open(ranks, [&] {
    plan = read(options, ranks);
    if (ranks.first()) prepare(options.files, plan, options.force);
    const auto is_of_this = [&plan](const study::Rows& rows) {
      return report::are_rows_of(plan.design, plan.columns.size(), rows);
    };
    journal.emplace(options.files.folder, identity(plan), plan.design.points(), ranks.rank(), patience,
                    is_of_this);
  });
  if (ranks.first() && !options.scene.quiet) tell_resumed(plan, *journal);
  const auto progress = compute(options, plan, *journal, ranks);
  ranks.meet();
  if (!ranks.first()) return ExitCode::ok;
  if (ranks.count() > 1) journal->reload();
  if (!journal->missing().empty()) {
    tell_interrupted(options.files.folder, plan, *journal);
    return 128 + (interruption() != 0 ? interruption() : SIGTERM);  // or another rank was told to stop
  }
  const int code = finish(options, plan, *journal);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (options.verbose) tell_cost(progress, options.threads, taken);
  return code;
}

/// One rank that cannot go on ends all, for they would wait for it forever.
int sweep(const SweepOptions& options) {
  Ranks ranks;
  try {
    return sweep(options, ranks);
  } catch (...) {
    if (ranks.count() > 1) ranks.end_all(guarded([]() -> int { throw; }));
    throw;
  }
}

constexpr const char* sweep_examples = R"(Examples:
  mariotte sweep map.toml --out results
  mariotte sweep map.toml --out results --column "icr[0]" --column "final.velocity[*]"
  mariotte sweep map.toml --out results --threads 1 --set run.accuracy=1e-6 -v

The scene says by [[sweep]] tables what is varied. Stopped or killed, the same command goes on where it was.
With --out DIR: sweep.csv, one row per point, sweep.json, what was varied, journal.jsonl, and by gnuplot
figures as pdf, png and svg with their data and script, plot.csv and plot.gp. With --hdf5 also sweep.h5, the
columns as datasets, and with --report also report.html, all but the rows in one page.
)";

OptionList declare(SweepOptions& options) {
  return joined({scene_options(options.scene),
                 {{"--out",
                   &options.files.folder,
                   "Folder for the result and the journal",
                   {.value = "DIR", .required = true}},
                  {"--column",
                   &options.columns,
                   "Result key of a column, * for all indices, or NAME=EXPRESSION; may be repeated",
                   {.value = "KEY", .takes_one = true}},
                  {"--threads",
                   &options.threads,
                   "How many points at once (default: one per core allowed)",
                   {.check = Range{1, 4096}}}},
                 run_options(options.scene),
                 {{"--hdf5", &options.files.hdf5, "Write the rows as HDF5, too"},
                  {"--report", &options.files.report, "Make one page of the result files"},
                  {"--no-figures", &options.files.no_figures, "Write the data, draw nothing"},
                  {"--force", &options.force, "Start anew, whatever the folder holds of an earlier sweep"},
                  {"-v,--verbose", &options.verbose, "Tell what a point costs", {.excludes = {"--quiet"}}}}});
}

}  // namespace

Command sweep_command() {
  auto options = std::make_shared<SweepOptions>();
  return {.name = "sweep",
          .about = "Simulate a scene for all values of its [[sweep]] tables",
          .footer = sweep_examples,
          .options = declare(*options),
          .act = [options] { return sweep(*options); }};
}

}  // namespace mariotte::command
