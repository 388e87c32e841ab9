// A scene as something to differentiate: its numbers, its slopes, and its outcomes where one of them has
// moved.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "dice.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "scene.hpp"

namespace mariotte::stress_study {

/// A number of a scene.
struct Probe {
  std::string name;
  double value;
  double unit;  ///< by how much it moves results by their own size, about
  double step;  ///< longest distance of the points of a stencil
  std::function<impact::Sensitivity(double value)> outcomes = {};  ///< without slopes, as exact as can be
  std::function<impact::Sensitivity(double value)> slopes = {};    ///< by all probes, likewise
};

/// A few numbers of a scene, chosen at random, and the slopes by these at an accuracy.
struct SlopeSubject {
  double speed;        ///< that velocities are relative to
  double impulse = 0;  ///< that gives the lightest body, or the lightest pair, this speed: impulses are
                       ///< relative to no less
  double spin = 0;     ///< that gives the farthest point of the largest body this speed, likewise
  std::vector<Probe> probes = {};
  std::function<impact::Sensitivity(double accuracy)> slopes = {};
  /// By every number that has a natural unit, likewise; empty if the scene is not asked for them.
  std::function<impact::Sensitivity()> all_slopes = {};
  std::vector<double> all_units = {};  ///< of these numbers
};

/// Numbers that can move both ways: gaps of contacts that touch are left out.
SlopeSubject slope_subject(const Scene& scene, Dice dice);

}  // namespace mariotte::stress_study
