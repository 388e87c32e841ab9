// Taylor series of a cluster of balls: contacts in lanes, coupled order by order through what they do to the
// balls.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "mariotte/flow/cluster/cluster_phase.hpp"
#include "mariotte/flow/cluster/lane_block.hpp"

namespace mariotte::flow {

/// What a series is expanded in: time; the root √δ of a contact, dt = √δ dσ; t = τ², where contacts begin.
struct ClusterClock {
  enum class Kind { time, root, onset } kind = Kind::time;
  int owner = -1;
};

/// Keeps its memory, and the coefficients of the last expansion.
class ClusterSeries {
 public:
  static constexpr int most_order = LaneBlock::most_order;

  void expand(const Cluster& cluster, const ClusterClock& clock, int order);
  /// Largest coefficient k over its size.
  double size(int k) const;
  /// Coefficients of a row of `ClusterField` that is looked at: depth, approach, yielding, force, friction.
  std::span<const double> row(int which, int link) const;
  /// Coefficients from 1 on of a polynomial that begins `beyond` an offset of a gap, and goes on with its
  /// sign.
  void change(const ClusterGap& gap, std::span<double> row);
  /// What the rate of a gap, along its normal at the beginning, is no less than up to a place.
  double least_rate(const ClusterGap& gap, double place) const;
  std::span<const double> clock() const { return part(clock_); }
  std::span<const double> time() const { return part(time_); }
  /// Velocity by axis, then spin.
  std::span<const double> ball(int ball, int axis) const { return part(ball_[3 * ball + axis]); }
  void move(double place, ClusterMotion& motion) const;

 private:
  using Row = std::array<double, most_order + 2>;
  static constexpr std::array seen = {int{ClusterField::depth}, int{ClusterField::approach},
                                      int{ClusterField::yielding}, int{ClusterField::force},
                                      int{ClusterField::friction}};

  std::span<const double> part(const Row& row) const {
    return {row.data(), static_cast<std::size_t>(order_) + 1};
  }
  double& at(int row, int link, int k) { return lane_[link][row * LaneBlock::stride + k * LaneBlock::lanes]; }
  double at(int row, int link, int k) const {
    return lane_[link][row * LaneBlock::stride + k * LaneBlock::lanes];
  }
  /// How a contact pushes a ball: velocities by impulse, spin by that along the tangent and its moment.
  struct Push {
    Row* ball;
    const double* lane;
    double ease, turn, turn_share;
  };
  double sum(int row, int link, double place) const;
  const Row& shift(int ball, int axis);
  Row spans(double place) const;
  void make_room();
  void start_balls();
  void start_pushes();
  void start_lanes();
  void start_lane(const ClusterLink& link, int lane, double* start, double* parameters) const;
  void couple(int k);
  void push_balls(int k);
  void move_links(int k);
  void give_roots(int k);
  void give_onset(int link, int k);
  void look();

  const Cluster* cluster_ = nullptr;
  ClusterClock of_;
  int order_ = 0;
  std::size_t blocks_ = 0;  ///< in use
  std::vector<std::unique_ptr<LaneBlock>> block_;
  std::vector<double*> lane_;  ///< where each begins
  Row clock_ = {}, time_ = {};
  std::vector<Row> ball_, seen_;
  std::vector<Push> push_;
  std::vector<Row> shift_;  ///< of balls; those that begin with no number are not known yet
};

}  // namespace mariotte::flow
