// Two billiard balls or more, in the text of a scene.
#pragma once
#include <string>

namespace mariotte::test {

/// Without the bodies, which follow as [[bodies.body]].
inline const std::string billiard_balls = R"([bodies]
dimension = 2
law = "hertz"
tangential = "mindlin"
friction = 0.06
material = { young = "5.8 GPa", poisson = 0.34 }
radius = "28.6 mm"
mass = "170 g"
)";

}  // namespace mariotte::test
