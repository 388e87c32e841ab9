#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/named_files.hpp"
#include "command_line/terminal.hpp"
#include "interruption.hpp"
#include "mariotte/core/counted.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/json/json_stream.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/table/network_table.hpp"
#include "mariotte/report/table/table.hpp"
#include "mariotte/scene/judge.hpp"
#include "mariotte/scene/text_file.hpp"
#include "report_page.hpp"
#include "result_folder.hpp"
#include "run_notes.hpp"
#include "run_progress.hpp"
#include "scene_choice.hpp"
#include "trace_choice.hpp"
#include "trace_size.hpp"

namespace mariotte::command {
namespace {

struct Run {
  SceneChoice scene;
  TraceChoice trace;
  std::string out;
  bool json = false;
  bool report = false;
  bool force = false;
  bool estimate = false;
  bool verbose = false;
};

std::string size_of(const model::Chain& chain) {
  return report::size_of(chain);
}
std::string size_of(const model::Network& network) {
  return report::size_of(network);
}
std::string size_of(const model::Microbody&) {
  return "a body";
}
std::string size_of(const model::Bodies& bodies) {
  return counted(bodies.body.size(), "body", "bodies");
}

/// The impact, watched; says what it took. One that is interrupted ends with what there is until then.
template <class Model>
auto simulate(const Run& options, const Model& model, const scene::Scene& scene,
              impact::RunObserver observers) {
  RunProgress progress(scene.run.max_time);
  if (!options.scene.quiet) observers.progress = std::ref(progress);
  observers.gives_up = [] { return interruption() != 0; };
  const auto start = std::chrono::steady_clock::now();
  auto impact = impact::simulate(model, scene.run, observers);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (options.verbose) note(fmt::format("simulated {} in {:.3g} s", size_of(model), taken.count()));
  if (options.estimate && interruption() == 0)
    impact.estimated_accuracy = impact::estimate_accuracy(model, scene.run, impact);
  judge(impact, scene);
  return impact;
}

/// The model as it was understood; empty for one so large that the result would be twice as long.
report::Json resolved(const scene::Scene& scene) {
  if (!can_trace(scene)) return {};
  auto all = report::json(scene);
  for (const auto* model : {"chain", "network", "bodies"})
    if (all.contains(model)) return std::move(all[model]);
  return {{"body", all["body"]}, {"surface", all["surface"]}, {"incidence", all["incidence"]}};
}

/// What it takes to repeat the run.
report::Json provenance(const Run& options, const scene::Scene& scene) {
  auto all = report::provenance_json(scene.sha256);
  all["scene"] = options.scene.path;
  all["overrides"] = options.scene.set;
  return all;
}

/// What the command adds to a result: its inputs, and what it takes to repeat the run.
report::Json additions(const Run& options, const scene::Scene& scene) {
  report::Json more;
  if (auto inputs = resolved(scene); !inputs.empty()) more["scene"] = std::move(inputs);
  if (can_trace(scene) && std::filesystem::is_regular_file(options.scene.path))
    more["scene_text"] = scene::read_text(options.scene.path);
  more["provenance"] = provenance(options, scene);
  return more;
}

/// When the run ended [s].
double end_of(const impact::MicrobodyImpact& impact) {
  return impact.final.time;
}
double end_of(const auto& impact) {
  return impact.time;
}

/// A window of one's own that begins behind the end shows nothing.
void tell_empty_window(double end, const scene::Scene& scene) {
  const auto& window = scene.figure.window;
  if (window && (*window)[0] >= end)
    warning(fmt::format("figure.window begins at {:.6g} s, but the run ended at {:.6g} s: figures are empty",
                        (*window)[0], end));
}

/// Chosen balls or contacts that a chain does not have; a body has none to choose from.
void tell_missing(const std::vector<Index>& chosen, Index count, const char* what) {
  for (const Index number : chosen)
    if (number > count)
      warning(fmt::format("figure.{0}: {1} is left out, the last is {2}", what, number, count));
}
void tell_missing(const scene::Scene& scene) {
  if (std::holds_alternative<model::Microbody>(scene.model) &&
      !(scene.figure.balls.empty() && scene.figure.contacts.empty()))
    warning("figure.balls and figure.contacts say nothing of a [body]: all is drawn");
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  if (!chain) return;
  tell_missing(scene.figure.balls, std::ssize(chain->mass), "balls");
  tell_missing(scene.figure.contacts, std::ssize(chain->law), "contacts");
}

/// Writes the files of a run, and says which; `waves...` is the image that only chains have.
template <class Impact, class... Waves>
void write(const Run& options, const Impact& impact, const scene::Scene& scene, Waves... waves) {
  if (!options.force && has_result(options.out))
    throw report::FileError(
        "cannot write into " + options.out + ": another run has written there meanwhile (--force overwrites)",
        fault::exists);
  if (!options.scene.quiet) tell_empty_window(end_of(impact), scene);
  if (!options.scene.quiet) tell_missing(scene);
  const auto shortfall = write_result_folder(options.out, additions(options, scene), impact, scene, waves...);
  if (!shortfall.empty() && !options.scene.quiet) warning("no figures: " + shortfall);
  if (options.report) write_report_page(options.out, read_result(options.out));
  if (!options.scene.quiet)
    note("wrote " + options.out + ": " + fmt::format("{}", fmt::join(result_files(options.out), ", ")));
}

template <class Impact>
void show(const Run& options, const Impact& impact, const scene::Scene& scene) {
  const auto detail = options.verbose ? report::Detail::full : report::Detail::usual;
  if (!options.json) return print(report::table(impact, scene, detail));
  report::JsonStream to_stdout(print);
  report::write(to_stdout, impact, scene, additions(options, scene));
}

/// Writes and prints the impact, and says what is to be said of it.
template <class Impact, class... Waves>
int finish(const Run& options, const Impact& impact, const scene::Scene& scene, Waves... waves) {
  std::exception_ptr unwritten;  // what was computed is shown all the same
  try {
    if (!options.out.empty()) write(options, impact, scene, waves...);
  } catch (...) {
    unwritten = std::current_exception();
  }
  show(options, impact, scene);
  tell_warnings(report::warnings(impact, scene.run.flow), options.scene.quiet);
  const int code = tell_ending(impact.ending, impact.message, scene);
  if (unwritten) std::rethrow_exception(unwritten);
  if (interruption() != 0) {
    if (impact.ending != hybrid::Ending::interrupted)
      warning("interrupted: the end was reached, but its accuracy was not checked any more");
    return 128 + interruption();
  }
  return code;
}

/// Refuses a trace that nobody can want, and tells of a large one.
void expect_sensible(const Run& options, const RunningTrace& trace, const model::Chain& chain,
                     const scene::Scene& scene) {
  if (options.force) return;
  const auto size = measure(trace, chain, scene.run, [] { return interruption() != 0; });
  if (size.is_absurd())
    throw UsageError(
        fmt::format("--trace {} would have {}; make it smaller by --every, --balls, --contacts "
                    "or run.max_time (--force writes it)",
                    options.trace.file, text(size)));
  if (options.verbose || (size.is_large() && !options.scene.quiet))
    note(fmt::format("{}: {}", options.trace.file, text(size)));
}

/// The trace gets its name; of a run that was interrupted the rows until then stay beside it.
void finish_trace(const RunningTrace& trace, hybrid::Ending ending) {
  if (ending != hybrid::Ending::interrupted) return trace.file->commit();
  note(fmt::format("the rows until the interruption are in {}", trace.file->leave().string()));
}

/// What a trace says of itself.
report::Attributes origin(const Run& options, const scene::Scene& scene) {
  auto all = report::attributes(provenance(options, scene));
  all.emplace_back("title", scene.title);
  return all;
}

int run(const Run& options, const model::Chain& chain, const scene::Scene& scene) {
  const auto balls = chain.mass.size();
  const auto trace = start_trace(options.trace, balls, options.force, origin(options, scene));
  std::optional<report::Spacetime> waves;
  if (!options.out.empty() && !can_trace(scene)) waves.emplace(balls);
  impact::RunObserver observers{.trace = !options.out.empty() && can_trace(scene)};
  if (waves) observers.samplings.push_back(waves->sampling());
  if (trace) {
    expect_sensible(options, *trace, chain, scene);
    observers.samplings.push_back(trace->sampling);
  }
  const auto impact = simulate(options, chain, scene, observers);
  if (trace) finish_trace(*trace, impact.ending);
  const report::Spacetime* const image = waves ? &*waves : nullptr;
  return finish(options, impact, scene, image);
}

/// A model whose samples all come with the result.
template <class Model>
int run_whole(const Run& options, const Model& model, const scene::Scene& scene, const char* name) {
  if (!options.trace.file.empty())
    throw UsageError(fmt::format("--trace samples chains; --out writes the trace of a {}", name));
  const bool trace = !options.out.empty() && can_trace(scene);
  return finish(options, simulate(options, model, scene, {.trace = trace}), scene);
}

int run(const Run& options, const model::Microbody& body, const scene::Scene& scene) {
  return run_whole(options, body, scene, "body");
}

int run(const Run& options, const model::Bodies& bodies, const scene::Scene& scene) {
  return run_whole(options, bodies, scene, "scene of bodies");
}

int run(const Run& options, const model::Network& network, const scene::Scene& scene) {
  return run_whole(options, network, scene, "network");
}

int run(const Run&, const scene::LawAlone& nothing, const scene::Scene&) {
  scene::refuse(nothing);
}

int run(const Run& options) {
  if (options.force && options.out.empty() && options.trace.file.empty())
    throw UsageError("--force requires --out or --trace");
  expect_distinct({{"SCENE", {options.scene.path}},
                   {"--out", within(options.out, result_names())},
                   {"--trace", trace_files(options.trace)}});
  await_interruption();
  const auto scene = read(options.scene);
  if (!options.out.empty()) prepare_result_folder(options.out, options.force);
  return std::visit([&](const auto& model) { return run(options, model, scene); }, scene.model);
}

constexpr const char* run_examples = R"(Examples:
  mariotte run cradle.toml
  mariotte run cradle.toml --out results --report --force
  mariotte run cradle.toml --set "chain.velocity[0]=2 m/s" --accuracy 1e-12 --estimate
  mariotte run cradle.toml --flow cvode-adams --json
  mariotte run solitary_wave.toml --trace wave.csv --every "5 us" --balls 100:1000:100 --contacts 500

With --out DIR: result.json, events.csv, trace.csv, plot.csv, plot.gp and, by gnuplot, forces and velocities,
of [bodies] also friction and spins, as pdf, png and svg, of more than twelve balls as images; of a chain
whose contacts neither yield nor adhere also energy.csv and its figure; of more than 1000 balls spacetime.csv
and its image instead. With --report also report.html, all of it in one page with a moving picture, made from
motion.json.

With --trace FILE as CSV also FILE-metadata.json: units and meanings of its columns, scene and version, in
the form of CSV on the Web.
)";

OptionList declare(Run& options) {
  return joined(
      {scene_options(options.scene),
       trace_options(options.trace),
       run_options(options.scene),
       {{"--out", &options.out, "Write result files and figures into this folder", {.value = "DIR"}},
        {"--json", &options.json, "One JSON object on stdout instead of the table"},
        {"--report", &options.report, "Make one page of the result files", {.needs = {"--out"}}},
        {"--force", &options.force, "Overwrite files of an earlier run"},
        {"--estimate", &options.estimate, "Estimate the error by a second, tighter run"},
        {"-v,--verbose", &options.verbose, "Tell what is being done", {.excludes = {"--quiet"}}}}});
}

}  // namespace

Command run_command() {
  auto options = std::make_shared<Run>();
  return {.name = "run",
          .about = "Simulate a scene and print what happened",
          .footer = run_examples,
          .options = declare(*options),
          .act = [options] { return run(*options); }};
}

}  // namespace mariotte::command
