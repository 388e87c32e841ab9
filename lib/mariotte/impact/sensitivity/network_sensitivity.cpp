#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/model/network/network_system.hpp"

namespace mariotte::impact {
namespace {

/// A network integrates its impulses.
class NetworkImpulses {
 public:
  NetworkImpulses(const model::DimensionlessNetwork&, const model::ContactLayout& layout, Index)
      : layout_(layout) {}

  void add(const ShiftedModel<model::DimensionlessNetwork>&) {}
  void at(const Interval& interval, std::vector<double>& p) const {
    p.clear();
    for (const Index place : layout_.impulse) p.push_back(interval.after[place] - interval.before[place]);
  }
  void add_slopes(Index, const Interval&, std::vector<double>&) const {}

 private:
  const model::ContactLayout& layout_;
};

}  // namespace

Sensitivity sensitivity(const model::Network& network, const std::vector<Parameter<model::Network>>& by,
                        const hybrid::Options& asked, const SlopeWatch& watch) {
  model::validate(network);
  expect_no_drive(network.drive);
  hybrid::validate(asked);
  const auto options = for_slopes(asked);
  model::NetworkSystem system(network, options.accuracy, std::isfinite(options.max_time));
  ContactSensitivity<model::NetworkSystem, model::NetworkTopology, NetworkImpulses> run(
      system, system.network(), by, options, watch);
  return run.take();
}

}  // namespace mariotte::impact
