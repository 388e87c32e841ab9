// A chain of balls on a line: the parameters a user states, in SI (or any consistent) units.
#pragma once
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/model/drives/drive.hpp"

namespace mariotte::model {

/// Balls 1..n from left to right; contact j joins balls j and j+1 [Acary 2003, §2]. A wall is a ball of
/// infinite mass; it keeps its velocity and feels no gravity.
struct Chain {
  std::vector<double> mass;       ///< m_i > 0, n values [kg]
  std::vector<contact::Law> law;  ///< contact laws, n−1 values
  std::vector<double> gap;        ///< start gaps g_j, n−1 values [m]; < 0 only if `precompressed`
  std::vector<double> velocity;   ///< start velocities, n values [m/s]
  double gravity = 0;             ///< acceleration of every ball towards decreasing position [m/s²]
  bool precompressed = false;     ///< contacts may start indented
  std::vector<Drive> drive = {};  ///< of walls, or forces on balls
};

/// Throws InvalidParameter, naming ball or contact (from 1), unless the chain is one that can be simulated:
/// n ≥ 2, lengths match, masses positive and not NaN, everything else finite, stiffness > 0, damping ≥ 0,
/// exponent ≥ 1, gaps ≥ 0 unless precompressed; drives as `validate_drives` has it, and a wall or no gravity
/// where one is a force.
void validate(const Chain& chain);

/// Whether gravity, towards decreasing position or upwards, pulls some ball back to a wall.
bool falls_back(const Chain& chain);

/// Whether gravity presses all balls, which touch and move as one, against walls, and dampers bring them to
/// rest.
bool comes_to_rest(const Chain& chain);

/// Throws InvalidParameter if the chain comes to rest, if there is a drive, or a wall moves towards another,
/// which squeezes what is between them for ever, and no `max_time` [s] ends that.
void expect_end(const Chain& chain, double max_time);

/// ½ Σ m v² of the balls of finite mass at any velocities [J].
double kinetic_energy(const Chain& chain, const std::vector<double>& velocity);

/// A contact that touches at rest must not adhere: whether it is closed would be open.
void expect_no_touch(std::size_t j, const contact::Law& law, double gap, double approach);
/// The rules for contact j (from 0) of a `whole`, "chain" or "network".
void validate_contact(std::size_t j, const contact::Law& law, double gap, bool precompressed,
                      const char* whole);

}  // namespace mariotte::model
