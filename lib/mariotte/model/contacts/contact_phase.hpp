// A phase of a model made of contacts: what those who watch steps can ask of it, whatever the model.
#pragma once
#include <algorithm>

#include "mariotte/contact/contact_set.hpp"
#include "mariotte/contact/force.hpp"
#include "mariotte/flow/problem.hpp"

namespace mariotte::model {

/// Everything dimensionless; velocities and contacts count from 0.
class ContactPhase : public flow::Problem {
 public:
  virtual const contact::ContactSet& mode() const = 0;
  virtual Index velocities() const = 0;
  virtual Index contacts() const = 0;
  virtual double velocity(ConstState x, Index i) const = 0;
  virtual double gap(ConstState x, Index j) const = 0;
  /// δ̇ where the contact is indented. Linear in x.
  virtual double approach(ConstState x, Index j) const = 0;
  /// Force of contact j and its slopes; zero unless it carries force.
  virtual contact::Force force(ConstState x, Index j) const = 0;
  /// Indented by δ, at the rate δ̇.
  virtual contact::Force force(double indentation, double rate, Index j) const = 0;
  /// Where its gap stands in the state.
  virtual Index gap_place(Index j) const = 0;
  virtual bool is_damped(Index j) const = 0;
  /// True if the force of contact j can pull; that of any other is cut off at 0.
  virtual bool pulls(Index j) const = 0;
  /// The force that contact j is said to have.
  double felt_force(ConstState x, Index j) const {
    const double f = force(x, j).value;
    return pulls(j) ? f : std::max(0.0, f);
  }
};

}  // namespace mariotte::model
