// Sum that does not lose small addends: absolute time is the sum of many short phases.
#pragma once
#include <cmath>

namespace mariotte {

/// Running sum with Neumaier's compensation; its error does not grow with the number of addends.
class CompensatedSum {
 public:
  CompensatedSum& operator+=(double addend) {
    const double sum = sum_ + addend;
    rest_ += std::abs(sum_) >= std::abs(addend) ? (sum_ - sum) + addend : (addend - sum) + sum_;
    sum_ = sum;
    return *this;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0;
  double rest_ = 0;
};

}  // namespace mariotte
