// A user's program: three equal balls, one impact, momentum kept; the same from a scene, and as JSON.
#include <cmath>
#include <cstdio>
#include <string>

#include "mariotte/mariotte.hpp"
#include "mariotte/scene.hpp"

using namespace mariotte;

namespace {

constexpr const char* text = R"([chain]
mass = [1, 1, 1]
velocity = [1, 0, 0]
law = "hertz"
stiffness = 1
)";

bool check(bool holds, const char* what) {
  if (!holds) std::printf("wrong: %s\n", what);
  return holds;
}

}  // namespace

int main() {
  using contact::Hertz;
  const model::Chain chain{
      .mass = {1, 1, 1},
      .law = {Hertz{1}, Hertz{1}},
      .gap = {0, 0},
      .velocity = {1, 0, 0},
  };
  const auto impact = impact::simulate(chain);
  const double momentum = impact.velocity[0] + impact.velocity[1] + impact.velocity[2];
  std::printf("%s, momentum %.17g\n", hybrid::name(impact.ending), momentum);
  bool right = check(impact.ending == hybrid::Ending::separated, "the ending") &&
               check(std::abs(momentum - 1) < 1e-9, "momentum") &&
               check(std::string(version) == FOUND_VERSION, "the version");

  const auto scene = scene::parse(text, "three.toml");
  const auto again = scene::simulate(scene);
  right = check(std::get<impact::ChainImpact>(again).velocity == impact.velocity, "the scene") && right;
  right = check(report::json_text(again, scene).find("\"final\"") != std::string::npos, "JSON") && right;
  right = check(report::table_text(again, scene).find("Balls") != std::string::npos, "the table") && right;
  right = check(report::events_text(again).starts_with("time [s]"), "the events") && right;
  return right ? 0 : 1;
}
