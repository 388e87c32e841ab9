#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/impact/sensitivity/late_damping.hpp"
#include "mariotte/model/chain/chain_system.hpp"

namespace mariotte::impact {
namespace {

/// Impulses from momentum, which masses and gravity change.
class ChainImpulses {
 public:
  ChainImpulses(const model::DimensionlessChain& chain, const model::ChainLayout& layout, Index columns)
      : layout_(layout),
        chain_(chain),
        heaviest_(heaviest_ball(chain)),
        mass_(layout.velocities(), columns),
        gravity_(layout.velocities(), columns) {}

  void add(const ShiftedModel<model::DimensionlessChain>& shifted) {
    if (shifted.is_first()) step_.push_back(shifted.step);
    for (Index i = 0; i < mass_.rows; ++i) {
      if (chain_.inverse_mass[i] == 0) continue;
      mass_(i, shifted.column) += shifted.share() * (shifted.model.mass[i] - chain_.mass[i]);
      gravity_(i, shifted.column) += shifted.share() * (shifted.model.gravity[i] - chain_.gravity[i]);
    }
  }
  void at(const Interval& interval, std::vector<double>& p) const {
    impulses(chain_, layout_, interval, heaviest_, p);
  }
  /// They are linear in masses, and in gravity: a central difference is exact.
  void add_slopes(Index c, const Interval& interval, std::vector<double>& p) const {
    const auto is_zero = [](double slope) { return slope == 0; };
    const auto mass = mass_.column(c), gravity = gravity_.column(c);
    if (std::all_of(mass.begin(), mass.end(), is_zero) &&
        std::all_of(gravity.begin(), gravity.end(), is_zero))
      return;
    auto moved = chain_;
    std::vector<double> part;
    for (const double by : {step_[c], -step_[c]}) {
      for (Index i = 0; i < mass_.rows; ++i) {
        moved.mass[i] = chain_.mass[i] + by * mass[i];
        moved.gravity[i] = chain_.gravity[i] + by * gravity[i];
      }
      impulses(moved, layout_, interval, heaviest_, part);
      for (std::size_t j = 0; j < p.size(); ++j) p[j] += part[j] / (2 * by);
    }
  }

 private:
  const model::ChainLayout& layout_;
  const model::DimensionlessChain& chain_;
  Index heaviest_;  ///< of the chain that is not moved
  SlopeMatrix mass_, gravity_;
  std::vector<double> step_;  ///< by parameter
};

}  // namespace

Sensitivity sensitivity(const model::Chain& chain, const std::vector<Parameter<model::Chain>>& by,
                        const hybrid::Options& asked, const SlopeWatch& watch) {
  model::validate(chain);
  expect_no_drive(chain.drive);
  hybrid::validate(asked);
  model::expect_end(chain, asked.max_time);
  const auto frame = moving_frame(chain);
  const auto moving = within(frame, chain);
  model::ChainSystem system;
  using Run = ContactSensitivity<model::ChainSystem, model::ChainTopology, ChainImpulses>;
  auto found = resolved_contacts(asked, [&](const hybrid::Options& options) {
    system.reset(moving, options.accuracy, std::isfinite(options.max_time));
    return Run(system, system.chain(), frame, by, options, watch);
  });
  note_late_damping(moving.law, asked.accuracy, found);
  leave(frame, found);
  return found;
}

}  // namespace mariotte::impact
