// The force; and its [slopes] by rate.
#include <variant>
#include "mariotte/core/types.hpp"
#include "mariotte/flow/flow.hpp"
#include "force.hpp"
