#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/model/network/network.hpp"

namespace mariotte::model {
namespace {

double squared_distance(const Ball& a, const Ball& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.position.size(); ++k) {
    const double d = b.position[k] - a.position[k];
    sum += d * d;
  }
  return sum;
}

/// Numbers of the balls along the first coordinate.
std::vector<Index> in_order(const std::vector<Ball>& balls) {
  std::vector<Index> order(balls.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto x = [&](Index i) { return balls[i].position[0]; };
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return x(i) < x(j); });
  return order;
}

}  // namespace

std::vector<BallPair> near_pairs(const std::vector<Ball>& balls, double reach) {
  double largest = 0, extent = 0;
  for (const auto& ball : balls) {
    largest = std::max(largest, ball.radius);
    for (const double x : ball.position) extent = std::max(extent, std::abs(x));
  }
  const double beyond = reach + 1e-9 * largest + 32 * epsilon * extent;  // by rounding of positions
  const auto order = in_order(balls);
  std::vector<BallPair> pairs;
  for (auto i = order.begin(); i != order.end(); ++i)
    for (auto j = i + 1; j != order.end(); ++j) {
      const auto &a = balls[*i], &b = balls[*j];
      const double near = beyond + a.radius + b.radius;
      if (b.position[0] - a.position[0] > beyond + a.radius + largest) break;
      if (squared_distance(a, b) <= near * near) pairs.push_back({std::min(*i, *j), std::max(*i, *j)});
    }
  std::sort(pairs.begin(), pairs.end(), [](const BallPair& a, const BallPair& b) {
    return std::pair(a.left, a.right) < std::pair(b.left, b.right);
  });
  return pairs;
}

}  // namespace mariotte::model
