#include <optional>

#include "mariotte/impact/network/network_frame.hpp"
#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/impact/sensitivity/late_damping.hpp"
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
  const auto frame = moving_frame(network);
  const auto moving = within(frame, network);
  using Run = ContactSensitivity<model::NetworkSystem, model::NetworkTopology, NetworkImpulses>;
  std::optional<model::NetworkSystem> system;
  auto found = resolved_contacts(asked, [&](const hybrid::Options& options) {
    system.emplace(moving, options.accuracy, std::isfinite(options.max_time));
    return Run(*system, system->network(), frame, by, options, watch);
  });
  note_late_damping(moving.law, asked.accuracy, found);
  leave(frame, found);
  return found;
}

}  // namespace mariotte::impact
