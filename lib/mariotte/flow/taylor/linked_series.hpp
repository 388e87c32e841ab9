// The expansion of contacts linked in any way, or of long rows, in many blocks of registers.
#pragma once
#include <vector>

#include "mariotte/flow/taylor/row_pushes.hpp"
#include "mariotte/flow/taylor/taylor_block.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// Order by order every block in which a contact pushes finds the forces of its contacts, then these
/// accelerate all of these contacts. Where they are linked in any way, blocks in which none pushes follow one
/// after the other when all orders are known.
class LinkedSeries final : public Expansion {
 public:
  Outlook activate(Lanes& lanes, double near, bool onsets) const override {
    Outlook all{};
    for (int first = 0; first < lanes.count; first += at_once) {
      const auto some = MARIOTTE_INSTRUCTION_SET::activate<parts>(lanes, first, near, onsets);
      all = {all.may_land || some.may_land, all.is_sudden || some.is_sudden};
    }
    return all;
  }
  void expand(const Lanes& lanes, int order, int clock) override {
    lanes_ = &lanes;
    order_ = order;
    clock_ = clock;
    make_blocks();
    for (auto& block : blocks_) {
      block.start(lanes, order, clock, pace_start(lanes, clock));
      block.with_series([&](auto& series) { block.begin(series); });
    }
    if (lanes.linked) find_pushes();
    accelerate(0);
    for (int k = 1; k < order; ++k) {
      for (auto& block : blocks_)
        if (is_along(block)) block.with_series([&](auto& series) { series.stage(k); });
      accelerate(k);
    }
    if (!lanes.linked) return;
    list_impulses();
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      if (!is_along(blocks_[i])) follow(i);
  }
  void sizes(int first, double* size) const override {
    for (int k = first; k <= order_; ++k) {
      double most = 0;
      for (const auto& block : blocks_) {
        const double size_here = block.motion().size_of(k);
        most = size_here > most ? size_here : most;
      }
      size[k - first] = most;
    }
  }
  void evaluate(double place, Values& values) const override {
    values.may_fall = values.is_deep = values.may_change = false;
    for (const auto& block : blocks_) block.motion().evaluate(place, values);
    values.time = blocks_[0].motion().time_at(place);
  }
  void sharpen(double place, Values& values) const override {
    values.may_fall = false;
    for (const auto& block : blocks_) block.motion().sharpen(place, values);
  }
  void coefficients(Quantity quantity, int lane, double* c) const override {
    blocks_[lane / at_once].motion().coefficients(quantity, lane, c);
  }

 private:
  static constexpr int parts = 8 / width;
  using Part = Block<parts, Given::from_outside>;
  static constexpr int at_once = parts * width;  ///< lanes of a block
  static constexpr int most_orders = (order_limit + 7) / 8 * 8;
  using Orders = LaneVector<most_orders / width>;  ///< 1, 2, …

  void make_blocks() {
    const int needed = (lanes_->count + at_once - 1) / at_once;
    blocks_.resize(needed);
    for (int i = 0; i < needed; ++i) blocks_[i].move_to(i * at_once);
    is_driven_ = lanes_->bend;
    for (int j = 0; j < lanes_->count; ++j) is_driven_ |= lanes_->drive[j] != 0;
    row_.resize(lanes_->linked ? 0 : needed);
    push_.resize(lanes_->linked ? needed : 0);
    bend_.resize(needed);
    impulses_.resize(lanes_->linked ? needed * at_once : 0);
  }
  /// Expanded order by order beside the others.
  bool is_along(const Part& block) const { return !lanes_->linked || !block.is_still(); }

  /// Of what lanes do to each other only that of contacts which push. Each takes the place of one before that
  /// does not: to ask would cost more.
  void find_pushes() {
    const auto& [first, lane, weight] = lanes_->links;
    pushing_.assign(lanes_->count, 0);
    for (int j = 0; j < lanes_->count; ++j)
      pushing_[j] = lanes_->active[j] > 0 && !blocks_[j / at_once].is_still();
    pushes_.resize(first[lanes_->count] + 1);
    first_push_.assign(1, 0);
    int found = 0;
    for (int j = 0; j < lanes_->count; ++j) {
      for (int i = first[j]; i < first[j + 1]; ++i) {
        pushes_[found] = {lane[i], weight[i]};
        found += pushing_[lane[i]];
      }
      first_push_.push_back(found);
    }
  }

  /// One after the last lane of a block.
  int end_of(std::size_t block) const {
    const int end = (static_cast<int>(block) + 1) * at_once;
    return end < lanes_->count ? end : lanes_->count;
  }

