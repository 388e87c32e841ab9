#include "mariotte/study/fit/fit_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fit/least_squares.hpp"

namespace mariotte::study {
namespace {

using Values = std::vector<double>;

const double farthest = std::log(1000.0);
constexpr double first = 1;       // x of the value that a search starts from
constexpr double bent = 0.2;      // standard error / value from which residuals bend
constexpr double precise = 1e-4;  // relative to the distance of an end, or to its value if that is less
constexpr double roughly = 1e-4;  // tolerance of searches that only compare with a bound

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

/// About a minimum of a fit.
class Profile {
 public:
  /// The least sum of squares may grow to `most`. `problem` must outlive this.
  Profile(const FitProblem& problem, Values minimum, double most)
      : problem_(problem), most_(most), starts_{std::move(minimum)} {}

  /// x_j of the end on the side of `step`, which is a first guess of how far away it lies; infinite if no
  /// factor up to a thousand comes to it, counted upwards from the start of the search if that is larger.
  double end(std::size_t j, double step) const {
    const double from = starts_.front()[j];
    const double limit = farthest + (step > 0 ? std::max(0.0, first - from) : 0);
    auto last = starts_.front();
    const auto ends = [&](double distance) { return is_beyond(j, from + distance, last); };
    double inside = 0, outside = step;
    while (!ends(outside)) {
      if (std::abs(outside) >= limit) return std::copysign(infinity, step);
      inside = outside;
      outside = std::copysign(std::min(2 * std::abs(outside), limit), step);
    }
    while (std::abs(outside - inside) > precise * std::min(1.0, std::abs(outside))) {
      const double middle = 0.5 * (inside + outside);
      (ends(middle) ? outside : inside) = middle;
    }
    return from + outside;
  }

  /// Another place to look for the least sum from: the minimum, but for x_j.
  void look_from(std::size_t j, double place) {
    starts_.push_back(starts_.front());
    starts_.back()[j] = place;
  }

 private:
  /// From the last place that was inside, too: most often it is there at once.
  bool is_beyond(std::size_t j, double place, Values& last) const {
    auto starts = starts_;
    starts.insert(starts.begin(), last);
    for (auto& x : starts) {
      x[j] = place;
      if (!comes_inside(x, j)) continue;
      last = x;
      return false;
    }
    return true;
  }

  /// Moves all but x_j until the sum is small enough. False, too, where something cannot be simulated.
  bool comes_inside(Values& x, std::size_t j) const try {
    if (problem_.sum_of_squares(x) <= most_) return true;
    if (x.size() == 1) return false;
    const auto found = minimise(of_others(problem_, j, x[j]), without(x, j), roughly);
    x = with(found.x, j, x[j]);
    return problem_.sum_of_squares(x) <= most_;
  } catch (const Error&) {
    return false;
  }

  const FitProblem& problem_;
  double most_;
  std::vector<Values> starts_;  ///< the minimum first
};

/// Of what has vanished; it opens a way for the others.
void bound_vanished(const Found& found, Profile& profile, std::vector<Interval>& all) {
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (found.relative_error[j] < infinity) continue;
    all[j] = {-infinity, profile.end(j, first + 1 - found.minimum.x[j])};
    if (all[j].upper < infinity) profile.look_from(j, all[j].upper);
  }
}

/// An end of x_j, or the last place on the way to it that the scene allows.
double possible_end(const FitProblem& problem, Values x, std::size_t j, double end) {
  double inside = x[j];
  const auto is_possible = [&](double place) {
    x[j] = place;
    return problem.is_possible(x);
  };
  if (std::isinf(end) || is_possible(end)) return end;
  constexpr double exact = 1e-9;
  double outside = end;
  while (std::abs(outside - inside) > exact) {
    const double middle = 0.5 * (inside + outside);
    (is_possible(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

std::vector<Interval> intervals(const FitProblem& problem, const Found& found, double reach) {
  const auto& x = found.minimum.x;
  const double scatter = reach * reach / static_cast<double>(found.degrees_of_freedom);
  Profile profile(problem, x, found.squares * (1 + scatter));
  std::vector<Interval> all(x.size());
  bound_vanished(found, profile, all);
  const bool all_held = found.held.size() == x.size();
  for (const auto j : found.held) {
    const double error = found.relative_error[j], step = reach * error, guess = std::min(step, 1.0);
    const bool is_straight = found.squares == 0 || (error < bent && all_held);
    all[j] = is_straight ? Interval{x[j] - step, x[j] + step}
                         : Interval{profile.end(j, -guess), profile.end(j, guess)};
  }
  for (std::size_t j = 0; j < all.size(); ++j)
    all[j] = {possible_end(problem, x, j, all[j].lower), possible_end(problem, x, j, all[j].upper)};
  return all;
}

}  // namespace mariotte::study
