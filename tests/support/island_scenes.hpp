// Random chains of 3 to 60 balls whose parts move on their own for a while: always the same ones.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::test {

enum class IslandScene {
  struck_row,
  gaps,
  several_waves,
  between_walls,
  column_on_a_wall,
  damped,
  all_moving,
  precompressed,
  linear,
  equal_balls
};
inline constexpr int island_scene_kinds = 10;

class IslandSceneMaker {
 public:
  explicit IslandSceneMaker(unsigned seed) : random_(seed) {}

  model::Chain make(IslandScene kind) {
    const int n = whole(3, 60);
    chain_ = {.mass = std::vector<double>(n, 1.0),
              .law = std::vector<contact::Law>(n - 1, contact::Hertz{1}),
              .gap = std::vector<double>(n - 1, 0.0),
              .velocity = std::vector<double>(n, 0.0)};
    fill(kind, n);
    return chain_;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  double decades(double count) { return std::pow(10.0, uniform(-count / 2, count / 2)); }

  void vary_masses(double count) {
    for (double& m : chain_.mass) m = decades(count);
  }
  void open_half(double widest) {
    for (double& gap : chain_.gap) gap = uniform(0, 1) < 0.5 ? 0 : uniform(0, widest);
  }
  void fix(int ball) { chain_.mass[ball] = infinity; }

  void fill(IslandScene kind, int n) {
    auto& v = chain_.velocity;
    switch (kind) {
      case IslandScene::struck_row:
        v[0] = 1;
        return vary_masses(1);
      case IslandScene::gaps:
        v[0] = 1;
        vary_masses(2);
        return open_half(2);
      case IslandScene::several_waves:
        for (int k = 0; k < 3; ++k) v[whole(0, n - 1)] = uniform(-1, 1);
        vary_masses(1);
        return open_half(1);
      case IslandScene::between_walls:
        fix(0);
        fix(n - 1);
        v[whole(1, n - 2)] = 1;
        return open_half(1);
      case IslandScene::column_on_a_wall:
        fix(0);
        std::fill(v.begin() + 1, v.end(), -1.0);
        if (uniform(0, 1) < 0.5) open_half(0.5);
        chain_.gap[0] = 1;
        chain_.gravity = uniform(0, 1) < 0.5 ? 0 : 0.3;
        return;
      case IslandScene::damped:
        v[0] = 1;
        vary_masses(1);
        open_half(1);
        for (auto& law : chain_.law)
          law = contact::Viscoelastic{decades(2), 0.3 * decades(2), uniform(0, 1) < 0.5 ? 1.5 : 1.0};
        return;
      case IslandScene::all_moving:
        for (double& speed : v) speed = uniform(-1, 1);
        vary_masses(1);
        return open_half(2);
      case IslandScene::precompressed: {
        chain_.precompressed = true;
        const int from = whole(0, n - 2), to = std::min(n - 2, from + whole(1, 10));
        for (int j = from; j <= to; ++j) chain_.gap[j] = -uniform(0.1, 0.5);
        return;
      }
      case IslandScene::linear:
        v[0] = 1;
        vary_masses(1);
        open_half(1);
        for (auto& law : chain_.law) law = contact::Linear{decades(1)};
        return;
      case IslandScene::equal_balls:
        for (double& speed : v) speed = std::round(2 * uniform(-1, 1)) / 2;
    }
  }

  std::mt19937_64 random_;
  model::Chain chain_;
};

}  // namespace mariotte::test
