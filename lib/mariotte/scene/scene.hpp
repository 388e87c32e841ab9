// A scene: what the user wrote, resolved to SI values and checked.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/validity.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/network.hpp"
#include "mariotte/scene/fault.hpp"
#include "mariotte/scene/figure.hpp"
#include "mariotte/scene/law.hpp"

namespace mariotte::scene {

/// A scene that was rejected; what() reads "file:line:column: message".
struct SceneError : Error {
  SceneError(const std::string& what, Fault kind) : Error(what, kind) {}

  std::string place = {};             ///< "file:line:column" or "--set KEY"; empty if nothing was written
  int line = 0, column = 0;           ///< the same as numbers; 0 if it is not in the file
  std::string key = {};               ///< that leads to it, as "chain.radius"; empty if none does
  std::vector<SceneError> more = {};  ///< what else is wrong, without a `more` of its own
};

/// A file that could not be read; what() names it.
struct FileError : Error {
  explicit FileError(const std::string& what, std::string file = {}, int problem = 0)
      : Error(what, fault::unreadable), path(std::move(file)), number(problem) {}

  std::string path;  ///< of the file, if it is known
  int number;        ///< errno, if the system said why; else 0
};

/// Instead of a model, in a scene with [law] alone: the law has masses and velocities of its own.
struct LawAlone {};

/// What a scene is of.
using Model = std::variant<LawAlone, model::Chain, model::Network, model::Microbody, model::Bodies>;

/// A model, and what is to be done with it.
struct Scene {
  std::string title;
  Model model;
  std::optional<Law> law;              ///< of scenes with [law]
  std::vector<double> radius;          ///< n values [m], infinite for planes; empty unless every ball has one
  std::vector<model::Ball> ball = {};  ///< of a network of balls
  double reach = 0;                    ///< beyond which these have no contacts [m]
  /// One per contact, or tip; empty if nothing is known of the bodies.
  std::vector<impact::Touching> touching;
  hybrid::Options run;
  Figure figure;
  bool until = false;                 ///< whether the time limit is the end that is wanted, by run.until
  std::vector<std::string> warnings;  ///< "file:line:column: message" of suspicious but possible values
  std::string sha256;                 ///< of text, overrides and tables, for provenance
};

/// One `--set KEY=VALUE`: keys count from 0 with brackets, as in "chain.velocity[0]=2 m/s".
using Overrides = std::vector<std::string>;

/// What a scene is read for: a model to simulate; the multiple-impact law, for which the masses and
/// velocities of [law] are enough; or what a model is at rest, which needs no end.
enum class Purpose { simulation, law, rest };

/// Where a model is needed: throws SceneError, since there is none.
[[noreturn]] void refuse(const LawAlone& nothing);

/// Read a scene from a file. Throws FileError or SceneError.
Scene read(const std::string& path, const Overrides& overrides = {}, Purpose purpose = Purpose::simulation);

/// Read a scene from text; `name` stands for the file in messages. Throws SceneError.
Scene parse(const std::string& text, const std::string& name, const Overrides& overrides = {},
            Purpose purpose = Purpose::simulation);

}  // namespace mariotte::scene
