#include "mariotte/model/network/dimensionless_network.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/contacts/bound.hpp"
#include "mariotte/model/contacts/start_balance.hpp"
#include "mariotte/model/representable.hpp"

namespace mariotte::model {
namespace {

using Numbers = std::vector<double>;

/// M⁻¹ w of each drive; of no use where it prescribes a motion.
std::vector<ContactDirection> pushes_of_drives(const Network& network) {
  if (network.drive.empty()) return {};
  std::vector<ContactDirection> directions;
  for (const auto& drive : network.drive) directions.push_back(drive.direction);
  return responses(network.mass, directions, std::ssize(network.velocity));
}

/// How fast each contact is indented faster and faster at the start.
Numbers start_approach(const Network& network, const StatedContacts& stated,
                       const std::vector<ContactDirection>& response,
                       const std::vector<ContactDirection>& pushes) {
  Numbers rate(network.velocity.size(), 0), approach;
  const auto push = [&](const ContactDirection& by, double force) {
    for (const auto& [dof, coefficient] : by) rate[dof] += coefficient * force;
  };
  const auto force = start_forces(stated);
  for (std::size_t j = 0; j < force.size(); ++j) push(response[j], force[j]);
  for (std::size_t k = 0; k < pushes.size(); ++k) push(pushes[k], start_force(network.drive[k]));
  for (const auto& direction : network.direction) approach.push_back(-gap_rate(direction, rate));
  return approach;
}

/// Of contacts that close or start indented, unless drives bring back what flies apart.
double largest_gap_rate(const Network& network) {
  double largest = 0, meeting = 0;
  for (std::size_t j = 0; j < network.direction.size(); ++j) {
    const double rate = gap_rate(network.direction[j], network.velocity);
    largest = std::max(largest, std::abs(rate));
    if (rate < 0 || network.gap[j] < 0) meeting = std::max(meeting, std::abs(rate));
  }
  return network.drive.empty() ? of_what_meets(meeting, largest) : largest;
}

/// Nothing is driven, adheres or is indented: masses do not matter to the speeds then.
bool has_velocities_alone(const Network& network) {
  return network.drive.empty() && std::none_of(network.law.begin(), network.law.end(), contact::adheres) &&
         std::none_of(network.gap.begin(), network.gap.end(), [](double gap) { return gap < 0; });
}

/// By the responses to contacts and to drives.
SquaredSpeeds squared_speeds(const Network& network, const Numbers& mass,
                             const std::vector<ContactDirection>& response,
                             const std::vector<ContactDirection>& pushes) {
  const double given = largest_gap_rate(network);
  SquaredSpeeds speeds{.given = given * given};
  for (std::size_t j = 0; j < mass.size(); ++j) {
    speeds.adhesion = std::max(speeds.adhesion, 2 * well_energy(network.law[j]) / mass[j]);
    if (network.gap[j] < 0) speeds.release(network.law[j], -network.gap[j], mass[j]);
  }
  for (std::size_t k = 0; k < network.drive.size(); ++k)
    speeds.drive(network.drive[k], dot(network.drive[k].direction, pushes[k]));
  const StatedContacts stated{network.law, network.gap, network.velocity};
  if (speeds.released > 0)
    speeds.unbalanced = unbalanced_speeds(stated, mass, start_approach(network, stated, response, pushes));
  return speeds;
}

void empty_lists(Index count, std::vector<std::vector<Index>>& lists) {
  lists.resize(count);
  for (auto& list : lists) list.clear();
}

void find_near(DimensionlessNetwork& d) {
  empty_lists(d.dofs, d.moved_by);
  for (Index j = 0; j < d.contacts(); ++j)
    for (const auto& term : d.direction[j]) d.moved_by[term.dof].push_back(j);
  empty_lists(d.contacts(), d.near);
  for (Index j = 0; j < d.contacts(); ++j) {
    auto& near = d.near[j];
    for (const auto& term : d.response[j])
      near.insert(near.end(), d.moved_by[term.dof].begin(), d.moved_by[term.dof].end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
}

void find_responses(const Network& network, DimensionlessNetwork& d) {
  d.direction = network.direction;
  responses(network.mass, network.direction, d.dofs, d.response);
  half_responses(network.mass, network.direction, d.dofs, d.half_response);
}

void scale_responses(DimensionlessNetwork& d) {
  for (auto& column : d.response)
    for (auto& term : column) term.coefficient *= d.scale.mass;
  for (auto& column : d.half_response)
    for (auto& term : column) term.coefficient *= std::sqrt(d.scale.mass);
}

}  // namespace

Speeds speeds(const Network& network) {
  if (has_velocities_alone(network)) {
    const double largest = largest_gap_rate(network);
    return {largest, largest};
  }
  std::vector<ContactDirection> response;
  responses(network.mass, network.direction, std::ssize(network.velocity), response);
  Numbers mass;
  for (std::size_t j = 0; j < response.size(); ++j)
    mass.push_back(1 / dot(network.direction[j], response[j]));
  const auto squared = squared_speeds(network, mass, response, pushes_of_drives(network));
  const double largest = std::sqrt(squared.all());
  return {largest, largest * squared.accurate_share()};
}

void make_dimensionless(const Network& network, double accuracy, DimensionlessNetwork& d) {
  d.dofs = std::ssize(network.velocity);
  find_responses(network, d);
  d.reduced_mass.clear();
  for (std::size_t j = 0; j < d.response.size(); ++j)
    d.reduced_mass.push_back(1 / dot(d.direction[j], d.response[j]));
  const auto pushes = pushes_of_drives(network);
  const auto speeds = squared_speeds(network, d.reduced_mass, d.response, pushes);
  const StatedContacts stated{network.law, network.gap, network.velocity};
  scale_contacts(stated, speeds.all() > 0 ? std::sqrt(speeds.all()) : 1, accuracy * speeds.in_balance(), d);
  take_speeds(speeds, d);
  d.drive.clear();
  for (std::size_t k = 0; k < pushes.size(); ++k)
    d.drive.push_back(in_units(network.drive[k], pushes[k], d.scale));
  scale_responses(d);
  expect_representable(network, d);
  find_near(d);
}

void restate(const Network& network, DimensionlessNetwork& d) {
  find_responses(network, d);
  scale_responses(d);
  restate_contacts({network.law, network.gap, network.velocity}, d);
}

}  // namespace mariotte::model
