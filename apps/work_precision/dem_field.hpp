// Balls with Mindlin's friction as users of odeint and of codes for grains write them: positions, velocities,
// spins and a tangential force per pair, no events.
#pragma once
#include <vector>

#include "mariotte/model/bodies/bodies.hpp"

namespace mariotte::work_precision {

/// In the plane, in units of the first ball's radius, of 1 m/s and of its mass. Per ball x, y, two velocities
/// and the spin; then T of each pair.
class DemField {
 public:
  using State = std::vector<double>;

  explicit DemField(const model::Bodies& bodies);
  /// Whether all contacts are Hertz's with Mindlin's friction.
  static bool admits(const model::Bodies& bodies);

  const State& start() const { return start_; }
  double time() const { return length_; }  ///< unit [s]
  /// Natural time of a contact.
  double contact_time() const { return contact_time_; }
  /// The right-hand side: T grows with the slip and shrinks with its stiffness, and acts up to its cap.
  void operator()(const State& x, State& dx) const;
  /// What is done between steps: T of open pairs is forgotten, others are cut at their caps.
  void settle(State& x) const;
  /// A step of velocity Verlet, in which T is a sum; `dx` holds the accelerations before and after.
  void verlet(double h, State& x, State& dx) const;
  std::vector<double> velocities(const State& x) const;

 private:
  struct Pair {
    int a, b;  ///< a = −1: the plane
    double stiffness, grip, friction;
  };
  struct Touch {
    double depth, rate, slip, normal_x, normal_y;
  };
  struct Ball {
    double mass, moment, radius;
  };

  void add(const model::Body& body);
  void add(const model::BodyContact& contact);
  void kick(double h, State& x, const State& dx) const;
  Touch touch(const Pair& pair, const State& x) const;
  void push(const Pair& pair, const Touch& now, double tangential, State& dx) const;
  double cap_of(const Pair& pair, const Touch& now) const;
  std::size_t spring(std::size_t pair) const { return 5 * ball_.size() + pair; }

  std::vector<Ball> ball_;
  std::vector<Pair> pair_;
  State start_;
  double length_ = 1, mass_ = 1, normal_x_ = 0, normal_y_ = 1, height_ = 0, contact_time_ = 1;
};

}  // namespace mariotte::work_precision
