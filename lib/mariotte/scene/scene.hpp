// A scene: what the user wrote, resolved to SI values and checked.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/network.hpp"
#include "mariotte/scene/fault.hpp"
#include "mariotte/scene/law_reader.hpp"

namespace mariotte::scene {

/// A scene that was rejected; what() reads "file:line:column: message".
struct SceneError : Error {
  SceneError(const std::string& what, Fault kind) : Error(what, kind) {}
};

/// A file that could not be read; what() names it.
struct FileError : Error {
  explicit FileError(const std::string& what) : Error(what, fault::unreadable) {}
};

/// Of a chain, a network or a body: `network` and `body` are empty of others, and `chain` has no balls.
struct Scene {
  std::string title;
  model::Chain chain;  ///< without balls if [law] stands alone
  std::optional<model::Network> network;
  std::optional<model::Microbody> body;
  std::optional<Law> law;      ///< of scenes with [law]
  std::vector<double> radius;  ///< n values [m], infinite for planes; empty unless every ball has one
  hybrid::Options run;
  std::vector<std::string> warnings;  ///< "file:line:column: message" of suspicious but possible values
  std::string sha256;                 ///< of the scene's text and overrides, for provenance
};

/// One `--set KEY=VALUE`: keys count from 0 with brackets, as in "chain.velocity[0]=2 m/s".
using Overrides = std::vector<std::string>;

/// What a scene is read for: a model to simulate, or the multiple-impact law, for which the masses and
/// velocities of [law] are enough.
enum class Purpose { simulation, law };

/// Read a scene from a file. Throws FileError or SceneError.
Scene read(const std::string& path, const Overrides& overrides = {}, Purpose purpose = Purpose::simulation);

/// Read a scene from text; `name` stands for the file in messages. Throws SceneError.
Scene parse(const std::string& text, const std::string& name, const Overrides& overrides = {},
            Purpose purpose = Purpose::simulation);

}  // namespace mariotte::scene
