#include "mariotte/model/islands/island.hpp"

#include <algorithm>

namespace mariotte::model {

using contact::ContactMode;

namespace {

/// Beyond its margins an island is split where so many contacts idle, and trimmed where so many at an end do.
constexpr Index idle = 12;

/// What an active contact must keep from an edge in one direction.
Index margin(const contact::ContactSet& mode, Index contact, Index direction, Index margin_of_rows) {
  const Index next = contact + direction;
  const bool row = next >= 0 && next < std::ssize(mode) && mode[next] == ContactMode::touching;
  return row ? margin_of_rows : 1;
}

}  // namespace

bool is_active(const ChainState& state, ContactMode mode, Index j) {
  const auto& chain = state.model();
  const bool driven = state.topology.drive(j) != 0;
  switch (mode) {
    case ContactMode::closed:
      return true;
    case ContactMode::touching:
      return driven || state.clearance(j) < -2 * chain.fading_depth(j) ||
             (state.clearance(j) <= 0 && state.approach(j) > chain.noise_speed);
    case ContactMode::slack:
      return driven || state.approach(j) > chain.noise_speed;
    default:
      return false;
  }
}

Index margin_of_rows(const DimensionlessChain& chain) {
  const auto has_no_waking_depth = [](const contact::Law& law) {
    if (const auto* power = power_law(law)) return power->exponent == 1;
    const auto* branches = contact::branched(law);
    const auto fresh = branches ? branches->power({}) : std::nullopt;
    return !fresh || fresh->exponent == 1;
  };
  return std::any_of(chain.law.begin(), chain.law.end(), has_no_waking_depth) ? 10 : 2;
}

bool is_well_cut(const Island& island) {
  const ChainState state{{island.system.chain(), island.system.layout()}, island.start, &island.held};
  const auto edges = island.system.phase().flows().edges();
  const Index count = island.contacts(), most = idle + edges.margin;
  const auto room = [&](Index j, Index direction) { return margin(island.held, j, direction, edges.margin); };
  Index last = -1;
  for (Index j = 0; j < count; ++j) {
    if (!is_active(state, island.held[j], j)) continue;
    if (j - last > most || (last < 0 && edges.left && j < room(j, -1))) return false;
    last = j;
  }
  return last >= 0 && count - last <= most && !(edges.right && count - 1 - last < room(last, 1));
}

void find_groups(const ChainState& state, const contact::ContactSet& mode, Index from, Index to,
                 Index margin_of_rows, std::vector<Group>& groups) {
  groups.clear();
  for (Index j = from; j <= to; ++j) {
    if (!is_active(state, mode[j], j)) continue;
    const Index left = margin(mode, j, -1, margin_of_rows), right = margin(mode, j, 1, margin_of_rows);
    if (groups.empty() || j - groups.back().last < groups.back().right_margin + left + 2) {
      if (groups.empty()) groups.push_back({j, j, left, right});
      groups.back().last = j;
      groups.back().right_margin = right;
    } else {
      groups.push_back({j, j, left, right});
    }
  }
}

}  // namespace mariotte::model
