// A step of triplets whose contacts are both closed; included as the series are.
#pragma once
#include "mariotte/flow/lanes/lane_step.hpp"
#include "mariotte/flow/triplet/triplet.hpp"
#include "mariotte/flow/triplet/triplet_field.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// By TripletField a scene stands in each lane, by PairedTripletField the two contacts of one scene do.
template <class F>
class TripletStep : public LaneStep<F> {
  using Base = LaneStep<F>;
  using Base::row;

 public:
  using Scene = Triplet;
  static constexpr Triplet idle{.own = {},
                                .cross = {},
                                .weight = {1, 1},
                                .noise_speed = 0,
                                .noise_root = 0,
                                .same_instant = 0,
                                .rate = {},
                                .indentation = {1, 1}};

  void load(int scene, const Triplet& t) {
    for (int j = 0; j < 2; ++j) {
      Base::load(scene, row(F::root, j), j, __builtin_sqrt(t.indentation[j]));
      Base::load(scene, row(F::rate, j), j, t.rate[j]);
      Base::load(scene, F::time, j, t.time);
      Base::load_parameter(scene, row(F::own, j), j, t.own[j]);
      Base::load_parameter(scene, row(F::cross, j), j, t.cross[j]);
      Base::load_weights(scene, j, t.weight[j], 1);
      Base::set(noise_root_, j, scene, t.noise_root);
    }
  }

  void advance(const Precision& precision) {
    Base::advance(precision);
    clearance_ = splat(infinity);
    for (int i = 0; i < F::contacts; ++i) {
      const Vec above = Base::weight(i) * Base::state(F::root + i) - noise_root_.part[0];
      clearance_ = least(clearance_, least(Base::bound(i), above));
    }
    if constexpr (F::are_paired) clearance_ = least(clearance_, exchanged(clearance_));
  }

  /// Both contacts are proven to be closed all the while, and are above the noise.
  bool is_clear(int scene) const { return clearance_[scene] > 0; }
  bool is_above_noise(int scene, int j, double noise_speed) const {
    const double rate = Base::state(scene, row(F::rate, j), j), speed = rate < 0 ? -rate : rate;
    return Base::weight(scene, j) * Base::state(scene, row(F::root, j), j) > noise_root_.part[0][scene] ||
           speed > noise_speed;
  }

  /// State at a place of the step.
  void put(int scene, double place, Triplet& t) const {
    for (int j = 0; j < 2; ++j) {
      const double x = Base::value(scene, row(F::root, j), j, place);
      t.indentation[j] = x * x;
      t.rate[j] = Base::value(scene, row(F::rate, j), j, place);
    }
    t.time = Base::value(scene, F::time, 0, place);
  }

 private:
  typename Base::Number noise_root_;
  Vec clearance_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
