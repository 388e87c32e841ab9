// What the rows of a study say, with the measured spread.
#pragma once
#include <string>
#include <vector>

#include "sweep.hpp"

namespace mariotte::stiffness_study {

/// A sentence at the end.
struct Statement {
  enum class Kind {
    theorem,     ///< follows from the equations: if it fails, the solver is wrong
    observation  ///< depends on the machine and on the flow
  };
  Kind kind;
  std::string text;
  bool holds = true;  ///< asked of theorems
};

/// How far runs that should be one and the same lie apart.
struct Spread {
  Index runs = 0;        ///< that were compared
  Index unfinished = 0;  ///< that were tried and did not separate
  double velocity = 0;   ///< largest difference / incident speed
  double icr = 0;        ///< largest difference of any α
  double instants = 0;  ///< largest difference of an instant / time of the last one; ∞ if their counts differ
  double slowest = 1;  ///< least relative speed of neighbours at the end / incident speed
  Index least_steps = 0, most_steps = 0;
};

/// Largest spread within the rows of any one flow; rows that were not tried are left out.
Spread spread(const Rows& rows);

/// How much runs that should be the same may differ in velocities and ICRs: each is allowed the accuracy, and
/// a ratio of impulses amplifies what is wrong with them.
double allowed(double accuracy);

/// The theorem that runs agree in velocities, ICRs and instants. Over stiffness alone the dimensionless
/// equations are the same to the last digits, and instants must agree as well as velocities do. Over
/// everything, those of each flow differ in rounding, and the slower a contact lets go, the less is known
/// about when.
Statement invariance(const std::string& claim, const Rows& over_stiffness, const Rows& over_everything);

/// Rows of one series and family that a flow and a test select.
template <class Test>
Rows select(const Rows& rows, const Test& test) {
  Rows chosen;
  for (const auto& row : rows)
    if (test(row)) chosen.push_back(row);
  return chosen;
}

/// Names of flows or series in the order in which they occur.
std::vector<std::string> names(const Rows& rows, std::string Row::*name);

/// "1 … 1e30".
std::string range(const Rows& rows);

/// "steps over k = 1 … 1e30: auto 43, cvode-adams 210 … 214".
Statement steps_statement(const Rows& rows, const std::string& quantity);

/// How far the times of a flow over the rows lie apart, "auto within 1.3 (2.1 … 2.7 µs)".
Statement times_statement(const Rows& rows, const std::string& quantity);

/// "taylor / cvode-adams: 0.11 at 0.1, 0.3 at 1 …": where two flows cost the same, and ratios of their times.
Statement comparison(const Rows& rows, const std::string& a, const std::string& b);

/// Largest error of each flow against its references.
std::vector<Statement> error_statements(const Rows& rows);

}  // namespace mariotte::stiffness_study
