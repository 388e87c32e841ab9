// The promise of an accuracy: how far errors grow on the way to the end depends on the scene, and where
// contacts close again and again, or push for long, it can be far. Such a scene is run again, tighter, until
// two runs agree.
//
//   a ← the accuracy asked for; run
//   unless contacts have closed again and again, or pushed for long: done     a single wave pays nothing
//   repeat
//     a ← tighter, as the last difference says; run again
//     difference of the velocities ≤ accuracy asked for?  → the tighter run, with the difference as estimate
//     a cannot get tighter?                               → the same, and the estimate says so
//   a tighter run cannot be had, or is the same to the last bit?
//     run with masses that are moved by rounding errors; the largest difference is the estimate
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "mariotte/core/types.hpp"
#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/flow_use.hpp"
#include "mariotte/impact/shaken.hpp"

namespace mariotte::impact {

/// What a run has gone through.
struct Passage {
  Index contacts = 0;
  Index harmless = 0;  ///< periods up to which none magnifies the errors of another
  Index periods = 0;   ///< of contact, of all contacts together
  Index steps = 0;     ///< of series and closed forms; CVODE's are shorter and count a thirtieth
  double attainable = 16 * epsilon;  ///< accuracy beyond which rounding leaves no run
};

/// Adds the steps of a flow.
inline void count_steps(Passage& passage, bool by_cvode, Index steps) {
  passage.steps += by_cvode ? steps / 30 : steps;
}

/// Adds the steps of all flows of a whole result.
inline void count_steps(Passage& passage, const std::vector<FlowUse>& flows) {
  for (const auto& flow : flows) count_steps(passage, flow.name.starts_with("cvode"), flow.steps);
}

/// Periods of a single wave through so many contacts, there and back. Of a body only the first impact is
/// harmless: the next one depends on how far it has turned since.
inline Index single_wave(Index contacts) {
  return 2 * contacts;
}
inline constexpr Index first_impact = 1;

/// True if errors may have grown: contacts have closed so often that what one does wrong is magnified by the
/// next, or the errors of many steps have added up. After very many periods
/// rounding alone decides the end, and each run takes minutes.
inline bool may_have_erred(const Passage& passage) {
  constexpr Index most = 100'000;
  return (passage.periods > passage.harmless || passage.steps > 60 + 10 * passage.contacts) &&
         passage.periods <= most;
}

/// Accuracy of the next run after one at `now`, which differs from the one before by `difference`; empty if
/// double precision has no more to give than what is `attainable`.
inline std::optional<double> next_accuracy(double wanted, double now, std::optional<double> difference,
                                           double attainable) {
  constexpr double share = 1.0 / 32;
  const double excess = difference ? std::clamp(wanted / *difference, 1e-6, 1.0) : 1;
  const double next = std::max(attainable, share * excess * now);
  return next <= 0.5 * now ? std::optional(next) : std::nullopt;
}

/// Largest difference of velocities, relative to `speed` unless that is 0; infinite if one is not a number.
inline double difference(std::span<const double> a, std::span<const double> b, double speed) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
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

/// Run tighter until two runs agree within the accuracy that is `asked` for: `run(options)` runs and returns
/// by how much its velocities differ from those of the run before, or nothing if it may not replace it.
/// Where no tighter run tells anything new, `shake()` says what rounding makes of the velocities, which no
/// accuracy mends. Returns the last difference; empty if the first tighter run has failed.
template <class Run, class Shake>
std::optional<double> keep_promise(const hybrid::Options& asked, double attainable, Run&& run,
                                   Shake&& shake) {
  std::optional<double> last;
  auto tighter = asked;
  auto accuracy = next_accuracy(asked.accuracy, asked.accuracy, last, attainable);
  while (accuracy) {
    tighter.accuracy = *accuracy;
    const std::optional<double> apart = run(tighter);
    if (!apart) return last;
    if (*apart == 0) break;  // the same to the last bit: the flow has no more to give
    last = apart;
    if (*last <= asked.accuracy) break;
    accuracy = next_accuracy(asked.accuracy, *accuracy, last, attainable);
  }
  return last ? last : shake();
}

/// What a whole result of a chain or network has gone through.
template <class Impact>
Passage passage(const Impact& impact) {
  const Index contacts = std::ssize(impact.contacts);
  Passage gone{.contacts = contacts, .harmless = single_wave(contacts)};
  for (const auto& contact : impact.contacts) gone.periods += std::ssize(contact.periods);
  count_steps(gone, impact.flows);
  return gone;
}

/// The largest difference that shaking makes among runs that end alike; empty if none does.
template <class After>
std::optional<double> most_shaken(After&& after) {
  std::optional<double> most;
  for (const unsigned shake : shakes)
    if (const auto apart = after(shake)) most = std::max(most.value_or(0), *apart);
  return most;
}

/// Where errors may have grown on the way of a result: `again(model, options)` makes a tighter one, which
/// takes the place of `impact` if it may, until two agree; `apart(a, b)` is by how much two differ.
template <class Model, class Impact, class Again, class Apart>
void keep_promise(const Model& model, const hybrid::Options& asked, const Passage& gone, Impact& impact,
                  Again&& again, Apart&& apart) {
  impact.estimated_accuracy.reset();
  if (!may_have_erred(gone) || impact.ending == hybrid::Ending::interrupted) return;
  const auto run = [&](const hybrid::Options& options) -> std::optional<double> {
    auto tighter = again(model, options);
    if (!may_replace(impact.ending, tighter.ending)) return std::nullopt;
    const double difference = apart(impact, tighter);
    impact = std::move(tighter);
    return difference;
  };
  const auto after = [&](unsigned shake) -> std::optional<double> {
    const auto other = again(shaken(model, shake), asked);
    return other.ending == impact.ending ? std::optional(apart(impact, other)) : std::nullopt;
  };
  impact.estimated_accuracy = keep_promise(asked, gone.attainable, run, [&] { return most_shaken(after); });
}

/// The same for brief results: `solve(model, options)` fills in `impact`; `looser` is memory.
template <class Model, class Brief, class Solve, class Apart>
void keep_promise(const Model& model, const hybrid::Options& asked, const Passage& gone, Brief& impact,
                  Brief& looser, Solve&& solve, Apart&& apart) {
  impact.estimated_accuracy.reset();
  if (!may_have_erred(gone)) return;
  const auto run = [&](const hybrid::Options& options) -> std::optional<double> {
    looser = impact;
    solve(model, options);
    if (may_replace(looser.ending, impact.ending)) return apart(impact, looser);
    std::swap(impact, looser);
    return std::nullopt;
  };
  const auto after = [&](unsigned shake) -> std::optional<double> {
    looser = impact;
    solve(shaken(model, shake), asked);
    std::swap(impact, looser);
    return looser.ending == impact.ending ? std::optional(apart(impact, looser)) : std::nullopt;
  };
  const auto estimate = keep_promise(asked, gone.attainable, run, [&] { return most_shaken(after); });
  impact.estimated_accuracy = estimate;
}

}  // namespace mariotte::impact
