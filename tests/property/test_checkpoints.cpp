// A run that goes on from where another was ends as that does.
#define BOOST_TEST_MODULE checkpoints
#include <boost/test/unit_test.hpp>
#include <optional>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/model/islands/islands.hpp"
#include "support/island_scenes.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Takes a checkpoint after so many events.
class Taker final : public model::SnapshotObserver {
 public:
  Taker(const model::Islands& run, Index events) : run_(run), events_(events) {}

  double next_look() const override { return infinity; }
  void look(model::Snapshot&) override {}
  void look_last(model::Snapshot&) override {}
  void passed(double, Index events) override {
    if (!taken && events >= events_) taken.emplace(run_.checkpoint());
  }
  bool gives_up() const override { return false; }

  std::optional<model::Checkpoint> taken;

 private:
  const model::Islands& run_;
  Index events_;
};

struct Row {
  explicit Row(const model::Chain& chain)
      : options{.accuracy = 1e-9, .max_time = 10 + static_cast<double>(chain.mass.size())} {
    make_dimensionless(chain, options.accuracy, scaled);
    make_layout(scaled, layout);
    initial_state(scaled, layout, start);
    options = hybrid::scaled(options, scaled.scale);
  }

  hybrid::Options options;
  model::DimensionlessChain scaled;
  model::ChainLayout layout;
  std::vector<double> start;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_goes_on_from_a_checkpoint_as_if_it_had_not_stopped) {
  IslandSceneMaker maker(1671);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const int kind = i % island_scene_kinds;
    const Row row(maker.make(static_cast<IslandScene>(kind)));
    model::Islands whole(row.scaled, row.layout, row.start, row.options, true, {});
    Taker taker(whole, 1 + 7 * (i % 9));
    whole.run(&taker);
    if (!taker.taken) continue;
    model::Islands rest(row.scaled, row.layout, *taker.taken, row.options, true, {});
    rest.run();
    ++compared;
    BOOST_TEST_CONTEXT("scene " << i << " of kind " << kind) {
      BOOST_TEST((rest.result().ending == whole.result().ending));
      BOOST_TEST(rest.result().events < whole.result().events);
      BOOST_TEST(rest.result().time == whole.result().time);
      BOOST_TEST(rest.result().state == whole.result().state, boost::test_tools::per_element());
    }
  }
  BOOST_TEST(compared > 200);
}