  /// δ̇ and the clock, order k + 1, from the forces of order k.
  void accelerate(int k) {
    lanes_->linked ? bend_linked(k) : bend_row(k);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!is_along(blocks_[i])) continue;
      blocks_[i].coefficient(RowQuantities::rate, k + 1) = bend_[i];
      if (clock_ != plain) set_clock(blocks_[i], k + 1, series::reciprocal.of[k + 1] * growth_of_owner(k));
    }
  }
  void bend_row(int k) {
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      row_.set(i, *lanes_, blocks_[i].is_still() ? LaneVector<parts>(0.0) : impulse(i, k + 1));
    for (std::size_t i = 0; i < blocks_.size(); ++i) bend_[i] = row_.bend(i, *lanes_);
    add_from_outside(k);
  }
  void bend_linked(int k) {
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      if (is_along(blocks_[i])) push_[i] = impulse(i, k + 1), bend_[i] = LaneVector<parts>(0.0);
    const auto* impulse = reinterpret_cast<const double*>(push_.data());
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      for (int j = static_cast<int>(i) * at_once; is_along(blocks_[i]) && j < end_of(i); ++j)
        of_lane(bend_[i], j % at_once) = bend_by(j, impulse);
    add_from_outside(k);
  }
  const LaneVector<parts>& impulse(std::size_t i, int k) {
    return blocks_[i].coefficient(RowQuantities::impulse, k);
  }
  void add_from_outside(int k) {
    if (!is_driven_ || (!lanes_->bend && clock_of(k) == 0)) return;
    for (int j = 0; j < lanes_->count; ++j)
      of_lane(bend_[j / at_once], j % at_once) += bend_from_outside(k, j);
  }
  double bend_from_outside(int k, int lane) const {
    if (!is_driven_) return 0;
    const double more = lanes_->bend ? lanes_->bend[k * lanes_->count + lane] : 0;
    return series::reciprocal.of[k + 1] * (clock_of(k) * lanes_->drive[lane] + more);
  }
  /// What the impulses of one order do to a lane. Two sums side by side: one would wait for itself.
  double bend_by(int lane, const double* impulse) const {
    const auto *push = pushes_.data() + first_push_[lane], *end = pushes_.data() + first_push_[lane + 1];
    double even = 0, odd = 0;
    for (; push + 1 < end; push += 2) {
      even += push[0].weight * impulse[push[0].by];
      odd += push[1].weight * impulse[push[1].by];
    }
    return push < end ? even + push->weight * impulse[push->by] + odd : even + odd;
  }
  /// Of a number that holds many lanes.
  static double& of_lane(auto& number, int lane) { return reinterpret_cast<double*>(&number)[lane]; }
  static void set_clock(Part& block, int k, double rate) {
    block.coefficient(RowQuantities::clock, k) = LaneVector<parts>(rate);
  }
  const Part& owner() const { return blocks_[clock_ / at_once]; }
  double clock_of(int k) const {
    return clock_ == plain ? k == 0 : owner().motion().at(RowQuantities::clock, k, clock_);
  }
  /// Of the rate of the clock.
  double growth_of_owner(int k) const {
    return lanes_->widened ? owner().motion().at(WidthQuantities::growth, k, clock_)
                           : 0.5 * owner().motion().at(RowQuantities::rate, k, clock_);
  }

  /// By lane, of those that push.
  void list_impulses() {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (blocks_[i].is_still()) continue;
      for (int k = 1; k <= order_; ++k) {
        auto& of_lanes = blocks_[i].coefficient(RowQuantities::impulse, k);
        for (int lane = 0; lane < at_once; ++lane)
          at(impulses_[i * at_once + lane], k) = of_lane(of_lanes, lane);
      }
    }
  }
  static double& at(Orders& orders, int k) { return of_lane(orders, k - 1); }

  /// A block in which no contact pushes.
  void follow(std::size_t i) {
    auto& block = blocks_[i];
    const int first = static_cast<int>(i) * at_once;
    for (int lane = 0; lane < at_once; ++lane) {
      auto bend = first + lane < lanes_->count ? bend_of(first + lane) : Orders(0.0);
      for (int k = 1; k <= order_; ++k)
        of_lane(block.coefficient(RowQuantities::rate, k), lane) = at(bend, k);
    }
    for (int k = 1; clock_ != plain && k <= order_; ++k) set_clock(block, k, clock_of(k));
    block.with_series([&](auto& series) {
      for (int k = 1; k < order_; ++k) series.stage(k);
    });
  }
  /// All orders of the rate of a lane.
  Orders bend_of(int lane) const {
    Orders bend(0.0);
    for (int p = first_push_[lane]; p < first_push_[lane + 1]; ++p)
      bend = bend + pushes_[p].weight * impulses_[pushes_[p].by];
    for (int k = 1; k <= order_; ++k) at(bend, k) += bend_from_outside(k - 1, lane);
    return bend;
  }

  struct Push {
    int by;
    double weight;
  };

  const Lanes* lanes_ = nullptr;
  int order_ = 0, clock_ = plain;
  bool is_driven_ = false;  ///< some lane is accelerated from outside
  std::vector<Part> blocks_;
  std::vector<char> pushing_;                   ///< lanes
  std::vector<Push> pushes_;                    ///< on one lane after the other
  std::vector<int> first_push_;                 ///< on each lane
  RowPushes<parts> row_;                        ///< of a row
  std::vector<LaneVector<parts>> push_, bend_;  ///< order k + 1 of impulses and of δ̇
  std::vector<Orders> impulses_;                ///< of each lane that pushes
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
