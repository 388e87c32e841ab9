#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/model/chain/chain_system.hpp"

namespace mariotte::impact {

Sensitivity sensitivity(const model::Chain& chain, const std::vector<Parameter<model::Chain>>& by,
                        const hybrid::Options& asked, const SlopeWatch& watch) {
  model::validate(chain);
  expect_no_drive(chain.drive);
  hybrid::validate(asked);
  model::expect_end(chain, asked.max_time);
  const auto options = for_slopes(asked);
  model::ChainSystem system;
  system.reset(chain, options.accuracy, std::isfinite(options.max_time));
  ContactSensitivity<model::ChainSystem, model::ChainTopology, decltype(&impulses)> run(
      system, system.chain(), by, options, watch, &impulses);
  return run.take();
}

}  // namespace mariotte::impact
