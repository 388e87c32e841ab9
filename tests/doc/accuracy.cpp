// Prints the table of the README: worst error of the final velocities, relative to the largest incident
// speed, against the accuracy asked for. Fails if an error is larger than what was asked.
#include <cstdio>
#include <functional>

#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr double asked[] = {1e-6, 1e-8, 1e-10, 1e-12};

struct Family {
  const char* name;
  const char* file;
  std::function<bool(const nlohmann::json&)> belongs;
  std::function<model::Chain(const nlohmann::json&)> chain;
};

bool all(const nlohmann::json&) {
  return true;
}
model::Chain equal(const nlohmann::json& c) {
  return equal_chain(c.at("n"));
}
model::Chain big_ball(const nlohmann::json& c) {
  return big_ball_chain(c.at("radius"));
}
model::Chain damped(const nlohmann::json& c) {
  return equal_masses({viscoelastic(c), viscoelastic(c)}, {1, 0, 0});
}

const Family families[] = {
    {"3 balls, linear or Hertz contacts, stiffness ratios 0.01 to 100", "triplets.json", all, triplet},
    {"3 balls, linear contacts, ratios 0.01 to 10⁸", "linear_triplets.json", all, linear_triplet},
    {"3 to 21 equal Hertz balls", "equal_chains.json", all, equal},
    {"Hertz chains with one big ball", "big_ball_chains.json", all, big_ball},
    {"3 balls, damped contacts", "viscoelastic.json", [](const auto& c) { return c.contains("final"); },
     damped},
};

double error(const model::Chain& chain, const nlohmann::json& c, double accuracy) {
  double speed = 0;
  for (const double velocity : chain.velocity) speed = std::max(speed, std::abs(velocity));
  return difference(impact::simulate(chain, {.accuracy = accuracy}).velocity, c.at("final")) / speed;
}

}  // namespace

int main() {
  bool kept = true;
  std::printf("| worst error when asked for | cases |");
  for (const double accuracy : asked) std::printf(" %.0e |", accuracy);
  std::printf("\n|---|---|---|---|---|---|\n");
  for (const auto& family : families) {
    int number = 0;
    double worst[std::size(asked)] = {};
    for (const auto& c : cases(family.file)) {
      if (!family.belongs(c)) continue;
      ++number;
      for (std::size_t i = 0; i < std::size(asked); ++i)
        worst[i] = std::max(worst[i], error(family.chain(c), c, asked[i]));
    }
    std::printf("| %s | %d |", family.name, number);
    for (std::size_t i = 0; i < std::size(asked); ++i) {
      std::printf(" %.0e |", worst[i]);
      kept = kept && worst[i] <= asked[i];
    }
    std::printf("\n");
  }
  return kept ? 0 : 1;
}
