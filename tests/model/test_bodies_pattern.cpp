// The Jacobian of bodies: what its pattern leaves out is zero to the last bit, the rest slopes of rates.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mariotte/model/bodies/bodies_pattern.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"
#include "support/random_balls.hpp"

using namespace mariotte;
using namespace mariotte::model;
using test::in;

namespace {

constexpr TangentialLaw frictions[] = {TangentialLaw::none, TangentialLaw::rigid, TangentialLaw::spring,
                                       TangentialLaw::mindlin};

/// Two heaps of three balls on a plane; the balls of a heap touch each other.
Bodies heaps(int dimension, TangentialLaw friction) {
  Bodies bodies{.dimension = dimension};
  bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {0.1, 0.05, 0}}};
  const double r = test::radius;
  const auto add = [&](Feature a, Index b) {
    bodies.contact.push_back({.a = a,
                              .b = {b, 0},
                              .law = contact::Viscoelastic{1e7, 1e3, 1.5},
                              .tangential = {friction, 0.3, 1e6}});
  };
  for (const Index heap : {0, 1}) {
    const double x = 8 * r * static_cast<double>(heap);
    for (const Vector3& at : {Vector3{x, r, 0}, {x + 2 * r, r, 0}, {x + r, r * (1 + std::sqrt(3)), 0}})
      bodies.body.push_back(test::ball(at));
    const Index first = 3 * heap;
    add({0, -1}, first), add({0, -1}, first + 1);
    add({first, 0}, first + 1), add({first, 0}, first + 2), add({first + 1, 0}, first + 2);
  }
  bodies.gravity = {0, -9.81, 0};
  bodies.named = std::ssize(bodies.contact);
  return bodies;
}

/// A ball between four others, which do not touch each other.
Bodies cross(int dimension, TangentialLaw friction) {
  Bodies bodies{.dimension = dimension};
  const double d = 2 * test::radius;
  for (const Vector3& at : {Vector3{}, {d, 0, 0}, {-d, 0, 0}, {0, d, 0}, {0, -d, 0}})
    bodies.body.push_back(test::ball(at));
  for (const Index other : {1, 2, 3, 4})
    bodies.contact.push_back({.a = {0, 0},
                              .b = {other, 0},
                              .law = contact::Viscoelastic{1e7, 1e3, 1.5},
                              .tangential = {friction, 0.3, 1e6}});
  bodies.named = std::ssize(bodies.contact);
  return bodies;
}

/// Some balls have equal moments, some their mass centre beside the middle.
Bodies varied(Bodies bodies) {
  for (auto& body : bodies.body) {
    if (in(0, 1) < 0.5) body.inertia = {test::moment, test::moment, test::moment};
    if (in(0, 1) < 0.3) body.spheres[0].centre = {0.1 * test::radius, 0, 0};
  }
  return bodies;
}

/// All contacts closed, in modes drawn at random.
BodiesMode drawn_mode(const Bodies& bodies) {
  BodiesMode mode;
  const bool has_friction = bodies.contact[0].tangential.law != TangentialLaw::none;
  for (Index c = 0; c < std::ssize(bodies.contact); ++c) {
    ClosedContact one;
    one.contact = one.slot = c;
    if (has_friction) one.friction = in(0, 1) < 0.5 ? Friction::stick : Friction::slip;
    one.unloading = in(0, 1) < 0.3;
    one.slack = in(0, 1) < 0.1;
    one.from_rest = one.friction == Friction::slip && !one.slack && in(0, 1) < 0.3;
    one.sign = in(0, 1) < 0.5 ? -1 : 1;
    mode.closed.push_back(one);
  }
  return mode;
}

std::vector<double> rates(const flow::Problem& problem, std::vector<double> x, Index column, double change) {
  x[column] += change;
  std::vector<double> dx(x.size());
  problem.derivative(x, dx);
  return dx;
}

template <int D>
void check(const Bodies& bodies) {
  constexpr double little = 1e-6;
  BodiesSystem<D> system(bodies, setting_of<D>(bodies, 1e-9), Over::separated);
  const auto mode = drawn_mode(bodies);
  const auto& phase = system.problem(mode);
  const auto pattern = phase.pattern();
  std::vector<double> x(phase.size()), values(pattern.size());
  for (double& value : x) value = in(-0.1, 0.1);
  phase.jacobian(x, values);
  std::map<std::pair<Index, Index>, double> slope;
  std::vector<double> steepest(x.size(), 1);  // of each rate
  for (std::size_t e = 0; e < pattern.size(); ++e) {
    slope[{pattern[e].row, pattern[e].column}] = values[e];
    steepest[pattern[e].row] = std::max(steepest[pattern[e].row], std::abs(values[e]));
  }

  const auto colours = colours_of(pattern, phase.size());
  std::set<std::pair<Index, Index>> carried;  // colours and rows
  for (const auto& [row, column] : pattern) BOOST_TEST(carried.emplace(colours[column], row).second);

  const auto here = rates(phase, x, 0, 0);
  for (Index column = 0; column < phase.size(); ++column) {
    const auto far = rates(phase, x, column, 0.01), above = rates(phase, x, column, little),
               below = rates(phase, x, column, -little);
    for (Index row = 0; row < phase.size(); ++row) {
      const auto known = slope.find({row, column});
      if (known == slope.end())
        BOOST_TEST(far[row] == here[row], "rate " << row << " changes with " << column);
      else
        BOOST_TEST(std::abs(known->second - (above[row] - below[row]) / (2 * little)) < 0.01 * steepest[row]);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_jacobian_of_bodies_has_all_slopes) {
  for (const auto friction : frictions)
    for (int draw = 0; draw < 10; ++draw) {
      check<2>(varied(heaps(2, friction)));
      check<3>(varied(heaps(3, friction)));
      check<2>(varied(cross(2, friction)));
      check<3>(varied(cross(3, friction)));
    }
}
