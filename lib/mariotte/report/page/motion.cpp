#include "mariotte/report/page/motion.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/report/page/motion_frames.hpp"

namespace mariotte::report {
namespace {

std::vector<double> frames(const impact::Trace& trace, const scene::Scene& scene) {
  return instants(time_axis(action_of(trace), {}, scene.figure).windows, trace.time, trace.force);
}

/// Where the discs are at the samples of a trace; velocities are linear between them. Discs have `dimension`
/// directions in turn, of which the first two are seen.
Rows places(const impact::Trace& trace, const std::vector<Disc>& discs, std::size_t dimension) {
  Rows rows;
  std::vector<double> place;
  for (const auto& disc : discs) place.insert(place.end(), {disc.x, disc.y});
  for (std::size_t row = 0; row < trace.time.size(); ++row) {
    const auto& before = trace.velocity[row > 0 ? row - 1 : 0];
    const double step = row > 0 ? trace.time[row] - trace.time[row - 1] : 0;
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t k = 0; k < std::min<std::size_t>(2, dimension); ++k)
        place[2 * i + k] += 0.5 * step * (before[i * dimension + k] + trace.velocity[row][i * dimension + k]);
    rows.push_back(place);
  }
  return rows;
}

/// The same and forces at these instants.
Course course_of(const impact::Trace& trace, const std::vector<Disc>& discs, std::size_t dimension,
                 const std::vector<double>& times) {
  const auto samples = places(trace, discs, dimension);
  Course course{times, {}, {}};
  for (const double time : times) {
    const auto at = position(trace.time, time);
    const auto [row, part] = at;
    const double passed = part * (trace.time[row + 1] - trace.time[row]);
    auto place = samples[row];
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t k = 0; k < std::min<std::size_t>(2, dimension); ++k) {
        const double from = trace.velocity[row][i * dimension + k];
        const double to = trace.velocity[row + 1][i * dimension + k];
        place[2 * i + k] += passed * (from + 0.5 * part * (to - from));
      }
    course.place.push_back(std::move(place));
    course.force.push_back(between(trace.force, at));
  }
  return course;
}

/// Where radii are not known: so large that motion is small against them, and gaps are.
std::vector<double> radii_that_look_well(const impact::Trace& trace, const model::Chain& chain) {
  double most = *std::max_element(chain.gap.begin(), chain.gap.end());
  const auto course = course_of(trace, std::vector<Disc>(chain.mass.size()), 1, trace.time);
  for (const auto& row : course.place)
    for (const double moved : row) most = std::max(most, std::abs(moved));
  std::vector<double> radii;
  for (const double mass : chain.mass) radii.push_back(std::isinf(mass) ? infinity : most > 0 ? 4 * most : 1);
  return radii;
}

std::vector<Disc> row_of_discs(const model::Chain& chain, const std::vector<double>& radius) {
  std::vector<Disc> discs;
  const auto size = [&](std::size_t i) { return std::isfinite(radius[i]) ? radius[i] : 0; };
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    const bool is_wall = std::isinf(chain.mass[i]);
    const double x = i == 0 ? 0 : discs.back().x + size(i - 1) + chain.gap[i - 1] + size(i);
    discs.push_back({x, 0, is_wall ? infinity : radius[i]});
  }
  return discs;
}

struct Joint {
  std::size_t from, to;
  double x, y, distance;
};

/// Contacts of balls as steps from one centre to the other.
std::vector<Joint> joints(const model::Network& network, const std::vector<double>& radius) {
  std::vector<Joint> all;
  for (Index j = 0; j < std::ssize(network.law); ++j) {
    const auto pair = balls_of(network, j);
    double x = 0, y = 0;
    for (const auto& term : network.direction[static_cast<std::size_t>(j)]) {
      if (term.dof / network.dimension != pair->right) continue;
      (term.dof % network.dimension == 0 ? x : term.dof % network.dimension == 1 ? y : x) += term.coefficient;
    }
    const auto left = static_cast<std::size_t>(pair->left), right = static_cast<std::size_t>(pair->right);
    all.push_back(
        {left, right, x, y, radius[left] + radius[right] + network.gap[static_cast<std::size_t>(j)]});
  }
  return all;
}

/// Places that follow from the contacts, ball 1 at the origin; empty if contacts do not join all balls.
std::vector<Disc> placed(const std::vector<double>& radius, const std::vector<Joint>& joints) {
  std::vector<Disc> discs(radius.size());
  std::vector<bool> known(radius.size(), false);
  for (std::size_t i = 0; i < radius.size(); ++i) discs[i].radius = radius[i];
  known[0] = true;
  for (bool found = true; found;) {
    found = false;
    for (const auto& one : joints) {
      if (known[one.from] == known[one.to]) continue;
      const auto [a, b] = known[one.from] ? std::pair{one.from, one.to} : std::pair{one.to, one.from};
      const double step = known[one.from] ? one.distance : -one.distance;
      discs[b] = {discs[a].x + step * one.x, discs[a].y + step * one.y, radius[b]};
      known[b] = found = true;
    }
  }
  if (std::find(known.begin(), known.end(), false) != known.end()) return {};
  return discs;
}

}  // namespace

Json motion(const impact::ChainImpact& impact, const scene::Scene& scene) {
  const auto& chain = std::get<model::Chain>(scene.model);
  const auto& trace = impact.trace;
  if (trace.time.size() < 2 || chain.mass.size() > most_discs) return {};
  auto radius = scene.radius;
  if (radius.empty()) radius = radii_that_look_well(trace, chain);
  const auto discs = row_of_discs(chain, radius);
  std::vector<DiscContact> contacts;
  for (int j = 0; j < static_cast<int>(chain.law.size()); ++j) contacts.push_back({j, j + 1, 1, 0});
  auto all = as_json(discs, contacts, course_of(trace, discs, 1, frames(trace, scene)));
  all["to_scale"] = !scene.radius.empty();
  return all;
}

Json motion(const impact::NetworkImpact& impact, const scene::Scene& scene) {
  const auto& network = std::get<model::Network>(scene.model);
  const auto& trace = impact.trace;
  if (trace.time.size() < 2 || network.dimension == 0 || scene.radius.size() > most_discs) return {};
  const auto all = joints(network, scene.radius);
  const auto discs = placed(scene.radius, all);
  if (discs.empty()) return {};
  std::vector<DiscContact> contacts;
  for (const auto& one : all)
    contacts.push_back({static_cast<int>(one.from), static_cast<int>(one.to), one.x, one.y});
  const auto dimension = static_cast<std::size_t>(network.dimension);
  return as_json(discs, contacts, course_of(trace, discs, dimension, frames(trace, scene)));
}

}  // namespace mariotte::report
