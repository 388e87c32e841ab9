// Impulses and their ratios.
#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/model/chain/chain_system.hpp"

namespace mariotte::impact {

/// A interval of a run: two states and the time between them, dimensionless.
struct Interval {
  ConstState before;
  ConstState after;
  double time;
};

/// p_j = ∫ f_j dt of all n−1 contacts, from momentum: p_j = p_{j−1} − m_j (Δv_j + γ t), started at the free
/// ends of the chain where p = 0, up to the heaviest ball, whose momentum has the largest rounding. Where
/// another wall or heavy ball stands between, it rests on the integral of a faint contact's force. Fills p.
void impulses(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
              const Interval& interval, Index heaviest, std::vector<double>& p);
inline void impulses(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                     const Interval& interval, std::vector<double>& p) {
  impulses(chain, layout, interval, model::heaviest_ball(chain), p);
}

/// A contact starts to carry force.
inline bool starts_force(const model::ContactChange& change) {
  return !contact::carries_force(change.before) && contact::carries_force(change.after);
}
inline bool ends_force(const model::ContactChange& change) {
  return contact::carries_force(change.before) && !contact::carries_force(change.after);
}

/// How often each of the n−1 contacts started to carry force.
void count_periods(const std::vector<hybrid::Timed<model::ContactChange>>& changes, Index contacts,
                   std::vector<Index>& periods);

/// An impulse of contact j that can have stopped no more than what counts as rest.
inline bool is_faint(const model::ScaledContacts& contacts, Index j, double impulse) {
  return std::abs(impulse) <= contacts.reduced_mass[j] * contacts.noise_speed;
}
/// A contact that never carried force has no impulse, whatever rounding says, nor has one whose is faint.
void clear_faint(const model::ScaledContacts& contacts, const std::vector<Index>& periods,
                 std::vector<double>& p);

/// α_j = p_j/p_{j+1} [Acary 2003, eq. 5]; empty where p_{j+1} = 0, or is not one of the impulses.
std::optional<double> correlation_ratio(const std::vector<double>& impulses, std::size_t j);
/// All n−2 of them.
std::vector<std::optional<double>> correlation_ratios(const std::vector<double>& impulses);

/// |p|, without overflow.
double magnitude(const std::vector<double>& impulses);
/// r = p/|p|, defined even where ratios are not; zeros if every impulse is zero.
std::vector<double> direction(const std::vector<double>& impulses);

}  // namespace mariotte::impact
