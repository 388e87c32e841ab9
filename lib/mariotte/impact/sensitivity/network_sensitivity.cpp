#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/model/network/network_system.hpp"

namespace mariotte::impact {
namespace {

/// A network integrates its impulses.
void integrated_impulses(const model::DimensionlessNetwork&, const model::ContactLayout& layout,
                         const Interval& interval, std::vector<double>& p) {
  p.clear();
  for (const Index place : layout.impulse) p.push_back(interval.after[place] - interval.before[place]);
}

}  // namespace

Sensitivity sensitivity(const model::Network& network, const std::vector<Parameter<model::Network>>& by,
                        const hybrid::Options& asked, const SlopeWatch& watch) {
  model::validate(network);
  expect_no_drive(network.drive);
  hybrid::validate(asked);
  const auto options = for_slopes(asked);
  model::NetworkSystem system(network, options.accuracy, std::isfinite(options.max_time));
  ContactSensitivity<model::NetworkSystem, model::NetworkTopology, decltype(&integrated_impulses)> run(
      system, system.network(), by, options, watch, &integrated_impulses);
  return run.take();
}

}  // namespace mariotte::impact
