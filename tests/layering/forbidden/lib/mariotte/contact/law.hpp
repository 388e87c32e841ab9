// The force; and its [slopes] by rate.
#include <variant>

#include "force.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/flow/flow.hpp"
