#include "mariotte/impact/watch/course.hpp"

#include <algorithm>
#include <utility>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/watch/contact_watch.hpp"

namespace mariotte::impact {

using model::ChainSystem;

namespace {

/// The peaks of one island after the other.
class PeakLog final : public model::StretchLog {
 public:
  explicit PeakLog(std::vector<Peak>& all) : all_(all) {}
  void begin(const ChainSystem& slice, Index first, Instant) override {
    watcher_.begin(slice.phase());
    first_ = first;
  }
  void watch(const flow::Step& step) override { watcher_.watch(step); }
  void keep() override {
    auto kept = all_.begin() + first_;
    for (const auto& peak : watcher_.peaks()) raise(*kept++, peak, all_peaks);
  }

 private:
  std::vector<Peak>& all_;
  PeakWatcher watcher_;
  Index first_ = 0;
};

}  // namespace

hybrid::Options tightened(hybrid::Options options, std::size_t balls) {
  const double passed = static_cast<double>(balls) / 700;
  options.accuracy =
      std::max(options.accuracy / std::max(1.0, passed), std::min(options.accuracy, 8 * epsilon));
  return options;
}

bool divides(const hybrid::Options& options, std::size_t balls) {
  return options.islands == hybrid::Islands::always ||
         (options.islands == hybrid::Islands::automatic && balls >= balls_for_islands);
}

Course follow_whole(ChainSystem& system, ConstState start, const hybrid::Options& options,
                    const Observers& observers) {
  ContactWatch watch(system.phase(), system.chain().scale, observers);
  hybrid::Workspace<ChainSystem> workspace;
  hybrid::simulate(system, start, options, workspace, &watch);
  Course course{.run = std::move(workspace.run),
                .mode = std::move(workspace.mode),
                .peaks = watch.peaks.peaks(),
                .islands = std::nullopt,
                .trace = {}};
  system.problem(course.mode);  // forces at the ending are those of the last mode
  if (observers.trace) course.trace = watch.recorder.take(course.run.time, course.run.state);
  return course;
}

Course follow_islands(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                      ConstState start, const hybrid::Options& options, bool stay,
                      model::Onlooker* onlooker) {
  Course course;
  course.peaks.resize(layout.contacts());
  model::Islands islands(chain, layout, start, options, stay,
                         [&] { return std::make_unique<PeakLog>(course.peaks); });
  islands.run(onlooker);
  course.run = std::move(islands.result());
  course.mode = islands.mode();
  course.islands = islands.count();
  return course;
}

}  // namespace mariotte::impact
