// Rigid bodies that touch each other and planes with friction, and turn while they do: the parameters a user
// states, in SI (or any consistent) units.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/quaternion.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// A sphere fixed to a body; a point if its radius is 0.
struct BodySphere {
  Vector3 centre;     ///< from the mass centre, body axes [m]
  double radius = 0;  ///< ≥ 0 [m]
};

/// One rigid body. In the plane vectors have no e3, and inertia.e3 is its moment about the mass centre.
struct Body {
  std::string name = {};
  double mass = 0;                       ///< [kg]
  Vector3 inertia = {};                  ///< principal moments, body axes [kg m²]
  std::vector<BodySphere> spheres = {};  ///< by which it touches
  Vector3 position = {};                 ///< of the mass centre [m]
  Quaternion attitude = {};              ///< in space
  double angle = 0;                      ///< in the plane [rad]
  Vector3 velocity = {};                 ///< of the mass centre [m/s]
  Vector3 spin = {};                     ///< space axes; in the plane e3 alone [rad/s]
};

/// A plane that rests or moves; bodies are on the side to which its normal points.
struct Plane {
  std::string name = {};
  Vector3 point = {};     ///< [m]
  Vector3 normal = {};    ///< of length 1
  Vector3 velocity = {};  ///< constant [m/s]
};

/// How the friction of a contact grows: none; stick as a constraint; a spring of constant stiffness k_t
/// [Cundall & Strack 1979]; k_t = κ √δ, incremental on loading and rescaled on unloading [Mindlin 1949;
/// Thornton, Cummins & Cleary 2013]. Coulomb's μ f_n caps all of them.
enum class TangentialLaw { none, rigid, spring, mindlin };

/// Friction of a contact, by numbers or by values with slopes.
template <class N>
struct BasicTangential {
  TangentialLaw law = TangentialLaw::none;
  N friction = 0;   ///< μ ≥ 0
  N stiffness = 0;  ///< k_t [N/m] of a spring, κ [N/m^{3/2}] of Mindlin's law

  bool has_spring() const { return law == TangentialLaw::spring || law == TangentialLaw::mindlin; }
};
/// Of plain numbers.
using Tangential = BasicTangential<double>;

/// Where a contact is: a sphere of a body, or a plane; from 0.
struct Feature {
  Index owner = 0;   ///< body or plane
  Index sphere = 0;  ///< of the body; −1 of a plane

  bool is_plane() const { return sphere < 0; }
  bool operator==(const Feature&) const = default;
};

/// One pair of features that may touch. The normal points from a to b; a plane is always a.
struct BodyContact {
  Feature a = {}, b = {};
  contact::Law law = contact::Hertz{1};
  Tangential tangential = {};
  double share = 0.5;  ///< 0 ≤ s ≤ 1: forces act at c_b − (r_b − s δ) n
  /// The gap at the start is zero to the last bit, whatever the positions say to rounding.
  bool touching = false;
};

/// Bodies, planes and the pairs among them that may touch.
struct Bodies {
  int dimension = 3;     ///< 2 or 3
  Vector3 gravity = {};  ///< [m/s²]
  std::vector<Body> body = {};
  std::vector<Plane> plane = {};
  std::vector<BodyContact> contact = {};
  Index named = 0;  ///< so many of the first have tables of their own
};

/// "none", "rigid", "spring", "mindlin".
const char* name(TangentialLaw law);
/// The law of that name, if there is one.
std::optional<TangentialLaw> tangential_law(std::string_view name);

/// "rod", or "rod.2" if the body has several spheres; "body 1" and "plane 1" for what has no name.
std::string name_of(const Bodies& bodies, const Feature& feature);

/// "body 1" for one that has no name.
std::string body_name(const Bodies& bodies, Index i);

/// So many of the first contacts are in results even if they never close, so that their numbers are the same
/// in all results: of few pairs all, else those that are named.
Index always_told(const Bodies& bodies);

/// Gap of a contact at the start [m].
double start_gap(const Bodies& bodies, const BodyContact& contact);

/// Throws InvalidParameter unless masses, moments, radii, laws and motion make sense, and no pair overlaps.
void validate(const Bodies& bodies);

/// Throws InvalidParameter if bodies may adhere for ever and no `max_time` [s] ends that.
void expect_end(const Bodies& bodies, double max_time);

}  // namespace mariotte::model
