#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_frame.hpp"
#include "mariotte/impact/sensitivity/adjoint/checkpoints.hpp"
#include "mariotte/impact/sensitivity/adjoint/motion_recorder.hpp"
#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/impact/sensitivity/frame_slopes.hpp"
#include "mariotte/impact/sensitivity/resolved.hpp"
#include "mariotte/impact/watch/chain_run.hpp"

namespace mariotte::impact {
namespace {

using model::Chain;
using model::DimensionlessChain;

/// A row as islands follow it, as often as its motion is asked for.
class RecordedRow {
 public:
  RecordedRow(const Chain& chain, hybrid::Options options, const SlopeWatch& watch) : watch_(watch) {
    if (!options.flow) options.flow = flow::Kind::taylor;  // closed forms are no series
    make_dimensionless(chain, options.accuracy, chain_);
    options_ = tightened(options, chain.mass.size());
    fade_later(chain_, options_.accuracy);
    make_layout(chain_, layout_);
    initial_state(chain_, layout_, start_);
  }

  const DimensionlessChain& chain() const { return chain_; }
  const model::ChainLayout& layout() const { return layout_; }
  /// From the start, or from a state on the way.
  model::Islands::Run follow(MotionMemory& memory, Checkpoints& checkpoints,
                             const MotionCheckpoint* from = nullptr) const {
    const auto options = hybrid::scaled(options_, chain_.scale);
    const bool stay = std::isfinite(options_.max_time);
    const auto record = [&] { return std::make_unique<MotionRecorder>(options_.accuracy, watch_, memory); };
    auto islands = from ? model::Islands(chain_, layout_, from->state, options, stay, record)
                        : model::Islands(chain_, layout_, start_, options, stay, record);
    CheckpointObserver observer(islands, memory, checkpoints);
    islands.run(&observer);
    return std::move(islands.result());
  }

 private:
  const SlopeWatch& watch_;
  hybrid::Options options_;
  DimensionlessChain chain_;
  model::ChainLayout layout_;
  std::vector<double> start_;
};

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

/// Also marks the neighbours of what is marked that touch at rest, on one side.
std::vector<char> with_neighbours(std::vector<char> marked, const std::vector<char>& touches, bool before) {
  constexpr int felt = 12;  // from further away only rounding arrives before the wave
  int left = 0;
  for (std::size_t k = 0; k < marked.size(); ++k) {
    const auto j = before ? marked.size() - 1 - k : k;
    left = marked[j] ? felt : touches[j] ? left - 1 : 0;
    if (left > 0) marked[j] = 1;
  }
  return marked;
}

/// Slopes that differ on both sides: by contacts that wait for the wave. So are those by their neighbours,
/// which would pass on at once what is put into them, to contacts that are not followed yet.
void leave_out_waiting(const Chain& chain, const std::vector<char>& waiting, RowSlopes& slopes) {
  std::vector<char> touches, waits;
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    touches.push_back(touches_at_rest(chain, j));
    waits.push_back(waiting[j] && touches[j]);
  }
  const auto before = with_neighbours(waits, touches, true), after = with_neighbours(waits, touches, false);
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    if (before[j] || after[j])
      slopes.gap[j] = slopes.velocity[j] = slopes.velocity[j + 1] = std::numeric_limits<double>::quiet_NaN();
}

/// What the memory has, and by more runs what had no room there.
void pass_all(const RecordedRow& row, MotionMemory& memory, Checkpoints& checkpoints, BackSweep& sweep,
              Adjoint& result) {
  for (;;) {
    sweep.pass(memory.motion());
    ++result.runs;
    result.pieces += std::ssize(memory.motion().piece);
    result.bytes = std::max(result.bytes, memory.motion().bytes() + checkpoints.bytes());
    const auto edge = memory.edge();
    if (!edge) return;
    const auto* from = checkpoints.last_before(edge->number);
    memory = MotionMemory(row.chain().contacts(), memory.most_bytes(), *edge,
                          from ? from->before : MotionMemory::Progress{});
    row.follow(memory, checkpoints, from);
  }
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
                const SlopeWatch& watch, std::size_t most_bytes) {
  model::validate(chain);
  hybrid::validate(asked);
  model::expect_end(chain, asked.max_time);
  if (const char* why = why_no_adjoint(chain)) throw InvalidParameter(why);
  if (weights.size() != chain.mass.size()) throw InvalidParameter("there must be one weight per ball");
  const auto frame = moving_frame(chain);
  const RecordedRow row(within(frame, chain), for_slopes(asked), watch);
  const auto& scaled = row.chain();
  Checkpoints checkpoints(most_bytes / 4);
  MotionMemory memory(scaled.contacts(), most_bytes - most_bytes / 4);
  const auto run = row.follow(memory, checkpoints);
  Adjoint result{.ending = run.ending, .message = run.message, .slopes = {}};
  for (std::size_t i = 0; i < weights.size(); ++i)
    result.value += weights[i] *
                    (run.state[row.layout().velocity[i]] * scaled.scale.velocity + (frame ? frame.at(i) : 0));
  BackSweep sweep(scaled, {run.time}, weights);
  const auto waiting = memory.waiting();
  pass_all(row, memory, checkpoints, sweep, result);
  result.slopes = sweep.take();
  restore_units(scaled, result.slopes);
  leave_out_waiting(chain, waiting, result.slopes);
  return result;
}

}  // namespace mariotte::impact
