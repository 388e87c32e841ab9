#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "mariotte/impact/network/network_impact.hpp"
#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

/// Disks that are joined with each other.
class Groups {
 public:
  explicit Groups(Index disks) : parent_(disks) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index of(Index disk) {
    while (parent_[disk] != disk) disk = parent_[disk] = parent_[parent_[disk]];
    return disk;
  }
  void join(model::BallPair pair) { parent_[of(pair.left)] = of(pair.right); }

 private:
  std::vector<Index> parent_;
};

/// Sums over samples of a run.
struct Parts {
  double samples = 0;       ///< in which some contact pushes
  double pushing = 0;       ///< contacts
  double parts = 0;         ///< of these: those of one part push on disks that they share
  double moved_parts = 0;   ///< where what they move belongs to a part, too
  double largest_part = 0;  ///< contacts that push in the largest of the latter
};

/// The parts that hold a contact which pushes, and how many of these the largest holds.
std::pair<Index, Index> count(Groups groups, const std::vector<model::BallPair>& pushing) {
  std::vector<Index> group;
  for (const auto& pair : pushing) group.push_back(groups.of(pair.left));
  std::sort(group.begin(), group.end());
  Index parts = 0, largest = 0;
  for (auto from = group.begin(); from != group.end(); ++parts) {
    const auto to = std::upper_bound(from, group.end(), *from);
    largest = std::max<Index>(largest, to - from);
    from = to;
  }
  return {parts, largest};
}

void add(Parts& sum, const std::vector<model::BallPair>& pairs, Index disks,
         const std::vector<double>& force) {
  constexpr double faint = 1e-6;  // beside the largest force
  const double least = faint * *std::max_element(force.begin(), force.end());
  std::vector<model::BallPair> pushing;
  std::vector<bool> is_moved(disks);
  Groups apart(disks), together(disks);
  for (std::size_t j = 0; j < pairs.size(); ++j) {
    if (!(force[j] > least)) continue;
    pushing.push_back(pairs[j]);
    apart.join(pairs[j]);
    is_moved[pairs[j].left] = is_moved[pairs[j].right] = true;
  }
  for (const auto& pair : pairs)
    if (is_moved[pair.left] || is_moved[pair.right]) together.join(pair);
  const auto [parts, largest] = count(together, pushing);
  sum.samples += !pushing.empty();
  sum.pushing += static_cast<double>(pushing.size());
  sum.parts += static_cast<double>(count(apart, pushing).first);
  sum.moved_parts += static_cast<double>(parts);
  sum.largest_part += static_cast<double>(largest);
}

/// Looks at a run ten times in each natural time of a contact.
Statement parts_statement(const ImpactCase& one) {
  const auto network = packing(one);
  const Index contacts = std::ssize(network.law), disks = one.side * one.side;
  std::vector<model::BallPair> pairs;
  for (Index j = 0; j < contacts; ++j) pairs.push_back(*model::balls_of(network, j));
  impact::Sampling sampling;
  sampling.contacts.resize(contacts);
  std::iota(sampling.contacts.begin(), sampling.contacts.end(), 0);
  Parts sum;
  sampling.take = [&](const impact::Sample& sample) {
    add(sum, pairs, disks, sample.force);
    return 0.1 * sample.natural_time;
  };
  sampling.restart = [&] { sum = {}; };
  impact::simulate(network, {.accuracy = 1e-6}, {.samplings = {sampling}});
  return {
      Statement::Kind::observation,
      fmt::format("{} disks: what pushes is in {:.1f} parts, with what it moves in {:.1f}; the largest of "
                  "these holds {:.0f} % of the contacts that push",
                  disks, sum.parts / sum.samples, sum.moved_parts / sum.samples,
                  100 * sum.largest_part / sum.pushing)};
}

}  // namespace

Findings packing_study(const Settings& settings) {
  Findings findings;
  References references(settings.patience());
  Series series{.study = "packing",
                .name = "a hexagonal packing of Hertz disks, struck at a corner",
                .family = "disks on a side",
                .points = {}};
  for (const Index side : {4, 6, 8, 12, 16})
    if (!settings.quick || side <= 6)
      series.points.push_back({static_cast<double>(side), {.side = side, .struck = true}});
  findings.rows = sweep(series, {"auto", "cvode-adams"}, settings, references);
  findings.statements = {comparison(findings.rows, "auto", "cvode-adams")};
  for (const auto& point : series.points) findings.statements.push_back(parts_statement(point.impact_case));
  findings.figures = figures_by_flow(findings.rows, "disks on a side", Figure::Quantity::seconds);
  return findings;
}

}  // namespace mariotte::stiffness_study
