#include <CLI/CLI.hpp>

#include <Eigen/Dense>

#include "mariotte/report/table.hpp"
#include "options.hpp"
