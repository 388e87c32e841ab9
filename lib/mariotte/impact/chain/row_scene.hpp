// Short rows of balls, of which many are followed side by side.
#pragma once
#include <optional>

#include "mariotte/core/natural_root.hpp"
#include "mariotte/flow/short_row/short_row.hpp"
#include "mariotte/flow/triplet/triplet.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// The numbers of a chain with `most` balls, or fewer but at least three, undamped Hertz contacts and no
/// wall, on which nothing else acts.
template <int most>
struct RowScene {
  int count;  ///< of balls; see `balls`
  double mass[most], velocity[most], stiffness[most - 1], gap[most - 1];
  double speed;           ///< reference speed
  double unit_stiffness;  ///< that is 1 in the units of `scale`
  Scale scale;

  /// A triplet has three, which the compiler then knows.
  int balls() const { return most == 3 ? 3 : count; }
  int contacts() const { return balls() - 1; }
};
using TripletScene = RowScene<3>;
using ShortRowScene = RowScene<flow::ShortRow::most + 1>;

/// Those of a validated chain; empty unless it is such a one, numbers are of moderate size, and nothing is
/// asked for but an accuracy.
template <int most>
std::optional<RowScene<most>> row_scene(const model::Chain& chain, const hybrid::Options& options,
                                        NaturalRoot& natural_root);

/// The numbers of a scene, put back.
template <int most>
void restore(const RowScene<most>& scene, model::Chain& chain);

/// The row at its start, dimensionless.
flow::Triplet dimensionless(const TripletScene& scene, double accuracy);
flow::ShortRow dimensionless(const ShortRowScene& scene, double accuracy);

/// What came out of a row that is over, in units. False if it is not, or a balance does not close.
bool describe(const TripletScene& scene, const flow::Triplet& row, double accuracy, BriefImpact& impact);
bool describe(const ShortRowScene& scene, const flow::ShortRow& row, double accuracy, BriefImpact& impact);

}  // namespace mariotte::impact
