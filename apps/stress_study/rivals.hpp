// Which other flows a scene is run by.
#pragma once
#include <string>
#include <vector>

#include "scene.hpp"

namespace mariotte::stress_study {

/// Largest damping group of the contacts, c over that which has about the effect of √(k m*).
double damping_group(const Model& model);

/// Longest run over the shortest natural time of a contact; 1 for bodies.
double stiffness(const Scene& scene, double end);

/// Contact periods that time allows; none for bodies, which have few.
double most_contacts(const Scene& scene, double time);

/// Flows that follow any phase of the scene and share nothing with the automatic choice; empty if all of them
/// would take too long. The first is the one that fits best.
std::vector<std::string> general_flows(const Scene& scene, double end);

/// Flows that the scene may be run by beside the general ones, if they take no longer than these.
std::vector<std::string> special_flows(const Scene& scene, double end);

}  // namespace mariotte::stress_study
