#include "mariotte/impact/watch/chain_run.hpp"

#include <algorithm>
#include <utility>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/watch/contact_watch.hpp"

namespace mariotte::impact {

using model::ChainSystem;

namespace {

/// The peaks of one island after the other.
class IslandPeakObserver final : public model::IslandObserver {
 public:
  explicit IslandPeakObserver(std::vector<Peak>& all) : all_(all) {}
  void begin(const ChainSystem& slice, Index first, Instant) override {
    observer_.begin(slice.phase());
    first_ = first;
  }
  void observe(const flow::Step& step) override { observer_.observe(step); }
  void keep() override {
    auto kept = all_.begin() + first_;
    for (const auto& peak : observer_.peaks()) raise(*kept++, peak, all_peaks);
  }
  bool can_repeat() const override { return true; }
  void repeat(const model::Repetition& of) override { model::repeat(all_, of); }

 private:
  std::vector<Peak>& all_;
  PeakObserver observer_;
  Index first_ = 0;
};

}  // namespace

hybrid::Options tightened(hybrid::Options options, std::size_t balls) {
  const double passed = static_cast<double>(balls) / 700;
  options.accuracy =
      std::max(options.accuracy / std::max(1.0, passed), std::min(options.accuracy, 8 * epsilon));
  return options;
}

bool divides(const hybrid::Options& options, const model::Chain& chain) {
  const bool wanted =
      options.islands == hybrid::Islands::always ||
      (options.islands == hybrid::Islands::automatic && chain.mass.size() >= balls_for_islands);
  return wanted && !is_one_system(chain);
}

bool is_one_system(const model::Chain& chain) {
  return !chain.drive.empty() || std::any_of(chain.law.begin(), chain.law.end(), contact::adheres);
}

ChainRun follow_whole(ChainSystem& system, ConstState start, const hybrid::Options& options,
                      const RunObserver& observers) {
  ContactWatch watch(system.phase(), system.chain().scale, system.chain().time, observers);
  hybrid::Workspace<ChainSystem> workspace;
  hybrid::simulate(system, start, options, workspace, &watch);
  ChainRun chain_run{.run = std::move(workspace.run),
                     .mode = std::move(workspace.mode),
                     .peaks = watch.peaks.peaks(),
                     .islands = std::nullopt,
                     .trace = {}};
  system.problem(chain_run.mode);  // forces at the ending are those of the last mode
  watch.finish(chain_run.run.time, chain_run.run.state);
  if (observers.trace) chain_run.trace = watch.trace.take(chain_run.run.time, chain_run.run.state);
  return chain_run;
}

ChainRun follow_islands(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                        ConstState start, const hybrid::Options& options, bool stay,
                        model::SnapshotObserver* observer) {
  ChainRun chain_run;
  chain_run.peaks.resize(layout.contacts());
  model::Islands islands(chain, layout, start, options, stay,
                         [&] { return std::make_unique<IslandPeakObserver>(chain_run.peaks); });
  islands.run(observer);
  chain_run.run = std::move(islands.result());
  chain_run.mode = islands.mode();
  chain_run.islands = islands.count();
  return chain_run;
}

}  // namespace mariotte::impact
