// A fit as a problem of least squares in x = 1 + ln(value / start), one component per free key: of order one,
// and whatever x is, the value is positive.
#pragma once
#include <span>
#include <vector>

#include "mariotte/study/fit/fit_model.hpp"

namespace mariotte::study {

class FitProblem {
 public:
  /// `model` must outlive this.
  explicit FitProblem(FitModel& model);

  std::size_t count() const { return model_.measurements().rows.size(); }

  /// Of the free keys [SI].
  std::vector<double> values(std::span<const double> x) const;

  /// One per measurement. Throws Error if one cannot be simulated.
  std::vector<Prediction> predicted(std::span<const double> x) const;

  /// (measured − predicted) / deviation. Throws Error also where a value is a million times off the start.
  void residuals(std::span<const double> x, std::span<double> r) const;

  /// The scene allows these values.
  bool is_possible(std::span<const double> x) const;

  /// ∂r/∂x, a column per free key: exact slopes, and central differences where there are none. Where one side
  /// of these is captured restitution falls to 0 like a root, and the other side alone is asked, as where one
  /// side is none that the scene allows; what is captured itself has no slope.
  void slopes(std::span<const double> x, std::span<double> columns) const;

  /// The same on the way to the minimum, where six digits are enough: by what costs less.
  void search_slopes(std::span<const double> x, std::span<double> columns) const;

  /// Σ residual², and the rows by which residuals scatter: of what is captured both as measured and as
  /// predicted nothing does. Throws Error if a measurement cannot be simulated.
  struct Scatter {
    double squares = 0;
    Index rows = 0;
  };
  Scatter scatter(std::span<const double> x) const;
  double sum_of_squares(std::span<const double> x) const { return scatter(x).squares; }
  /// √Σ (measured / deviation)²
  double measured_size() const;

  /// The start and its neighbours, each value times 1/4, 1 or 4, the best first; with more than five keys the
  /// start alone. Throws Error if it cannot be simulated.
  std::vector<std::vector<double>> starts() const;

 private:
  void fill(std::span<const double> x, std::span<double> columns, bool exact) const;
  double difference(std::size_t row, std::span<const double> x, std::size_t j) const;
  FitModel& model_;
  double step_;  ///< balances the error of the differences against that of the simulations
};

}  // namespace mariotte::study
