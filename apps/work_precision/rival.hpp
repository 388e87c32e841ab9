// Rivals: solvers that are templates over the field they integrate.
//
// A field is made from a case and a setting and has
//   State, size                        its state, an array of so many numbers
//   overtime                           how far a rival that knows no ending integrates, in ends of the impact
//   start(case, x), finish(x, answer)  what goes in, what comes out
//   magnitudes()                       sizes of the components
//   operator()(x, dx)                  the right-hand side
#pragma once
#include <memory>

#include "measuring/rivals.hpp"
#include "method.hpp"

namespace mariotte::work_precision {

/// What a rival is asked for.
struct Setting {
  double value;          ///< tolerance, or steps per unit of time
  double smoothing = 0;  ///< slip, over the incident speed, within which friction turns about; 0: sgn
};

/// `Rival` is made from the setting and has solve(case, answer).
template <class Rival>
Solve solve_by(const Setting& setting, std::size_t velocities) {
  auto solver = std::make_shared<Rival>(setting);
  auto answer = std::make_shared<Answer>();
  answer->velocity.resize(velocities);
  return [solver, answer](const Case& one) -> const Answer& {
    answer->rhs = answer->steps = answer->events = 0;
    solver->solve(one, *answer);
    return *answer;
  };
}

}  // namespace mariotte::work_precision
