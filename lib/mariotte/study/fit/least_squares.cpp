#include "mariotte/study/fit/least_squares.hpp"

#include <Eigen/Core>
#include <unsupported/Eigen/NonLinearOptimization>

#include "mariotte/core/error.hpp"

namespace mariotte::study {
namespace {

using Eigen::LevenbergMarquardtSpace::Status;

constexpr double turn_back =
    1e100;  // a residual that no search takes for progress, and whose square is finite
constexpr Index most_evaluations = 400;

/// What Eigen calls a functor; 0 tells it that all went well, a negative number to give up.
struct Functor {
  const LeastSquares& problem;

  Index values() const { return problem.count; }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& r) const {
    try {
      problem.residuals({x.data(), static_cast<std::size_t>(x.size())},
                        {r.data(), static_cast<std::size_t>(r.size())});
      if (r.allFinite()) return 0;
    } catch (const Error&) {
      // As if it were not finite.
    }
    r.setConstant(turn_back);
    return 0;
  }
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& slopes) const {
    problem.slopes({x.data(), static_cast<std::size_t>(x.size())},
                   {slopes.data(), static_cast<std::size_t>(slopes.size())});
    return slopes.allFinite() ? 0 : -1;
  }
};

bool is_converged(Status status) {
  switch (status) {
    case Status::RelativeReductionTooSmall:
    case Status::RelativeErrorTooSmall:
    case Status::RelativeErrorAndReductionTooSmall:
    case Status::CosinusTooSmall:
    case Status::FtolTooSmall:  // these are at the limit of what a double can tell
    case Status::XtolTooSmall:
    case Status::GtolTooSmall:
      return true;
    default:
      return false;
  }
}

std::string reason(Status status, Index evaluations) {
  if (status == Status::UserAsked) return "the search came to a place where slopes are not finite";
  return "the search did not converge within " + std::to_string(evaluations) + " evaluations";
}

}  // namespace

Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance) {
  std::vector<double> residuals(static_cast<std::size_t>(problem.count));
  problem.residuals(start, residuals);  // throws what the search would hide
  Functor functor{problem};
  Eigen::LevenbergMarquardt<Functor> search(functor);
  search.parameters.factor = 1;
  search.parameters.ftol = search.parameters.xtol = tolerance;
  search.parameters.maxfev = most_evaluations;
  Eigen::VectorXd x = Eigen::Map<Eigen::VectorXd>(start.data(), std::ssize(start));
  const auto status = search.minimize(x);
  Minimum found{.x = {x.begin(), x.end()}, .converged = is_converged(status), .message = {}};
  if (!found.converged) found.message = reason(status, search.nfev);
  return found;
}

}  // namespace mariotte::study
