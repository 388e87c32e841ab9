#include "mariotte/scene/scene.hpp"
