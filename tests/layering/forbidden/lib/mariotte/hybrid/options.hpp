#pragma once
#include "mariotte/core/types.hpp"
#include "mariotte/hybrid/system.hpp"
#include <vector>
