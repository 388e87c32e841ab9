// A random scene: a model, and until when it is followed.
#pragma once
#include <string>
#include <variant>

#include "mariotte/core/types.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::stress_study {

/// A body with the text that it was read from: most of what it is made of follows from other numbers.
struct Body {
  model::Microbody body;
  std::string text;
};

/// Bodies with friction, likewise.
struct Group {
  model::Bodies bodies;
  std::string text;
};

/// What can be run, perturbed, followed naively and written down.
using Model = std::variant<model::Chain, model::Network, Body, Group>;

/// A model with its time limit.
struct Scene {
  Model model;
  double max_time = infinity;  ///< [s]
};

/// The scene as a file that repeats it to the last digit; `notes` become comments.
std::string text(const Scene& scene, double accuracy, const std::string& notes);

/// Speed that its parts can reach relative to each other: what errors are relative to.
double reference_speed(const Model& model);

}  // namespace mariotte::stress_study
