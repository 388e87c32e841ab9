#include "mariotte/flow/cluster/cluster_series.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/series/unrolled.hpp"

namespace mariotte::flow {

using Field = ClusterField;
using Kind = ClusterClock::Kind;

void ClusterSeries::expand(const Cluster& cluster, const ClusterClock& clock, int order) {
  cluster_ = &cluster;
  of_ = clock;
  order_ = order;
  make_room();
  start_balls();
  start_pushes();
  start_lanes();
  couple(0);
  for (int k = 1; k < order; ++k) {
    for (std::size_t i = 0; i < blocks_; ++i) block_[i]->stage(k);
    couple(k);
  }
  for (std::size_t i = 0; i < blocks_; ++i) block_[i]->finish(order);
  look();
}

void ClusterSeries::make_room() {
  const std::size_t links = cluster_->link.size();
  blocks_ = (links + LaneBlock::lanes - 1) / LaneBlock::lanes;
  while (block_.size() < blocks_) block_.push_back(make_lane_block());
  lane_.clear();
  for (std::size_t j = 0; j < blocks_ * LaneBlock::lanes; ++j)
    lane_.push_back(block_[j / LaneBlock::lanes]->at(0, 0) + j % LaneBlock::lanes);
  ball_.resize(3 * cluster_->ball.size());
  shift_.resize(2 * cluster_->ball.size());
  for (auto& row : shift_) row[0] = NAN;
  seen_.resize(seen.size() * links);
}

void ClusterSeries::start_balls() {
  for (std::size_t i = 0; i < cluster_->ball.size(); ++i) {
    const auto& ball = cluster_->ball[i];
    ball_[3 * i][0] = ball.velocity_x;
    ball_[3 * i + 1][0] = ball.velocity_y;
    ball_[3 * i + 2][0] = ball.spin;
  }
}

void ClusterSeries::start_lanes() {
  constexpr int lanes = LaneBlock::lanes;
  alignas(64) double starts[Field::states * lanes], parameters[Field::parameters * lanes];
  const auto& link = cluster_->link;
  clock_[0] = of_.kind == Kind::time   ? 1
              : of_.kind == Kind::root ? std::sqrt(link[of_.owner].start[Field::depth])
                                       : 0;
  for (std::size_t j = 0; j < lane_.size(); ++j) {
    start_lane(j < link.size() ? link[j] : ClusterLink{}, static_cast<int>(j), starts + j % lanes,
               parameters + j % lanes);
    if (j % lanes == lanes - 1) block_[j / lanes]->begin(starts, parameters);
  }
}

void ClusterSeries::start_lane(const ClusterLink& link, int lane, double* start, double* parameters) const {
  constexpr int lanes = LaneBlock::lanes;
  for (int i = 0; i < Field::states; ++i) start[i * lanes] = link.start[i];
  for (int i = 0; i < Field::parameters; ++i) parameters[i * lanes] = link.parameter[i];
  const bool owns = of_.kind == Kind::root && of_.owner == lane;
  const bool given = owns || (of_.kind == Kind::onset && link.begins && link.has_root);
  const bool curved = link.has_root && !given;
  start[Field::clock * lanes] = clock_[0];
  start[Field::root * lanes] = given ? clock_[0] : 0;
  parameters[Field::given * lanes] = given;
  parameters[Field::found * lanes] = !given;
  parameters[Field::curved * lanes] = curved;
  parameters[Field::level * lanes] = !curved;
}

/// Order k + 1 of all that is given.
void ClusterSeries::couple(int k) {
  const double growth = of_.kind == Kind::root    ? 0.5 * at(Field::approach, of_.owner, k)
                        : of_.kind == Kind::onset ? 2.0 * (k == 0)
                                                  : 0.0;
  clock_[k + 1] = growth / (k + 1);
  time_[k + 1] = clock_[k] / (k + 1);
  push_balls(k + 1);
  move_links(k + 1);
  give_roots(k + 1);
}

void ClusterSeries::start_pushes() {
  push_.clear();
  const auto add = [&](std::size_t link, int ball, double sign, double radius, double share) {
    const auto& one = cluster_->ball[ball];
    push_.push_back(
        {&ball_[3 * ball], lane_[link], sign * one.ease, one.turn_ease * radius, one.turn_ease * share});
  };
  for (std::size_t j = 0; j < cluster_->link.size(); ++j) {
    const auto& link = cluster_->link[j];
    add(j, link.b, 1, link.radius_b, link.share_b);
    if (link.a >= 0) add(j, link.a, -1, link.radius_a, link.share_a);
  }
}

/// What contacts have done to the balls, and outside forces.
void ClusterSeries::push_balls(int k) {
  constexpr int stride = LaneBlock::stride;
  for (std::size_t i = 0; i < ball_.size(); i += 3) {
    ball_[i][k] = cluster_->pull_x * time_[k];
    ball_[i + 1][k] = cluster_->pull_y * time_[k];
    ball_[i + 2][k] = 0;
  }
  for (const auto& push : push_) {
    const double* lane = push.lane + k * LaneBlock::lanes;
    push.ball[0][k] += push.ease * lane[Field::impulse_x * stride];
    push.ball[1][k] += push.ease * lane[Field::impulse_y * stride];
    push.ball[2][k] -= push.turn * lane[Field::tangential * stride];
    push.ball[2][k] += push.turn_share * lane[Field::moment * stride];
  }
}

void ClusterSeries::move_links(int k) {
  constexpr int stride = LaneBlock::stride;
  for (std::size_t j = 0; j < cluster_->link.size(); ++j) {
    const auto& one = cluster_->link[j];
    const Row* b = &ball_[3 * one.b];
    double x = b[0][k], y = b[1][k], spins = one.radius_b * b[2][k], shared = one.share_b * b[2][k];
    if (one.a >= 0) {
      const Row* a = &ball_[3 * one.a];
      x -= a[0][k], y -= a[1][k];
      spins += one.radius_a * a[2][k], shared += one.share_a * a[2][k];
    }
    double* lane = lane_[j] + k * LaneBlock::lanes;
    lane[Field::velocity_x * stride] = x;
    lane[Field::velocity_y * stride] = y;
    lane[Field::spins * stride] = spins;
    lane[Field::shared * stride] = shared;
  }
}

void ClusterSeries::give_roots(int k) {
  const auto& link = cluster_->link;
  for (std::size_t i = 0; i < blocks_; ++i)
    std::fill_n(block_[i]->at(Field::clock, k), LaneBlock::lanes, clock_[k]);
  if (of_.kind == Kind::root) at(Field::root, of_.owner, k) = clock_[k];
  if (of_.kind != Kind::onset) return;
  for (int j = 0; j < std::ssize(link); ++j)
    if (link[j].begins && link[j].has_root) give_onset(j, k);
}

/// Where t = τ², δ is known an order ahead: δ' = 2 τ w.
void ClusterSeries::give_onset(int link, int k) {
  double left = 2 * at(Field::approach, link, k - 1) / (k + 1);
  for (int i = 2; i < k; ++i) left -= at(Field::root, link, i) * at(Field::root, link, k + 1 - i);
  at(Field::root, link, k) = k == 1 ? std::sqrt(left) : left / (2 * at(Field::root, link, 1));
}

/// Rows side by side become rows of their own.
void ClusterSeries::look() {
  const auto& link = cluster_->link;
  for (int j = 0; j < std::ssize(link); ++j)
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (int k = 0; k <= order_; ++k) seen_[j * seen.size() + i][k] = at(seen[i], j, k);
}

std::span<const double> ClusterSeries::row(int which, int link) const {
  const auto place = std::find(seen.begin(), seen.end(), which) - seen.begin();
  return part(seen_[link * seen.size() + place]);
}

/// n·Δ + Δ²/2|d|.
void ClusterSeries::change(const ClusterGap& gap, std::span<double> row) {
  const double velocity[] = {gap.velocity_x, gap.velocity_y};
  Row move[2];
  for (int axis = 0; axis < 2; ++axis) {
    move[axis] = shift(gap.b, axis);
    const Row& other = gap.a < 0 ? time_ : shift(gap.a, axis);
    const double share = gap.a < 0 ? velocity[axis] : 1;
    for (int k = 1; k <= order_; ++k) move[axis][k] -= share * other[k];
  }
  for (int k = 1; k <= order_; ++k) {
    row[k] = gap.normal_x * move[0][k] + gap.normal_y * move[1][k];
    for (int i = 1; i < k && gap.bend > 0; ++i)
      row[k] += gap.bend * (move[0][i] * move[0][k - i] + move[1][i] * move[1][k - i]);
  }
}

double ClusterSeries::least_rate(const ClusterGap& gap, double place) const {
  const auto rate = [&](int k) {
    double x = ball_[3 * gap.b][k], y = ball_[3 * gap.b + 1][k];
    if (gap.a >= 0) x -= ball_[3 * gap.a][k], y -= ball_[3 * gap.a + 1][k];
    return gap.normal_x * x + gap.normal_y * y;
  };
  double most = 0;
  for (int k = order_; k > 0; --k) most = (most + std::abs(rate(k))) * place;
  return rate(0) - (gap.normal_x * gap.velocity_x + gap.normal_y * gap.velocity_y) - most;
}

/// How far a ball has gone; found when somebody asks.
const ClusterSeries::Row& ClusterSeries::shift(int ball, int axis) {
  auto& row = shift_[2 * ball + axis];
  if (!std::isnan(row[0])) return row;
  row[0] = 0;
  for (int k = 1; k <= order_; ++k) {
    double sum = 0;
    for (int i = 0; i < k; ++i) sum += ball_[3 * ball + axis][i] * clock_[k - 1 - i];
    row[k] = sum / k;
  }
  return row;
}

double ClusterSeries::size(int k) const {
  const auto& ball = cluster_->ball;
  const auto& link = cluster_->link;
  double most = 0;
  const auto take = [&](double value, double weight) { most = std::max(most, std::abs(value) * weight); };
  for (std::size_t i = 0; i < ball.size(); ++i) {
    take(ball_[3 * i][k], ball[i].velocity_weight);
    take(ball_[3 * i + 1][k], ball[i].velocity_weight);
    take(ball_[3 * i + 2][k], ball[i].spin_weight);
  }
  for (int j = 0; j < std::ssize(link); ++j)
    for (const int row :
         {Field::depth, Field::spring, Field::normal, Field::tangential, Field::work, Field::force})
      take(at(row, j, k), link[j].weight[row]);
  return most;
}

double ClusterSeries::sum(int row, int link, double place) const {
  double total = 0;
  for (int k = order_; k >= 0; --k) total = total * place + at(row, link, k);
  return total;
}

/// ∫ σᵏ dt up to a place.
ClusterSeries::Row ClusterSeries::spans(double place) const {
  Row span;
  double power = place;
  for (int k = 0; k <= order_; ++k, power *= place) {
    span[k] = 0;
    for (int j = order_; j >= 0; --j)
      span[k] = span[k] * place + series::reciprocal.of[j + k + 1] * clock_[j];
    span[k] *= power;
  }
  return span;
}

void ClusterSeries::move(double place, ClusterMotion& motion) const {
  const Row span = spans(place);
  const auto gone = [&](std::size_t row) {
    return std::inner_product(span.begin(), span.begin() + order_ + 1, ball_[row].begin(), 0.0);
  };
  const auto now = [&](std::size_t row) { return horner(part(ball_[row]), place); };
  motion.time = horner(time(), place);
  motion.ball.clear();
  motion.link.clear();
  for (std::size_t i = 0; i < ball_.size(); i += 3)
    motion.ball.push_back({gone(i), gone(i + 1), gone(i + 2), now(i), now(i + 1), now(i + 2)});
  for (int j = 0; j < std::ssize(cluster_->link); ++j)
    motion.link.push_back({sum(Field::depth, j, place), sum(Field::spring, j, place),
                           sum(Field::normal, j, place), sum(Field::tangential, j, place),
                           sum(Field::work, j, place)});
}

}  // namespace mariotte::flow
