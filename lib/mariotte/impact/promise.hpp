// The promise of an accuracy: how far errors grow on the way to the end depends on the scene, and where
// contacts close again and again, or push for long, it can be far. Such a scene is run again, tighter, until
// two runs agree.
//
//   a ← the accuracy asked for; run
//   unless contacts have closed again and again, or pushed for long, or together
//   after a long flight, or adhesion has let go slowly: done                  a single wave pays nothing
//   repeat
//     a ← tighter, as the last difference says, or flight and adhesion; run again
//     difference of the velocities ≤ a quarter of what was asked?  → the tighter run, the difference is the
//                                                                     estimate
//     a cannot get tighter?                                        → the same
//   they did not agree, or a tighter one came to no end, or what they did may hide rounding?
//     near the last accuracy, run with masses and gaps that are moved by rounding errors: the largest
//     difference is the estimate, or as many times more as CVODE errs by more than rounding
//   there were too many periods to run again, or none of these runs came to an end: nothing bounds the error,
//   the estimate is infinite
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "mariotte/core/types.hpp"
#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/passage.hpp"
#include "mariotte/impact/shaken.hpp"
#include "mariotte/impact/slow_start.hpp"
#include "mariotte/model/drives/drive.hpp"

namespace mariotte::impact {

/// Accuracy of the next run after one at `now`, which may be off by `difference`; empty if double precision
/// has no more to give than what is `attainable`.
inline std::optional<double> next_accuracy(double wanted, double now, double difference, double attainable) {
  constexpr double share = 1.0 / 32;
  const double excess = std::clamp(wanted / difference, 1e-6, 1.0);
  const double next = std::max(attainable, share * excess * now);
  return next <= 0.5 * now ? std::optional(next) : std::nullopt;
}

/// Largest difference of velocities, relative to `speed` unless that is 0; infinite if one is not a number.
/// Those that `drives` prescribe do not count: where one jumps as the run ends, rounding says which it has.
inline double difference(std::span<const double> a, std::span<const double> b, double speed,
                         const std::vector<model::Drive>& drives = {}) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (prescribes(drives, static_cast<Index>(i))) continue;
    const double apart = std::abs(a[i] - b[i]);
    most = apart <= most ? most : apart;
    if (std::isnan(most)) return infinity;
  }
  return speed > 0 ? most / speed : most;
}

/// A tighter run takes the place of a looser one unless it failed, was given up, has run into a limit of
/// events that the other has not, or balances worse.
inline bool may_replace(hybrid::Ending looser, hybrid::Ending tighter) {
  using hybrid::Ending;
  if (tighter == Ending::failed || tighter == Ending::interrupted) return false;
  return tighter == looser || (tighter != Ending::event_limit && tighter != Ending::unsure);
}

/// Two runs end alike; at the edge of capture an error decides whether a body is held or hardly comes off.
inline bool end_alike(hybrid::Ending a, hybrid::Ending b) {
  const auto held = [](hybrid::Ending one) {
    return one == hybrid::Ending::captured || one == hybrid::Ending::bound;
  };
  const auto comes_off = [&](hybrid::Ending one) { return one == hybrid::Ending::separated || held(one); };
  return a == b || (comes_off(a) && comes_off(b));
}

/// Rounding of all steps in the energy of what adhesion hardly lets go, as large as shaking takes it: three
/// runs may be lucky. What comes off faster shows it when it is shaken.
inline double slowed_rounding(const Passage& gone) {
  constexpr double hardly = 8 * much_slower;
  return gone.slowing >= hardly ? 4 * epsilon * static_cast<double>(gone.steps) * gone.slowing : 0;
}

/// The numbers of a run that ended so are no result, and have no error to estimate.
inline bool is_no_result(hybrid::Ending ending) {
  return ending == hybrid::Ending::failed || ending == hybrid::Ending::unsure;
}

/// Share of the accuracy within which two runs have to agree. Where a ball rattles, runs that are both wrong
/// by far more than the accuracy may differ by less: a tighter one shows it.
inline constexpr double agreement = 0.25;

/// Run tighter until two runs agree within a share of the accuracy that is `asked` for: `run(options)` runs
/// and returns by how much its velocities differ from those of the run before, or nothing if it may not
/// replace it. Where that is no measure of the last run, `shake(options)` runs near its accuracy, with inputs
/// moved by rounding errors, and says what that makes of the velocities. Returns the estimate of the error.
template <class Run, class Shake>
double keep_promise(const hybrid::Options& asked, const Passage& gone, Run&& run, Shake&& shake) {
  if (gone.periods > most_periods_run_again) return infinity;
  const double summed_rounding = epsilon * static_cast<double>(gone.steps);
  const double feared = asked.accuracy * growth(gone);
  std::optional<double> last;
  auto now = asked;
  double looser = asked.accuracy;
  while (!last || *last > agreement * asked.accuracy) {
    const auto accuracy = next_accuracy(asked.accuracy, now.accuracy, last.value_or(feared), gone.attainable);
    if (!accuracy) break;
    looser = std::exchange(now.accuracy, *accuracy);
    const std::optional<double> apart = run(now);
    if (!apart) {
      now.accuracy = looser;
      break;
    }
    if (*apart == 0) break;  // the same to the last bit: the flow has no more to give
    last = *apart + summed_rounding;
  }
  const bool agreed = last && *last <= asked.accuracy;
  if (agreed && !hides_rounding(gone, looser)) return *last;
  now.accuracy *= 4;  // so that what the accuracy cuts off shows as well
  const std::optional<double> shaken = shake(now);
  if (!shaken) return last.value_or(infinity);
  const double grown = *shaken > asked.accuracy ? grown_error_of_cvode(gone, *shaken) : 0;
  return std::max({*shaken, grown, agreed ? *last : 0, slowed_rounding(gone)});
}

