#include "mariotte/scene/missed_meetings.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::scene {
namespace {

struct Approach {
  double gap = 0;
  double meeting = infinity;  ///< when the balls would touch [s]
};

bool moves(const model::Ball& ball) {
  return std::any_of(ball.velocity.begin(), ball.velocity.end(), [](double v) { return v != 0; });
}

/// |d + w t| = R for the smaller t, with centres apart by d that change by w.
Approach approach(const model::Ball& a, const model::Ball& b) {
  double dd = 0, dw = 0, ww = 0;
  for (std::size_t k = 0; k < a.position.size(); ++k) {
    const double d = b.position[k] - a.position[k], w = b.velocity[k] - a.velocity[k];
    dd += d * d;
    dw += d * w;
    ww += w * w;
  }
  const double touching = a.radius + b.radius;
  Approach result{.gap = std::sqrt(dd) - touching};
  const double apart = dd - touching * touching, root = dw * dw - ww * apart;
  if (dw < 0 && root > 0) result.meeting = std::max(0.0, apart / (std::sqrt(root) - dw));
  return result;
}

}  // namespace

std::vector<std::pair<Index, Index>> missed_meetings(const std::vector<model::Ball>& balls, double reach) {
  std::vector<double> first(balls.size(), infinity);
  std::vector<char> moving;
  for (const auto& ball : balls) moving.push_back(moves(ball));
  const auto each_pair = [&](auto&& visit) {
    for (std::size_t i = 0; i < balls.size(); ++i)
      for (std::size_t j = i + 1; j < balls.size(); ++j)
        if (moving[i] || moving[j]) visit(i, j, approach(balls[i], balls[j]));
  };
  each_pair([&](std::size_t i, std::size_t j, const Approach& one) {
    first[i] = std::min(first[i], one.meeting);
    first[j] = std::min(first[j], one.meeting);
  });
  std::vector<std::pair<Index, Index>> missed;
  each_pair([&](std::size_t i, std::size_t j, const Approach& one) {
    if (one.gap > reach && one.meeting < infinity && one.meeting <= std::min(first[i], first[j]))
      missed.emplace_back(i, j);
  });
  return missed;
}

}  // namespace mariotte::scene
