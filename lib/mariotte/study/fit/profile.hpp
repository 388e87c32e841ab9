// How far a value may lie from the best one: as far as the least sum of squares over all other values is no
// larger than a confidence allows. Unlike standard errors that is right, too, where residuals are no linear
// function of the value, and it tells values that may be zero.
#pragma once
#include <vector>

#include "mariotte/study/fit/fit_problem.hpp"

namespace mariotte::study {

/// About a minimum of a fit.
class Profile {
 public:
  /// `squares` is the least sum; it may grow to `most`. `problem` must outlive this.
  Profile(const FitProblem& problem, std::vector<double> minimum, double squares, double most);

  /// x_j of the end on the side of `step`, which is a first guess of how far away it lies; infinite if no
  /// factor up to a thousand comes to it, counted upwards from the start of the search if that is larger.
  double end(std::size_t j, double step) const;

  /// Another place to look for the least sum from: the minimum, but for x_j.
  void look_from(std::size_t j, double place) {
    starts_.push_back(starts_.front());
    starts_.back()[j] = place;
  }

 private:
  double least(std::size_t j, double place) const;
  double least_from(std::vector<double> x, std::size_t j) const;

  const FitProblem& problem_;
  double squares_, most_;
  std::vector<std::vector<double>> starts_;  ///< the minimum first
};

}  // namespace mariotte::study
