#include "mariotte/flow/taylor.hpp"

  #  include <cvode/cvode.h>
#include <klu.h>
#include <Eigen/Dense>
