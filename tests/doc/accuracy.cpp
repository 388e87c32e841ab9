// Prints the table of the README: worst error of the final velocities, relative to the largest incident
// speed, against the accuracy asked for. Fails if an error is larger than what was asked.
#include <cstdio>
#include <functional>

#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "support/reference.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr double asked[] = {1e-6, 1e-8, 1e-10, 1e-12};

using Json = nlohmann::json;
using Cases = Json (*)(const std::string& file);

struct Family {
  const char* name;
  Cases cases;
  const char* file;
  std::function<bool(const Json&)> belongs;
  std::function<double(const Json&, double accuracy)> error;  ///< relative to the largest incident speed
};

bool all(const Json&) {
  return true;
}
model::Chain equal(const Json& c) {
  return equal_chain(c.at("n"));
}
model::Chain big_ball(const Json& c) {
  return big_ball_chain(c.at("radius"));
}
model::Chain damped(const Json& c) {
  return equal_masses({viscoelastic(c), viscoelastic(c)}, {1, 0, 0});
}

/// The error of a chain, made from a case.
auto of_chain(model::Chain (*make)(const Json&)) {
  return [make](const Json& c, double accuracy) {
    const auto chain = make(c);
    double speed = 0;
    for (const double velocity : chain.velocity) speed = std::max(speed, std::abs(velocity));
    return difference(impact::simulate(chain, {.accuracy = accuracy}).velocity, c.at("final")) / speed;
  };
}

/// Of the velocity of a body, and of its spin as a velocity of the tip.
double of_body(const Json& c, double accuracy) {
  static impact::MicrobodySolver solver;
  const auto body = microbody(c);
  const auto& found = solver.solve(body, {.accuracy = accuracy});
  const double velocity = norm(found.velocity - vector_of(c.at("final"), 4));
  const double spin = body.body.tips[0].radius * norm(found.spin - vector_of(c.at("final"), 11));
  return std::max(velocity, spin) / speed_scale(body);
}

bool separates(const Json& c) {
  return c.contains("final");
}

const Family families[] = {
    {"3 balls, linear or Hertz contacts, stiffness ratios 0.01 to 100", cases, "triplets.json", all,
     of_chain(triplet)},
    {"3 balls, linear contacts, ratios 0.01 to 10⁸", cases, "linear_triplets.json", all,
     of_chain(linear_triplet)},
    {"3 to 21 equal Hertz balls", cases, "equal_chains.json", all, of_chain(equal)},
    {"Hertz chains with one big ball", cases, "big_ball_chains.json", all, of_chain(big_ball)},
    {"3 balls, damped contacts", cases, "viscoelastic.json", separates, of_chain(damped)},
    {"microspheres, normal incidence", body_cases, "sphere_normal.json", separates, of_body},
    {"dumbbells of length ratio 0 to 50", body_cases, "dumbbell_length.json", separates, of_body},
    {"rods tilted by 0 to 90°", body_cases, "rod_tilt.json", separates, of_body},
    {"rods and a dumbbell that move in space", body_cases, "spatial.json", all, of_body},
};

}  // namespace

int main() {
  bool kept = true;
  std::printf("| worst error when asked for | cases |");
  for (const double accuracy : asked) std::printf(" %.0e |", accuracy);
  std::printf("\n|---|---|---|---|---|---|\n");
  for (const auto& family : families) {
    int number = 0;
    double worst[std::size(asked)] = {};
    for (const auto& c : family.cases(family.file)) {
      if (!family.belongs(c)) continue;
      ++number;
      for (std::size_t i = 0; i < std::size(asked); ++i)
        worst[i] = std::max(worst[i], family.error(c, asked[i]));
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
