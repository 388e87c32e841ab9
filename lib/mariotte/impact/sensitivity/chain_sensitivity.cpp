#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/impact/sensitivity/late_damping.hpp"
#include "mariotte/model/chain/chain_system.hpp"

namespace mariotte::impact {
namespace {

/// Impulses from momentum, which moves with masses and gravity.
class ChainImpulses {
 public:
  ChainImpulses(const model::DimensionlessChain& chain, const model::ChainLayout& layout, Index columns)
      : layout_(layout),
        chain_(chain),
        heaviest_(model::heaviest_ball(chain)),
        mass_(layout.velocities(), columns),
        gravity_(layout.velocities(), columns) {}

  void add(const ShiftedModel<model::DimensionlessChain>& shifted) {
    for (Index i = 0; i < mass_.rows; ++i) {
      if (chain_.inverse_mass[i] == 0) continue;
      mass_(i, shifted.column) += shifted.share() * (shifted.model.mass[i] - chain_.mass[i]);
      gravity_(i, shifted.column) += shifted.share() * (shifted.model.gravity[i] - chain_.gravity[i]);
    }
  }
  void at(const Interval& interval, std::vector<double>& p) const {
    impulses(chain_, layout_, interval, heaviest_, p);
  }
  /// p_j at fixed states is a sum of momenta from a free end of the chain on.
  void add_slopes(Index c, const Interval& interval, std::vector<double>& p) const {
    const auto lost = [&](Index i) {
      const Index v = layout_.velocity[i];
      const double change = interval.before[v] - interval.after[v] - chain_.gravity[i] * interval.time;
      return mass_(i, c) * change - chain_.mass[i] * gravity_(i, c) * interval.time;
    };
    double sum = 0;
    for (Index i = mass_.rows - 1; i > heaviest_; --i)
      p[i - 1] += sum = chain_.is_faint[i - 1] ? 0 : sum - lost(i);
    sum = 0;
    for (Index i = 0; i < heaviest_; ++i) p[i] += sum = chain_.is_faint[i] ? 0 : sum + lost(i);
  }

 private:
  const model::ChainLayout& layout_;
  const model::DimensionlessChain& chain_;
  Index heaviest_;  ///< of the chain that is not moved
  SlopeMatrix mass_, gravity_;
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
