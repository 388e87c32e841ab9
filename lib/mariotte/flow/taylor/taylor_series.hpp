// The expansions of a row, in one block of registers, and of contacts linked in any way, in many blocks.
#pragma once
#include <cmath>
#include <vector>

#include "mariotte/flow/taylor/taylor_block.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

inline double pace_start(const Lanes& lanes, int owner) {
  if (owner == Expansion::plain) return 0;
  if (!lanes.widened) return __builtin_sqrt(lanes.indentation[owner]);
  const double u = lanes.width[owner];
  return 4 * u * u * u / lanes.branch[owner]->curve.radius - lanes.branch[owner]->curve.s;
}

template <int N>
class RowSeries final : public Expansion {
 public:
  void expand(const Lanes& lanes, int order, int clock) override {
    order_ = order;
    block_.start(lanes, order, clock, pace_start(lanes, clock));
    block_.with_series(
        [&](auto& series) { series.expand_states(block_.start_states(), block_.parameter_values(), order); });
  }
  void sizes(int first, double* size) const override {
    for (int k = first; k <= order_; ++k) size[k - first] = block_.size_of(k);
  }
  void evaluate(double place, Values& values) const override {
    values.may_fall = values.is_deep = values.may_change = false;
    block_.evaluate(place, values);
    values.time = block_.time_at(place);
  }
  void sharpen(double place, Values& values) const override {
    values.may_fall = false;
    block_.sharpen(place, values);
  }
  void coefficients(Quantity quantity, int lane, double* c) const override {
    block_.coefficients(quantity, lane, c);
  }

 private:
  int order_ = 0;
  Block<N, Given::by_neighbours> block_;
};

/// Order by order: every block finds the forces of its contacts, then these accelerate all contacts.
class LinkedSeries final : public Expansion {
 public:
  void expand(const Lanes& lanes, int order, int clock) override {
    lanes_ = &lanes;
    order_ = order;
    clock_ = clock;
    make_blocks();
    find_pushes();
    for (auto& block : blocks_) {
      block.start(lanes, order, clock, pace_start(lanes, clock));
      block.with_series([&](auto& series) { block.begin(series); });
    }
    accelerate(0);
    for (int k = 1; k < order; ++k) {
      for (auto& block : blocks_) block.with_series([&](auto& series) { series.stage(k); });
      accelerate(k);
    }
  }
  void sizes(int first, double* size) const override {
    for (int k = first; k <= order_; ++k) {
      double most = 0;
      for (const auto& block : blocks_) {
        const double size_here = block.size_of(k);
        most = size_here > most ? size_here : most;
      }
      size[k - first] = most;
    }
  }
  void evaluate(double place, Values& values) const override {
    values.may_fall = values.is_deep = values.may_change = false;
    for (const auto& block : blocks_) block.evaluate(place, values);
    values.time = blocks_[0].time_at(place);
  }
  void sharpen(double place, Values& values) const override {
    values.may_fall = false;
    for (const auto& block : blocks_) block.sharpen(place, values);
  }
  void coefficients(Quantity quantity, int lane, double* c) const override {
    blocks_[lane / Part::size].coefficients(quantity, lane, c);
  }

 private:
  static constexpr int parts = 8 / width;
  using Part = Block<parts, Given::from_outside>;

  void make_blocks() {
    const int needed = (lanes_->count + Part::size - 1) / Part::size;
    blocks_.resize(needed);
    for (int i = 0; i < needed; ++i) blocks_[i].move_to(i * Part::size);
    push_.resize(needed);
    bend_.assign(needed, LaneVector<parts>(0.0));  // idle lanes rest
  }

  /// Of what lanes do to each other only that of contacts which push.
  void find_pushes() {
    const auto& [first, lane, weight] = lanes_->links;
    pushes_.clear();
    end_of_.clear();
    for (int j = 0; j < lanes_->count; ++j) {
      for (int i = first[j]; i < first[j + 1]; ++i)
        if (lanes_->active[lane[i]] > 0) pushes_.push_back({lane[i], weight[i]});
      end_of_.push_back(pushes_.size());
    }
  }

  /// What those from `first` to `end` do to one lane. Two sums side by side: one would wait for itself.
  double bend_by(std::size_t first, std::size_t end, const double* impulse) const {
    double even = 0, odd = 0;
    for (; first + 1 < end; first += 2) {
      even += pushes_[first].weight * impulse[pushes_[first].by];
      odd += pushes_[first + 1].weight * impulse[pushes_[first + 1].by];
    }
    return first < end ? even + pushes_[first].weight * impulse[pushes_[first].by] + odd : even + odd;
  }

  /// δ̇ and the clock, order k + 1, from the forces of order k.
  void accelerate(int k) {
    const double share = series::reciprocal.of[k + 1], pace = clock_of(k);
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      push_[i] = blocks_[i].coefficient(RowQuantities::impulse, k + 1);
    const auto* impulse = reinterpret_cast<const double*>(push_.data());
    auto* bend = reinterpret_cast<double*>(bend_.data());
    std::size_t first = 0;
    for (int j = 0; j < lanes_->count; ++j) {
      bend[j] = share * pace * lanes_->drive[j] + bend_by(first, end_of_[j], impulse);
      first = end_of_[j];
    }
    for (int j = 0; lanes_->bend && j < lanes_->count; ++j)
      bend[j] += share * lanes_->bend[k * lanes_->count + j];
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      blocks_[i].coefficient(RowQuantities::rate, k + 1) = bend_[i];
    if (clock_ == plain) return;
    const LaneVector<parts> quickening(share * growth_of_owner(k));
    for (auto& block : blocks_) block.coefficient(RowQuantities::clock, k + 1) = quickening;
  }
  double clock_of(int k) const {
    return clock_ == plain ? k == 0 : blocks_[0].at(RowQuantities::clock, k, 0);
  }
  /// Of the rate of the clock.
  double growth_of_owner(int k) const {
    const auto& block = blocks_[clock_ / Part::size];
    return lanes_->widened ? block.at(WidthQuantities::growth, k, clock_)
                           : 0.5 * block.at(RowQuantities::rate, k, clock_);
  }

  struct Push {
    int by;
    double weight;
  };

  const Lanes* lanes_ = nullptr;
  int order_ = 0, clock_ = plain;
  std::vector<Part> blocks_;
  std::vector<Push> pushes_;                    ///< on one lane after the other
  std::vector<std::size_t> end_of_;             ///< of each lane, in `pushes_`
  std::vector<LaneVector<parts>> push_, bend_;  ///< order k + 1 of impulses and of δ̇
};

/// The series of lane_sizes[size] lanes, or of linked ones.
template <std::size_t Size = 0>
inline std::unique_ptr<Expansion> make(std::size_t size) {
  if constexpr (Size < lane_sizes.size())
    return size == Size ? std::unique_ptr<Expansion>(new RowSeries<(lane_sizes[Size] + width - 1) / width>)
                        : make<Size + 1>(size);
  else
    return std::unique_ptr<Expansion>(new LinkedSeries);
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
