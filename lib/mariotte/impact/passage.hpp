// What a run has gone through, which tells how far its errors may have grown.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/kind.hpp"
#include "mariotte/impact/flow_use.hpp"
#include "mariotte/impact/longest_flight.hpp"

namespace mariotte::impact {

/// What a run has gone through.
struct Passage {
  Index contacts = 0;
  Index harmless = 0;        ///< periods up to which none magnifies the errors of another
  Index periods = 0;         ///< of contact, of all contacts together
  Index most = 0;            ///< of the contact that has closed most often, where that tells
  Index steps = 0;           ///< of series and closed forms; CVODE's are shorter and count a thirtieth
  Index adams = 0, bdf = 0;  ///< steps of CVODE
  Index cvode = 0;           ///< its phases
  Index exact = 0;           ///< phases of contact in closed form, which err by rounding alone
  Index cut = 0;             ///< others, whose errors the accuracy sets
  double flight = 0;  ///< the longest one before contacts that push together, over how long they do [Flights]
  bool starts_slowly = false;  ///< some come together very slowly at the start [slow_start.hpp]
  double slowing = 1;          ///< how many times slower than it met a contact that adheres let go, at most
  double floor = 0;            ///< error that CVODE leaves at its tightest tolerance, where that is known
  double attainable = 16 * epsilon;  ///< accuracy beyond which rounding leaves no run
};

/// Error that steps of CVODE leave and no tighter tolerance takes away, relative to the speed, where it adds
/// up; measured against extended precision.
inline double error_of_cvode(const Passage& passage) {
  constexpr double adams = 120 * epsilon, bdf = 600 * epsilon;
  return adams * static_cast<double>(passage.adams) + bdf * static_cast<double>(passage.bdf);
}
/// What of it a single wave has.
inline double of_single_wave(double error_of_cvode) {
  return std::min(0.25 * error_of_cvode, 5e-11);
}

/// That of a whole run: some 10⁻¹¹ of a single wave, and more of rows that ring for long, where it adds up.
/// What friction holds back forgets it.
inline double floor_of_cvode(const Passage& passage) {
  if (passage.cvode == 0) return 0;
  const double all = error_of_cvode(passage);
  const auto beyond = std::max<Index>(passage.cvode - passage.harmless, 0);
  const double ringing = static_cast<double>(beyond) / static_cast<double>(passage.cvode);
  return std::max(ringing * all, of_single_wave(all));
}

/// What the rest of the run makes of the error of one phase of CVODE, where it makes `shaken` of rounding.
inline double grown_error_of_cvode(const Passage& passage, double shaken) {
  constexpr double unmagnified = 64 * epsilon;
  if (passage.cvode == 0) return 0;
  return of_single_wave(error_of_cvode(passage) / static_cast<double>(passage.cvode)) * shaken / unmagnified;
}

/// Rounding of indentations that are large beside what moves, relative to the largest speed: at least what
/// the accuracy of a flow ends at, and what steps add, of CVODE as many roundings as its weights allow.
/// Measured on pressed rows that ring for 1 to 700 steps of series, and to 40 000 of CVODE.
inline double rounding_of_steps(const Passage& passage) {
  constexpr double least = 64, of_series = 4, of_adams = 6, of_bdf = 40;
  const double series = std::max(least, of_series * std::sqrt(static_cast<double>(passage.steps)));
  return epsilon *
         (series + of_adams * static_cast<double>(passage.adams) + of_bdf * static_cast<double>(passage.bdf));
}

/// Adds the work of a flow.
inline void count_flow(Passage& passage, flow::Kind kind, Index phases, Index steps) {
  passage.steps += is_cvode(kind) ? steps / 30 : steps;
  if (is_cvode(kind)) {
    passage.cvode += phases;
    (kind == flow::Kind::cvode_adams ? passage.adams : passage.bdf) += steps;
  }
  if (kind == flow::Kind::ballistic) return;
  (kind < flow::Kind::taylor ? passage.exact : passage.cut) += phases;
}

/// Adds the work of all flows of a whole result.
inline void count_flows(Passage& passage, const std::vector<FlowUse>& flows) {
  for (const auto& use : flows)
    for (const auto kind : flow::kinds)
      if (use.name == flow::name(kind)) count_flow(passage, kind, use.phases, use.steps);
}

/// Periods of a single wave through so many contacts, there and back. Of a body only the first impact is
/// harmless: the next one depends on how far it has turned since.
inline Index single_wave(Index contacts) {
  return 2 * contacts;
}
inline constexpr Index single_impact = 1;

/// How often one contact may close before its body counts as one that rattles.
inline constexpr Index rattles = 3;

/// Durations of a contact that a flight may last before errors count that it makes larger: an approach below
/// a tenth of the accuracy is left out.
inline constexpr double long_flight = 3;
/// How many times slower than it met what adheres may part before errors count that it makes larger: those of
/// the energy are about a tenth of the accuracy.
inline constexpr double much_slower = 8;
/// How many times larger flights and what adheres have made errors, beyond that.
inline double growth(const Passage& passage) {
  return std::max({1.0, passage.flight / long_flight, passage.slowing / much_slower});
}

/// True if errors may have grown: contacts, or one of them, have closed so often that what one does wrong is
/// magnified by the next, or the errors of many steps have added up, or a long flight has moved what pushes
/// together then, or some came together very slowly at first, or what adheres has let go slowly.
inline bool may_have_erred(const Passage& passage) {
  return passage.periods > passage.harmless || passage.most > rattles || passage.starts_slowly ||
         passage.steps > 60 + 10 * passage.contacts || passage.flight > long_flight ||
         passage.slowing >= much_slower;
}

/// Periods after which rounding alone decides the end, and each run takes minutes: it is not run again.
inline constexpr Index most_periods_run_again = 100'000;

/// True if runs that differ in accuracy may agree although rounding has moved both: most of what they did is
/// exact but for rounding, or the looser of them was nearly so.
inline bool hides_rounding(const Passage& passage, double looser) {
  return passage.exact > passage.cut || looser <= 1e-11;
}

/// What a whole result of a chain or network has gone through.
template <class Impact>
Passage passage(const Impact& impact) {
  const Index contacts = std::ssize(impact.contacts);
  Passage gone{.contacts = contacts,
               .harmless = single_wave(contacts),
               .flight = longest_flight(impact.contacts),
               .slowing = impact.slowing};
  for (const auto& contact : impact.contacts) {
    gone.periods += std::ssize(contact.periods);
    gone.most = std::max(gone.most, std::ssize(contact.periods));
  }
  count_flows(gone, impact.flows);
  gone.floor = floor_of_cvode(gone);
  return gone;
}

}  // namespace mariotte::impact
