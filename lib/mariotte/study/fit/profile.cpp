#include "mariotte/study/fit/profile.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fit/least_squares.hpp"

namespace mariotte::study {
namespace {

using Values = std::vector<double>;

const double farthest = std::log(1000.0);
constexpr double start = 1;       // x of the value that a search starts from
constexpr double precise = 0.01;  // relative to the distance of an end

Values without(std::span<const double> x, std::size_t j) {
  Values others(x.begin(), x.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(j));
  return others;
}

Values with(std::span<const double> others, std::size_t j, double place) {
  Values x(others.begin(), others.end());
  x.insert(x.begin() + static_cast<std::ptrdiff_t>(j), place);
  return x;
}

/// Of all values but x_j, which stays.
LeastSquares of_others(const FitProblem& problem, std::size_t j, double place) {
  return {.count = static_cast<Index>(problem.count()),
          .residuals = [&problem, j, place](auto x, auto r) { problem.residuals(with(x, j, place), r); },
          .slopes =
              [&problem, j, place](auto x, auto columns) {
                const auto whole = with(x, j, place);
                Values all(problem.count() * whole.size());
                problem.search_slopes(whole, all);
                const auto column = all.begin() + static_cast<std::ptrdiff_t>(j * problem.count());
                all.erase(column, column + static_cast<std::ptrdiff_t>(problem.count()));
                std::copy(all.begin(), all.end(), columns.begin());
              }};
}

}  // namespace

Profile::Profile(const FitProblem& problem, Values minimum, double squares, double most)
    : problem_(problem), squares_(squares), most_(most), starts_{std::move(minimum)} {}

double Profile::end(std::size_t j, double step) const {
  const double from = starts_.front()[j];
  const double limit = farthest + (step > 0 ? std::max(0.0, start - from) : 0);
  const auto is_beyond = [&](double distance) { return least(j, from + distance) > most_; };
  double inside = 0, outside = step;
  while (!is_beyond(outside)) {
    if (std::abs(outside) >= limit) return std::copysign(infinity, step);
    inside = outside;
    outside = std::copysign(std::min(2 * std::abs(outside), limit), step);
  }
  while (std::abs(outside - inside) > precise * std::abs(outside)) {
    const double middle = 0.5 * (inside + outside);
    (is_beyond(middle) ? outside : inside) = middle;
  }
  return from + outside;
}

double Profile::least(std::size_t j, double place) const {
  double least = infinity;
  for (auto x : starts_) {
    x[j] = place;
    least = std::min(least, least_from(std::move(x), j));
    if (least <= most_) break;
  }
  return least;
}

/// Infinite where something cannot be simulated.
double Profile::least_from(Values x, std::size_t j) const try {
  if (x.size() == 1) return problem_.sum_of_squares(x);
  const double place = x[j];
  const auto found = minimise(of_others(problem_, j, place), without(x, j));
  return problem_.sum_of_squares(with(found.x, j, place));
} catch (const Error&) {
  return infinity;
}

}  // namespace mariotte::study
