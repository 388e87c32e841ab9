#include "mariotte/impact/laws/ceanga_hurmuzlu_law.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {
namespace {

using Numbers = std::vector<double>;

void validate(const Configuration& c, const CorrelationLaw& law) {
  validate(c, law.restitution);
  validate_direction(c, law.direction);
}

/// Energy that can be given back, between two values of s at which gaps turn: it changes by
/// h (slope + h curvature/2).
struct Piece {
  double slope = 0, curvature = 0;

  double change(double h) const { return h * (slope + 0.5 * h * curvature); }
  /// The first h > 0 at which `energy` ≥ 0 is used up; ∞ if it never is.
  double used_up(double energy) const {
    if (curvature == 0) return slope < 0 ? -energy / slope : infinity;
    const double discriminant = slope * slope - 2 * energy * curvature;
    if (discriminant < 0 || (curvature > 0 && slope >= 0)) return infinity;
    const double root = std::sqrt(discriminant);
    if (root == 0 && slope == 0) return 0;
    // Of the two forms of the root, the one without a difference of near numbers.
    return slope > 0 ? -(slope + root) / curvature : 2 * energy / (root - slope);
  }
};

/// The impact along one direction.
class DirectedImpact {
 public:
  DirectedImpact(const Configuration& c, const CorrelationLaw& law)
      : restitution_(law.restitution),
        direction_(impact::direction(law.direction)),
        rates_(gap_rates(c, c.velocity)),
        slopes_(gap_rates(c, velocity_change(c, direction_))) {
    for (std::size_t j = 0; j < rates_.size(); ++j)
      if (const double s = -rates_[j] / slopes_[j]; s > 0 && std::isfinite(s)) turns_.push_back(s);
    std::sort(turns_.begin(), turns_.end());
    turns_.push_back(infinity);
  }

  const Numbers& direction() const { return direction_; }
  bool approaches() const {
    double work = 0;
    for (std::size_t j = 0; j < rates_.size(); ++j) work -= direction_[j] * rates_[j];
    return work > 0;
  }
  /// s at the end.
  double size() const {
    double start = 0, energy = 0;
    for (const double turn : turns_) {
      const auto piece = piece_between(start, turn);
      if (const double h = piece.used_up(energy); std::isfinite(h) && h <= turn - start) return start + h;
      energy += piece.change(turn - start);
      start = turn;
    }
    return start;
  }

 private:
  Piece piece_between(double start, double turn) const {
    const double middle = std::isinf(turn) ? 2 * start + 1 : 0.5 * (start + turn);
    Piece piece;
    for (std::size_t j = 0; j < rates_.size(); ++j) {
      const bool closes = direction_[j] * (rates_[j] + middle * slopes_[j]) < 0;
      const double share = closes ? restitution_[j] * restitution_[j] : 1;
      piece.slope -= share * direction_[j] * (rates_[j] + start * slopes_[j]);
      piece.curvature -= share * direction_[j] * slopes_[j];
    }
    return piece;
  }

  const Numbers& restitution_;
  Numbers direction_, rates_, slopes_;
  Numbers turns_;  ///< where a gap rate is zero, in order; then ∞
};

}  // namespace

LawOutcome ceanga_hurmuzlu(const Configuration& c, const CorrelationLaw& law) {
  validate(c, law);
  const DirectedImpact course(c, law);
  auto p = course.direction();
  const double size = course.approaches() ? course.size() : 0;
  for (double& impulse : p) impulse *= size;
  auto outcome = outcome_of(c, std::move(p));
  if (!course.approaches()) outcome.status = LawStatus::no_impact;
  return outcome;
}

}  // namespace mariotte::impact
