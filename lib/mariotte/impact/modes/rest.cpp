#include "mariotte/impact/modes/rest.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/core/bracket.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/modes/directions.hpp"
#include "mariotte/model/chain/equilibrium.hpp"
#include "mariotte/model/dense.hpp"

namespace mariotte::impact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

[[noreturn]] void refuse(Index contact, const char* why) {
  throw InvalidParameter("contact " + std::to_string(contact + 1) + " " + why);
}

void add(Rest& rest, const contact::Law& law, double force, double indentation) {
  const Index j = std::ssize(rest.force);
  if (!(force > 0)) refuse(j, "carries no force at rest, so it has no stiffness");
  const auto* branched = contact::branched(law);
  if (branched && indentation > branched->yield_indentation({}))
    refuse(j, "yields at rest: its stiffness depends on how it was loaded");
  rest.force.push_back(force);
  rest.indentation.push_back(indentation);
  rest.stiffness.push_back(contact::smooth_force(law, indentation, 0).by_indentation);
}

/// Contacts `first` to `last` between one wall and the next, or the end of the row.
struct Part {
  Index first, last;
  bool wall_before, wall_behind;
};

std::vector<Part> parts(const model::Chain& chain) {
  std::vector<Part> all;
  const Index balls = std::ssize(chain.mass);
  for (Index first = 0, i = 1; i < balls; ++i) {
    if (!std::isinf(chain.mass[i]) && i + 1 < balls) continue;
    all.push_back({first, i - 1, std::isinf(chain.mass[first]), std::isinf(chain.mass[i])});
    first = i;
  }
  return all;
}

/// The force at the upper wall, so that the part is as short as its walls leave it. A contact that never
/// comes to its force gives way without end.
double force_between_walls(const model::Chain& chain, const Part& part, const std::vector<double>& weight) {
  constexpr double endless = 1e300;
  double overlap = 0, lightest = infinity;
  for (Index j = part.first; j <= part.last; ++j) {
    overlap -= chain.gap[j];
    lightest = std::min(lightest, weight[j]);
  }
  const auto excess = [&](double force) {
    double sum = -overlap;
    for (Index j = part.first; j <= part.last; ++j)
      if (force + weight[j] > 0)
        sum += contact::find_static_indentation(chain.law[j], force + weight[j]).value_or(endless);
    return sum;
  };
  if (!(excess(-lightest) < 0)) refuse(part.first, "is in a part of the row that its walls do not press");
  double high = std::max(1.0, std::abs(lightest));
  while (excess(high) < 0) high *= 16;
  while (excess(high / 16) > 0 && high > 1e-300) high /= 16;
  const double low = std::max(-lightest, high / 16);
  return locate_sign_change(excess, low, excess(low), high, excess(high), epsilon * high);
}

double force_of(const model::Chain& chain, const Part& part, const std::vector<double>& weight) {
  if (part.wall_before && part.wall_behind) return force_between_walls(chain, part, weight);
  if (!part.wall_before && !part.wall_behind && chain.gravity == 0)
    refuse(part.first, "is pressed by nothing: give a force at the ends, or walls");
  return 0;
}

std::span<const double> span(const auto& numbers) {
  return {numbers.data(), static_cast<std::size_t>(numbers.size())};
}
MatrixXd stiffness_matrix(const MatrixXd& direction, const VectorXd& stiffness) {
  return direction * stiffness.asDiagonal() * direction.transpose();
}

/// Forces and slopes of a network's contacts at their indentations; open ones carry nothing.
struct Springs {
  double energy = 0;
  VectorXd force, stiffness;
};
Springs springs(const model::Network& network, const VectorXd& gap) {
  Springs all{.force = VectorXd::Zero(gap.size()), .stiffness = VectorXd::Zero(gap.size())};
  for (Index j = 0; j < gap.size(); ++j) {
    if (gap[j] >= 0) continue;
    const auto at = contact::smooth_force(network.law[j], -gap[j], 0);
    all.energy += contact::stored_energy(network.law[j], -gap[j]);
    all.force[j] = at.value;
    all.stiffness[j] = at.by_indentation;
  }
  return all;
}

/// Gaps after Newton's step, or a shorter one that lowers the energy; the same gaps if none does.
VectorXd step(const model::Network& network, const MatrixXd& direction, const VectorXd& gap) {
  const auto now = springs(network, gap);
  const MatrixXd stiffness = stiffness_matrix(direction, now.stiffness);
  const VectorXd load = direction * now.force;
  const auto moved = model::MinimumNorm({span(stiffness), load.size()}).solve(span(load));
  const Eigen::Map<const VectorXd> move(moved.data(), load.size());
  for (double part = 1; part > 1e-10; part /= 2) {
    const VectorXd next = gap + part * (direction.transpose() * move);
    const auto then = springs(network, next);
    if ((direction * then.force).norm() < (direction * now.force).norm() || then.energy < now.energy)
      return next;
  }
  return gap;
}

}  // namespace

Rest rest(const model::Chain& chain, std::optional<double> end_force) {
  if (end_force && !(*end_force > 0 && *end_force < infinity))
    throw InvalidParameter("the force at the ends must be positive and finite");
  for (std::size_t j = 0; j < chain.gap.size(); ++j)
    if (chain.gap[j] > 0) refuse(static_cast<Index>(j), "is open at rest");
  const auto weight = model::static_forces(chain);
  Rest all;
  for (const auto& part : parts(chain)) {
    const double force = end_force ? *end_force : force_of(chain, part, weight);
    for (Index j = part.first; j <= part.last; ++j) {
      const double carried = force + weight[j];
      add(all, chain.law[j], carried, carried > 0 ? contact::static_indentation(chain.law[j], carried) : 0);
    }
  }
  return all;
}

Rest rest(const model::Network& network) {
  validate(network);
  const auto columns = half_directions(network);
  const Eigen::Map<const MatrixXd> direction(columns.data(), std::ssize(network.velocity),
                                             std::ssize(network.gap));
  VectorXd gap = Eigen::Map<const VectorXd>(network.gap.data(), std::ssize(network.gap));
  constexpr int most = 200;
  for (int i = 0; i < most; ++i) {
    const VectorXd next = step(network, direction, gap);
    const bool stands = (next - gap).cwiseAbs().maxCoeff() <= 4 * epsilon * gap.cwiseAbs().maxCoeff();
    gap = next;
    if (stands) break;
  }
  const auto at = springs(network, gap);
  const double scale = direction.cwiseAbs().maxCoeff() * at.force.maxCoeff();
  if ((direction * at.force).cwiseAbs().maxCoeff() > 1e-12 * scale)
    throw InvalidParameter("no static equilibrium was found");
  Rest all;
  for (Index j = 0; j < gap.size(); ++j) add(all, network.law[j], at.force[j], -gap[j]);
  return all;
}

}  // namespace mariotte::impact
