#include "mariotte/impact/doubt.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace mariotte::impact {
namespace {

constexpr const char* velocities = "velocities may be wrong";

}  // namespace

std::string doubt(std::optional<double> estimated, double asked) {
  if (!(estimated > asked)) return "";
  if (!std::isfinite(*estimated)) return std::string("nothing tells by how much ") + velocities;
  std::ostringstream text;
  text << velocities << " by " << std::scientific << std::setprecision(1) << *estimated
       << " of the largest speed, where " << std::defaultfloat << std::setprecision(6) << asked
       << " was asked";
  return text.str();
}

bool tells_doubt(std::string_view text) {
  return text.find(velocities) != text.npos;
}

}  // namespace mariotte::impact
