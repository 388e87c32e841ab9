// What `mariotte run` does, from C++: read a scene with units, simulate it, write its result.
#include <cstdio>

#include "mariotte/mariotte.hpp"
#include "mariotte/scene.hpp"

using namespace mariotte;

namespace {

constexpr const char* two_balls = R"(
title = "A steel ball strikes a larger one"
[chain]
radius   = ["10 mm", "20 mm"]
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law      = "hertz"
velocity = ["1 m/s", 0]
)";

/// One case per kind of result: a missing one does not compile.
double duration(const scene::Impact& impact) {
  return std::visit(Overload{[](const impact::ContactImpact& contacts) { return contacts.time; },
                             [](const impact::MicrobodyImpact& body) { return body.final.time; },
                             [](const impact::BodiesImpact& bodies) { return bodies.time; }},
                    impact);
}

}  // namespace

int main() try {
  // scene::read(path) does the same with a file. What follows are values that go before those of the scene.
  const auto scene = scene::parse(two_balls, "two_balls.toml", {"run.accuracy=1e-12"});
  const auto impact = scene::simulate(scene);
  std::printf("%s: %.3f µs\n", scene.title.c_str(), 1e6 * duration(impact));
  std::printf("%s", report::events_text(impact).c_str());
  const auto json = report::json_text(impact, scene);  // as of `mariotte run --json`
  std::printf("%s\n", json.substr(0, json.find('\n', 2)).c_str());
} catch (const Error& problem) {
  std::fprintf(stderr, "%s\n", problem.what());
  return 1;
}
