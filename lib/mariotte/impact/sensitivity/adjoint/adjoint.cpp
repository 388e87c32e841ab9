#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/impact/sensitivity/frame_slopes.hpp"
#include "mariotte/impact/sensitivity/resolved.hpp"
#include "mariotte/impact/watch/chain_run.hpp"
#include "mariotte/model/islands/islands.hpp"

namespace mariotte::impact {
namespace {

using model::Chain;
using model::DimensionlessChain;

/// A row as islands follow it, with its motion.
struct RecordedRun {
  DimensionlessChain chain;
  model::ChainLayout layout;
  MotionRecord motion;
  model::Islands::Run run;
};

void follow(const Chain& chain, hybrid::Options options, const SlopeWatch& watch, RecordedRun& recorded) {
  if (!options.flow) options.flow = flow::Kind::taylor;  // closed forms are no series
  auto& scaled = recorded.chain;
  make_dimensionless(chain, options.accuracy, scaled);
  const auto inner = tightened(options, chain.mass.size());
  fade_later(scaled, inner.accuracy);
  make_layout(scaled, recorded.layout);
  std::vector<double> start;
  initial_state(scaled, recorded.layout, start);
  model::Islands islands(scaled, recorded.layout, start, hybrid::scaled(inner, scaled.scale),
                         /*stay=*/std::isfinite(options.max_time), [&] {
                           return std::make_unique<MotionRecorder>(inner.accuracy, watch, recorded.motion);
                         });
  islands.run();
  recorded.run = std::move(islands.result());
}

/// In the units of the chain, per its units. Units of a stiffness depend on the exponent.
void restore_units(const DimensionlessChain& chain, RowSlopes& slopes) {
  const auto& unit = chain.scale;
  const double length = std::log(unit.length);
  for (double& one : slopes.mass) one *= unit.velocity / unit.mass;
  for (double& one : slopes.gap) one *= unit.velocity / unit.length;
  for (std::size_t j = 0; j < slopes.gap.size(); ++j) {
    const auto& law = *power_law(chain.law[j]);
    auto &by_stiffness = slopes.stiffness[j], &by_damping = slopes.damping[j];
    slopes.exponent[j] += length * (by_stiffness * law.stiffness + by_damping * law.damping);
    slopes.exponent[j] *= unit.velocity;
    const double power = std::pow(unit.length, law.exponent);
    by_stiffness *= unit.velocity * power / unit.force();
    by_damping *= unit.velocity * power / (unit.force() * unit.time);
  }
}

/// Series have a clock in which such contacts begin and end smoothly.
bool has_clock(const contact::PowerLaw& law) {
  return law.exponent == 1 || law.exponent == 1.5;
}

/// The slope of the force by the indentation is unbounded where the contact begins.
bool begins_steeply(const contact::PowerLaw& law) {
  return law.damping > 0 && law.exponent > 1 && law.exponent < 2;
}

/// A linear contact that touches at rest: pressed it acts at once, drawn apart not at all.
bool touches_at_rest(const Chain& chain, std::size_t j) {
  return power_law(chain.law[j])->exponent == 1 && chain.gap[j] == 0 &&
         chain.velocity[j] == chain.velocity[j + 1];
}

/// Whether an island has been there before, and has only been cut anew.
bool goes_on(const MotionRecord::Stretch& stretch, const std::vector<Instant>& left) {
  constexpr double same = 1e-9;  // in units of a short contact
  return std::any_of(left.begin() + stretch.first, left.begin() + stretch.last + 1,
                     [&](Instant time) { return stretch.start - time < same; });
}

/// By contact: it was taken into an island that was there, for a wave came to it.
std::vector<char> find_waiting(const MotionRecord& motion, std::size_t balls) {
  std::vector<char> seen(balls - 1, 0), waiting(balls - 1, 0);
  std::vector<Instant> left(balls, {-infinity});
  for (const auto& stretch : motion.stretch) {
    const bool goes = goes_on(stretch, left);
    for (Index j = stretch.first; j < stretch.last; ++j)
      if (!std::exchange(seen[j], 1)) waiting[j] = goes;
    std::fill(left.begin() + stretch.first, left.begin() + stretch.last + 1, stretch.end);
  }
  return waiting;
}

/// Slopes that differ on both sides.
void leave_out_waiting(const Chain& chain, const MotionRecord& motion, RowSlopes& slopes) {
  const auto waiting = find_waiting(motion, chain.mass.size());
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    if (waiting[j] && touches_at_rest(chain, j))
      slopes.gap[j] = slopes.velocity[j] = slopes.velocity[j + 1] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

const char* why_no_adjoint(const Chain& chain) {
  if (!chain.drive.empty()) return "slopes of what is driven are not computed";
  if (chain.gravity != 0) return "slopes of a row under gravity are not computed backwards";
  const auto any = [&](auto is) { return std::any_of(chain.law.begin(), chain.law.end(), is); };
  if (any([](const contact::Law& law) { return !power_law(law); }))
    return "slopes of laws that are no power laws are not computed backwards";
  const bool general = any([](const contact::Law& law) { return !has_clock(*power_law(law)); });
  if (general && any([](const contact::Law& law) { return begins_steeply(*power_law(law)); }))
    return "slopes of damped contacts with other exponents between 1 and 2 than 3/2 are not computed "
           "backwards";
  return nullptr;
}

Adjoint adjoint(const Chain& chain, std::span<const double> weights, const hybrid::Options& asked,
                const SlopeWatch& watch) {
  model::validate(chain);
  hybrid::validate(asked);
  model::expect_end(chain, asked.max_time);
  if (const char* why = why_no_adjoint(chain)) throw InvalidParameter(why);
  if (weights.size() != chain.mass.size()) throw InvalidParameter("there must be one weight per ball");
  RecordedRun recorded;
  const auto frame = moving_frame(chain);
  follow(within(frame, chain), for_slopes(asked), watch, recorded);
  const auto& [scaled, layout, motion, run] = recorded;
  Adjoint result{.ending = run.ending,
                 .message = run.message,
                 .slopes = {},
                 .pieces = std::ssize(motion.piece),
                 .bytes = motion.bytes()};
  for (std::size_t i = 0; i < weights.size(); ++i)
    result.value +=
        weights[i] * (run.state[layout.velocity[i]] * scaled.scale.velocity + (frame ? frame.at(i) : 0));
  result.slopes = sweep_back(scaled, motion, {run.time}, weights);
  restore_units(scaled, result.slopes);
  leave_out_waiting(chain, motion, result.slopes);
  return result;
}

}  // namespace mariotte::impact
