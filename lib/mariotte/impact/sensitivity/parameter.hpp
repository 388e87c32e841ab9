// What an outcome is differentiated by.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/dimension.hpp"

namespace mariotte::impact {

/// A number that a model is made from. The model is an analytic function of it near its value.
template <class Model>
struct Parameter {
  std::string name;                         ///< as "mass[0]" or "contact[1].stiffness"
  double value;                             ///< in the units of the model
  double step;                              ///< distance within which the model exists at least four times
  std::function<void(double, Model&)> set;  ///< the model of any value so near, in the memory of another
  std::optional<Dimension> dimension = {};  ///< empty where it is not known, as of degrees of freedom
  bool is_linear = false;  ///< start, forces and accelerations are linear in it: two models tell its slopes
  double limit = 0;        ///< by how much the time limit of the run moves with it

  Model model(double at) const {
    Model made;
    set(at, made);
    return made;
  }
};

}  // namespace mariotte::impact
