#pragma once
// A comment is no #include "mariotte/scene/scene.hpp".
#include <Eigen/Core>
