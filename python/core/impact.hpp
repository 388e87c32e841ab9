// The impact of a scene as Python holds it: quick numbers first, everything else when it is asked for.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/scene/simulate.hpp"
#include "scene_box.hpp"

namespace mariotte::python {

/// A short chain is solved by the quickest solver, which knows ending, time, velocities and impulses. What it
/// does not know makes `whole` simulate the scene, once; both give the same bits. Other models, and those
/// whose error is to be estimated, are simulated at once; so are chains whose indentations have limits.
class Impact {
 public:
  /// Called with the interpreter's lock, which is let go while it runs.
  Impact(SharedScene box, const hybrid::Options& options, bool until, bool estimate);

  const scene::Impact& whole() const;
  /// The quick numbers; empty if there are none.
  const std::optional<impact::BriefImpact>& brief() const { return brief_; }
  const std::vector<double>& icr() const { return icr_; }  ///< nan where there is none
  /// Of the scene and of the run, as JSON has them; what the quick numbers leave open is computed.
  std::vector<std::string> warnings() const;
  const hybrid::Options& options() const { return options_; }
  const SceneBox& box() const { return *box_; }
  /// The scene as it was run.
  scene::Scene scene() const;

 private:
  bool solve_quickly();
  void keep_ratios();

  SharedScene box_;
  hybrid::Options options_;
  bool until_;
  std::optional<impact::BriefImpact> brief_;
  mutable std::optional<scene::Impact> whole_;
  std::vector<double> icr_;
};

/// Simulates the scene's model, and estimates the error if asked to by a second, tighter run; Ctrl-C ends the
/// first. Called without the lock.
scene::Impact simulate(const SceneBox& box, const hybrid::Options& options,
                       impact::RunObserver observers = {}, bool estimate = false);

}  // namespace mariotte::python
