// What is compared: anything that turns a case into final velocities.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "problem.hpp"

namespace mariotte::work_precision {

/// What one solve left behind.
struct Answer {
  std::vector<double> velocity;  ///< final velocities, as in the case
  Index rhs = 0;                 ///< evaluations of the right-hand side
  Index steps = 0;
  Index events = 0;            ///< instants located, at which a contact opens or closes
  std::vector<Index> periods;  ///< how often each contact closes; empty if the method does not tell
};

/// Solves one case. The answer lasts until the next call; throws Error if there is none.
using Solve = std::function<const Answer&(const Case&)>;

/// Whose time a method's is counted as in the table of ratios.
enum class Family { own, sundials, odeint, fixed_step };

struct Method {
  std::string name;
  Family family;
  /// A solver at a tolerance or, of a fixed-step method, with so many steps per unit of time. All memory is
  /// taken here and not while solving. Empty if the method does not admit the problem.
  std::function<Solve(const Problem&, double setting)> prepare;
};

/// Ours first, then the rivals.
std::vector<Method> methods();

void append(std::vector<Method>& list, std::vector<Method> more);

std::vector<Method> own_methods();
std::vector<Method> cvode_rivals();
std::vector<Method> odeint_rivals();
std::vector<Method> fixed_step_rivals();

}  // namespace mariotte::work_precision
