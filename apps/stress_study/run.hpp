// One run of one scene, and what is compared of it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "scene.hpp"
#include "support/naive_steps.hpp"

namespace mariotte::stress_study {

/// How a scene is run.
struct Method {
  std::string flow = "auto";
  double accuracy = 1e-10;
  bool balances = false;  ///< with energies and periods, as `mariotte run` does; else as a sweep does
};

/// "auto at 1e-08".
std::string name(const Method& method);

/// What a run found.
struct Found {
  hybrid::Ending ending = hybrid::Ending::failed;
  std::string message = {};  ///< why, of endings that are not expected
  double time = 0;           ///< of the ending [s]
  std::vector<double> value =
      {};  ///< velocities, or what else errors are promised of, over the reference speed
  std::vector<Index> periods = {};   ///< per contact
  std::vector<double> impulse = {};  ///< per contact, over moving mass × reference speed
  double estimate = 0;               ///< of the error, if the run says one
  double imbalance = 0;              ///< worst of the balances, relative to the energy at the reference speed
  double peak_misfit = 0;  ///< of largest forces of elastic contacts, relative to the largest of all
  double rounding = 0;     ///< of velocities in the frame of the scene, over the reference speed
  bool refused = false;    ///< by name, before it began
  Index work = 0;          ///< evaluations of the right-hand side, or of its series
  double seconds = 0;      ///< CPU time
};

/// Changes of the set of contacts after which a run is given up.
inline constexpr Index most_events = 5000;

/// Run it. What the library throws is a result, too.
Found run(const Scene& scene, const Method& method);

/// Motion of one body less what gravity has given to it, its spin as a speed of its surface.
void add_motion(const Group& scene, std::size_t body, const Vector3& velocity, const Vector3& spin,
                Found& found);

/// The same by a simulator that shares nothing with the library, until `end` [s]; empty if it has no way to
/// follow the scene or would need too many steps.
std::optional<Found> run_naively(const Scene& scene, double end, const test::Effort& effort);

/// A scene whose numbers differ by about `size`, relative to themselves or to what is natural; `direction`
/// says how.
Scene perturbed(const Scene& scene, double size, std::uint64_t direction);

/// Largest difference of two results, relative to the reference speed; infinite if one has none.
double distance(const Found& one, const Found& other);

}  // namespace mariotte::stress_study
