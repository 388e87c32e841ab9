// Scenes to vary.
#pragma once
#include <string>

namespace mariotte::test {

inline const std::string three_balls = R"([chain]
mass = [1, 1, 1]
velocity = [1, 0, 0]
[[chain.contact]]
law = "hertz"
stiffness = 1
[[chain.contact]]
law = "hertz"
stiffness = 1
)";

inline const std::string steel_balls = R"([chain]
radius = "10 mm"
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law = "hertz"
balls = 3
velocity = ["1 m/s", 0, 0]
)";

}  // namespace mariotte::test
