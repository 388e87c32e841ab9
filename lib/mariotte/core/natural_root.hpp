// Roots that give lengths of contacts, of which neighbours mostly have the same.
#pragma once
#include "mariotte/core/scale.hpp"

namespace mariotte {

/// natural_root, which knows its last answer.
class NaturalRoot {
 public:
  double operator()(double q, double exponent) {
    if (q != q_ || exponent != exponent_) root_ = natural_root(q, exponent);
    q_ = q;
    exponent_ = exponent;
    return root_;
  }

 private:
  double q_ = 0, exponent_ = 0, root_ = 0;
};

}  // namespace mariotte
