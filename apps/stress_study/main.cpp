// Random scenes of every kind, each followed in several ways that must agree.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include "command_line/exit_code.hpp"
#include "command_line/program.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/core/counted.hpp"
#include "mariotte/report/page/files.hpp"
#include "table.hpp"
#include "workers.hpp"

namespace mariotte::stress_study {
namespace {

/// Those that are drawn unless others are asked for, and all that there are.
const std::vector<std::string> usual_kinds = {"chains", "networks", "bodies", "laws", "friction"};
const std::vector<std::string> known_kinds = {"chains",   "networks", "bodies", "laws",
                                              "friction", "rows",     "slopes", "friction-slopes"};

struct CommandLine {
  double seconds = 60, patience = Campaign{}.patience;
  std::uint64_t seed = 1;
  std::uint64_t first = 0, scenes = 1000000;
  std::int64_t only = -1;
  std::string folder;
  int workers = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::string> kinds = usual_kinds;
  bool brisk = false, verbose = false;
};

constexpr const char* notes = R"(
Each scene is run by the automatic choice of flows at 1e-6, 1e-8, 1e-10, all times a share from a tenth to one,
and at 1e-12, by another flow, and by a naive simulator without events. A deviation above 10 times the accuracy
counts unless small perturbations of the scene, run by two flows, change the results as much. Each family that
was drawn has a row. Columns: scenes; those left out by --brisk; share of runs of `auto` whose error is within
1, 10, 100 times what was asked; scenes that the naive simulator could follow; scenes in which numbers of
contact periods differ; runs refused by name, failed, without an end; runs of a flow asked for by name that came
to no end, which is no fault; runs slower than 100 times the median; CPU time a scene costs; the worst deviation
over what was asked, and in which scene; scenes with anything unexplained.

--kinds rows draws long rows whose waves become steady. --kinds slopes compares slopes by numbers of the
scenes with differences of runs instead, --kinds friction-slopes those of bodies with friction.

Examples:
  stress_study --seconds 60
  stress_study --scenes 100000 --seed 7 --kinds chains,bodies --out worst
  stress_study --only 4711 --seed 7 --verbose --out .

Exit codes: 0 ok, 1 something is unexplained, 2 usage, 4 failure, 6 file error.
)";

command::OptionList declare(CommandLine& line) {
  return {
      {"--seconds",
       &line.seconds,
       "Stop after this time",
       {.check = command::Positive{}, .shows_default = true}},
      {"--scenes", &line.scenes, "Stop after so many scenes", {.shows_default = true}},
      {"--seed", &line.seed, "Which scenes: those of one seed are always the same", {.shows_default = true}},
      {"--first",
       &line.first,
       "Number of the first scene, such as where another start has stopped",
       {.shows_default = true}},
      {"--only", &line.only, "Number of the one scene to examine"},
      {"--kinds",
       &line.kinds,
       "Some of chains, networks, bodies, laws, friction, rows, slopes, friction-slopes",
       {.check = command::OneOf{known_kinds}, .between_commas = true}},
      {"--patience",
       &line.patience,
       "CPU time of one run after which it is without an end [s]",
       {.check = command::Positive{}, .shows_default = true}},
      {"--threads", &line.workers, "Scenes examined at once", {.check = command::Range{1, 256}}},
      {"--out",
       &line.folder,
       "Write the worst and all unexplained scenes, or the one asked for, into this folder",
       {.value = "DIR"}},
      {"--brisk", &line.brisk,
       "Many scenes in short time: without flows asked for by name, and scenes that take long"},
      {"-v,--verbose", &line.verbose, "Say everything that is unexplained as soon as it is found"}};
}

/// Scene files of one campaign.
constexpr std::size_t most_files = 2000;

class Study {
 public:
  explicit Study(const CommandLine& line)
      : line_(line),
        campaign_{.families = families(line.kinds),
                  .seed = line.seed,
                  .first = line.first,
                  .workers = line.workers,
                  .patience = line.patience,
                  .brisk = line.brisk} {
    for (const auto& family : campaign_.families) tallies_.push_back({.family = family.name});
    if (!line.folder.empty()) std::filesystem::create_directories(line.folder);
  }

  int run() {
    if (line_.only >= 0) {
      const auto number = static_cast<std::uint64_t>(line_.only);
      write(number, fmt::format("scene {} of seed {}", number, line_.seed));
      take(examine(campaign_.families, line_.seed, number, [&](const std::string& what) { announce(what); }));
    } else {
      examine_all(
          campaign_, [&](std::uint64_t scene) { return more(scene); },
          [&](const Verdict& verdict) { take(verdict); });
    }
    for (const auto& tally : tallies_)
      if (tally.worst > 1 && !written_.contains(tally.worst_scene))
        write(tally.worst_scene,
              fmt::format("the worst of its family: {:.1e} times what was asked", tally.worst));
    command::print(table(tallies_));
    return unexplained_ == 0 ? command::ExitCode::ok : command::ExitCode::check_failed;
  }

 private:
  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  bool more(std::uint64_t scene) const {
    return scene - line_.first < line_.scenes && elapsed() < line_.seconds;
  }

  std::size_t family(std::uint64_t scene) const { return family_of(campaign_.families, scene); }
  void announce(const std::string& what) const {
    if (line_.verbose) command::note(fmt::format("{:.3f} s: {}", elapsed(), what));
  }
  void take(const Verdict& verdict) {
    add(verdict, tallies_[family(verdict.scene)]);
    ++done_;
    if (!verdict.findings.empty()) tell(verdict);
    if (elapsed() < next_word_) return;
    next_word_ = elapsed() + 10;
    command::note(
        fmt::format("{:.0f} s: {}, {} unexplained", elapsed(), counted(done_, "scene"), unexplained_));
  }
  void tell(const Verdict& verdict) {
    ++unexplained_;
    const auto found = fmt::format("{}", fmt::join(verdict.findings, "\n"));
    const auto& name = campaign_.families[family(verdict.scene)].name;
    if (line_.verbose) command::note(fmt::format("scene {} ({}): {}", verdict.scene, name, found));
    write(verdict.scene, found);
  }
  void write(std::uint64_t number, const std::string& what) {
    if (line_.folder.empty() || written_.size() == most_files) return;
    written_.insert(number);
    const auto scene = scene_of(campaign_.families, line_.seed, number);
    auto name = campaign_.families[family(number)].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    const auto path =
        std::filesystem::path(line_.folder) / fmt::format("{}_{}_{}.toml", name, line_.seed, number);
    report::write_file(path, text(scene, accuracies_of(number).back(), what));
  }

  const CommandLine& line_;
  Campaign campaign_;
  std::vector<Tally> tallies_;
  std::uint64_t done_ = 0, unexplained_ = 0;
  std::set<std::uint64_t> written_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double next_word_ = 10;
};

}  // namespace
}  // namespace mariotte::stress_study

int main(int argc, char** argv) {
  using namespace mariotte;
  stress_study::CommandLine line;
  return command::run_program(
      {.name = "stress_study",
       .about = "Random scenes of every kind, each followed in several ways that must agree.",
       .footer = stress_study::notes,
       .options = stress_study::declare(line),
       .act = [&] { return stress_study::Study(line).run(); }},
      argc, argv);
}