/// Unless the run that stays is no result.
template <class Impact>
void set_estimate(double estimate, Impact& impact) {
  impact.estimated_accuracy.reset();
  if (!is_no_result(impact.ending)) impact.estimated_accuracy = estimate;
}

/// Steps of CVODE add up errors in which two runs may agree: the estimate is no less where they are more than
/// was asked for.
template <class Impact>
void add_floor(const Passage& gone, double asked, Impact& impact) {
  if (gone.floor > asked)
    impact.estimated_accuracy = std::max(gone.floor, impact.estimated_accuracy.value_or(0));
}

/// Something moves at the start, or is driven.
template <class Model>
bool moves(const Model& model) {
  return !model.drive.empty() ||
         std::any_of(model.velocity.begin(), model.velocity.end(), [](double v) { return v != 0; });
}

/// A vibration that is slow beside what indentations hold back has rounding of that: the estimate says so
/// where it is more than was asked for.
template <class Model>
void add_rounding(const Passage& gone, const Model& model, double asked, std::optional<double>& estimate) {
  if (!model.precompressed || !moves(model)) return;
  const auto [largest, reference] = speeds(model);
  const double lost = rounding_of_steps(gone) * largest / reference;
  if (reference < largest && lost > asked) estimate = std::max(lost, estimate.value_or(0));
}

/// Upper bound on the error of a result that is `apart` from a run which is tighter by far, but has an error
/// of its own: a tenth at most, or what it says itself.
inline double error_bound(double apart, std::optional<double> of_tighter) {
  return 1.1 * apart + of_tighter.value_or(0);
}

/// Four times the largest difference that shaking makes among runs that end alike, since a few of them tell
/// how wide errors scatter, not how far one may lie out; empty if none ends alike.
template <class After>
std::optional<double> most_shaken(After&& after) {
  std::optional<double> most;
  for (const unsigned shake : shakes)
    if (const auto apart = after(shake)) most = std::max(most.value_or(0), 4 * *apart);
  return most;
}

/// Where errors may have grown on the way of a result: `again(model, options)` makes a tighter one, which
/// takes the place of `impact` if it may, until two agree; `apart(a, b)` is by how much two differ.
template <class Model, class Impact, class Again, class Apart>
void keep_promise(const Model& model, const hybrid::Options& asked, Passage gone, Impact& impact,
                  Again&& again, Apart&& apart) {
  impact.estimated_accuracy.reset();
  gone.starts_slowly = starts_slowly(model, asked.accuracy);
  if (!may_have_erred(gone) || impact.ending == hybrid::Ending::interrupted)
    return add_floor(gone, asked.accuracy, impact);
  const auto run = [&](const hybrid::Options& options) -> std::optional<double> {
    auto tighter = again(model, options);
    if (!may_replace(impact.ending, tighter.ending)) return std::nullopt;
    const double difference = apart(impact, tighter);
    impact = std::move(tighter);
    return difference;
  };
  const auto shake = [&](const hybrid::Options& options) -> std::optional<double> {
    if (is_no_result(impact.ending)) return std::nullopt;
    return most_shaken([&](unsigned which) -> std::optional<double> {
      const auto other = again(shaken(model, which), options);
      return end_alike(other.ending, impact.ending) ? std::optional(apart(impact, other)) : std::nullopt;
    });
  };
  set_estimate(keep_promise(asked, gone, run, shake), impact);
  add_floor(gone, asked.accuracy, impact);
}

/// The same for brief results: `solve(model, options)` fills in `impact`; `looser` is memory. What has `gone`
/// on is copied, since a solver counts anew in every run.
template <class Model, class Brief, class Solve, class Apart>
void keep_promise(const Model& model, const hybrid::Options& asked, Passage gone, Brief& impact,
                  Brief& looser, Solve&& solve, Apart&& apart) {
  impact.estimated_accuracy.reset();
  gone.starts_slowly = starts_slowly(model, asked.accuracy);
  if (!may_have_erred(gone)) return add_floor(gone, asked.accuracy, impact);
  const auto run = [&](const hybrid::Options& options) -> std::optional<double> {
    looser = impact;
    solve(model, options);
    if (may_replace(looser.ending, impact.ending)) return apart(impact, looser);
    std::swap(impact, looser);
    return std::nullopt;
  };
  const auto shake = [&](const hybrid::Options& options) -> std::optional<double> {
    if (is_no_result(impact.ending)) return std::nullopt;
    return most_shaken([&](unsigned which) -> std::optional<double> {
      looser = impact;
      solve(shaken(model, which), options);
      std::swap(impact, looser);
      return end_alike(looser.ending, impact.ending) ? std::optional(apart(impact, looser)) : std::nullopt;
    });
  };
  set_estimate(keep_promise(asked, gone, run, shake), impact);
  add_floor(gone, asked.accuracy, impact);
}

}  // namespace mariotte::impact
