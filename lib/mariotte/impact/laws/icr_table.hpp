// Impulse directions and energy ratios computed off-line, and the multiple-impact law with what lies between.
#pragma once
#include <string>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"

namespace mariotte::impact {

/// A parameter of the table and the values it takes, in rising order.
struct TableAxis {
  enum class Spacing {
    linear,  ///< interpolated in the value
    log,     ///< interpolated in its logarithm; values > 0
    exact    ///< not interpolated: only these values are known
  };
  std::string name;
  Spacing spacing = Spacing::linear;
  std::vector<double>
      values;  ///< interpolated axes have one value, or at least three to know their curvature
};

/// What one simulated impact gives.
struct TablePoint {
  double energy_ratio = 1;    ///< relative to the mass centre
  std::vector<double> share;  ///< p_j/Σ p, ≥ 0: an impulse direction; empty if there was no impact
};

/// A grid of simulated impacts, the last axis fastest. Tables whose points have different numbers of contacts
/// have exact axes only.
struct IcrTable {
  std::string about;    ///< what was simulated, one line
  double accuracy = 0;  ///< of the simulations
  std::vector<TableAxis> axis;
  std::vector<TablePoint> point;
};

/// A point outside the table, or between points of which some have no impact.
struct OutsideTable : InvalidParameter {
  using InvalidParameter::InvalidParameter;
};

/// Law parameters at a point, with a bound on the error of each. Along one axis linear interpolation errs by
/// at most h² |D| min(t, 1−t), for a step h, a place t within it and the second difference D of a smooth
/// function or of one with a kink; the largest D at the corners of the cell is taken, and twice the sum over
/// the axes, since kinks (a contact that just closes again) run across the axes. A bound as far as the table
/// resolves its function, not a proof.
struct TableAnswer {
  LawParameters parameters;
  std::vector<double> share_error;
  double energy_error = 0;
};

/// Throws InvalidParameter unless axes and points fit together.
void validate(const IcrTable& table);

/// The parameters at one value per axis. Throws OutsideTable.
TableAnswer look_up(const IcrTable& table, const std::vector<double>& at);

/// The law with parameters from a table.
struct BoundedOutcome {
  LawOutcome outcome;
  double velocity_error =
      0;  ///< the most by which any velocity moves when the parameters move by their errors
};
/// Apply the law. Throws InvalidParameter.
BoundedOutcome multiple_impact(const Configuration& configuration, const TableAnswer& answer);

/// The table as text: two comment lines, a header "name:spacing,…,e,share_1,…", one line per point.
std::string write(const IcrTable& table);

/// Throws InvalidParameter that names the line if the text is no table.
IcrTable parse_icr_table(const std::string& text);

}  // namespace mariotte::impact
