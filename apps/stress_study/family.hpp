// Kinds of random scenes: a name, and how one is drawn.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "dice.hpp"
#include "scene.hpp"

namespace mariotte::stress_study {

/// One kind of scene.
struct Family {
  std::string name;
  std::function<Scene(Dice&)> draw;
  std::uint64_t every = 1;  ///< its turns that it takes; the others go to families that take all
  bool slopes = false;      ///< examine slopes by its numbers instead of runs
};

std::vector<Family> chain_families();
std::vector<Family> network_families();
std::vector<Family> body_families();
std::vector<Family> law_families();
std::vector<Family> friction_families();
std::vector<Family> row_families();

/// Families of these kinds, of which slopes are examined; bodies with friction have them of power laws.
std::vector<Family> slope_families(const std::vector<std::string>& kinds);

/// All families of the kinds "chains", "networks", "bodies", "laws", "friction", "rows", "slopes",
/// "friction-slopes".
std::vector<Family> families(const std::vector<std::string>& kinds);

/// Place in the list of the family that scene `number` is drawn from: they take turns.
std::size_t family_of(const std::vector<Family>& list, std::uint64_t number);

/// Scene number `number` of a seed.
Scene scene_of(const std::vector<Family>& list, std::uint64_t seed, std::uint64_t number);

}  // namespace mariotte::stress_study
