// Largest force and indentation of every contact, found inside the steps of whatever flow runs.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/model/contacts/contact_phase.hpp"

namespace mariotte::impact {

/// Dimensionless peaks of one contact.
struct Peak {
  double force = 0;
  double indentation = 0;
};

/// Every member of a struct of peaks.
inline constexpr std::array all_peaks = {&Peak::force, &Peak::indentation};
static_assert(sizeof(Peak) == all_peaks.size() * sizeof(double), "every peak is in the list");

/// Each peak becomes the larger of the two; `members` are those of their struct.
template <class Peaks, std::size_t n>
void raise(Peaks& peaks, const Peaks& others, const std::array<double Peaks::*, n>& members) {
  for (const auto member : members) peaks.*member = std::max(peaks.*member, others.*member);
}

/// Looks at each step for a maximum of δ or f: a slope that falls through zero. The maximum itself is flat,
/// so a loose place is enough for a tight value. Where a step knows the motion of one contact by itself, no
/// other is evaluated.
class PeakObserver {
 public:
  /// From now on look at the steps of this phase, all peaks forgotten; it must outlive the observation.
  void begin(const model::ContactPhase& phase);
  void observe(const flow::Step& step);
  const std::vector<Peak>& peaks() const { return peaks_; }

 private:
  /// ḟ; `dx` is the derivative at x.
  double force_slope(ConstState x, ConstState dx, Index j) const;
  void take(ConstState x, Index j);
  void take(double depth, double rate, Index j);
  template <class Slope>
  void search(const flow::Step& step, Index j, double before, double after, Slope&& slope);
  template <class Slope>
  void search_series(Index j, double before, double after, Slope&& slope);
  void search_indentation(const flow::Step& step, Index j);
  void search_force(const flow::Step& step, Index j);

  const model::ContactPhase* phase_ = nullptr;
  std::vector<Peak> peaks_;
  bool damped_ = false;  ///< any contact
  std::vector<double> inside_, rate_, rate_before_, rate_after_;
  flow::IndentationSeries motion_;  ///< of the contact that is looked at
};

}  // namespace mariotte::impact
