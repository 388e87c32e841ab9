// Triplets side by side; compiled once per instruction set.
#pragma once
#include <span>

#include "mariotte/flow/lanes/side_by_side.hpp"
#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "mariotte/flow/triplet/triplet_pair.hpp"
#include "mariotte/flow/triplet/triplet_start.hpp"
#include "mariotte/flow/triplet/triplet_step.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

template <class Field>
class TripletSeries final : public TripletLanes {
 public:
  void start(std::span<Triplet* const> triplets, const Precision& precision) override {
    in_groups(triplets, [&](auto group) { start_.run(group, precision); });
  }

  void end_pairs(std::span<Triplet* const> triplets) override {
    in_groups(triplets, [](auto group) { MARIOTTE_INSTRUCTION_SET::end_pairs(group); });
  }

  void follow(std::span<Triplet* const> triplets, const Precision& precision) override {
    lanes_.follow(triplets, precision, [&](int lane, Triplet& t, int steps) { return look(lane, t, steps); });
  }

 private:
  using Step = TripletStep<Field>;

  static void in_groups(std::span<Triplet* const> triplets, auto&& use) {
    for (std::size_t i = 0; i < triplets.size(); i += width)
      use(triplets.subspan(i, triplets.size() - i < width ? triplets.size() - i : width));
  }

  /// A contact may have let go within the step, or not be told from rest.
  Look look(int lane, Triplet& t, int steps) const {
    const Step& step = lanes_.step();
    double place = step.end(lane);
    int opens = -1;
    for (int j = 0; j < 2; ++j) {
      if (step.remains(lane, j)) continue;
      const auto fall = step.first_fall(lane, j, place);
      if (fall && *fall < place) place = *fall, opens = j;
    }
    const auto is_above_noise = [&](int j) { return step.is_above_noise(lane, j, t.noise_speed); };
    if (opens < 0 && !lanes_.is_over(steps) && is_above_noise(0) && is_above_noise(1)) return Look::goes_on;
    step.put(lane, place, t);
    t.series_steps += steps;
    let_go(t, opens);
    return Look::ended;
  }

  SideBySide<Step> lanes_;
  TripletStart start_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::TripletLanes> mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_triplet_lanes(
    Lanewise lanewise) {
  using namespace taylor::MARIOTTE_INSTRUCTION_SET;
  if (lanewise == Lanewise::contacts) return std::make_unique<TripletSeries<PairedTripletField>>();
  return std::make_unique<TripletSeries<TripletField>>();
}
