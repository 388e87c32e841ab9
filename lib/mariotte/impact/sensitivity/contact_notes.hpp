// What notes say of the contacts of a chain or a network: where slightly other numbers lead to another order
// of events.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/impact/sensitivity/contact_variation.hpp"
#include "mariotte/impact/sensitivity/notes.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

/// A state and its slopes.
struct SlopedState {
  ConstState x;
  const SlopeMatrix& slopes;
};

template <class Topology>
class ContactNotes {
 public:
  using Scaled = typename Topology::Model;

  /// For `result`, which knows its parameters.
  ContactNotes(const Scaled& base, const model::ContactLayout& layout,
               const ContactVariation<Topology>& variation, Sensitivity& result)
      : base_(base), layout_(layout), variation_(variation), result_(result) {}

  template <class System>
  void add(const SlopedState& start, const SlopeRun<System>& end) {
    if (end.run.ending == hybrid::Ending::separated) add_near_closings(end);
    add_slow_starts(start);
    add_near_turns(variation_.near_yield(), near_yield_note);
    add_near_turns(variation_.near_closing(), near_miss_note);
  }

 private:
  static constexpr double slow = 1e-6;  ///< share of the speed of a model

  static std::string name_of_contact(Index j) { return "contact " + std::to_string(j + 1); }

  /// Parameters that move the approach of contact j: next to none by their natural sizes, another so that a
  /// ten-thousandth of them turns it.
  Names moving_approach(const SlopeMatrix& slopes, Index j, double speed) const {
    constexpr double share = 1e-4;
    return names_of(result_.parameter, [&](std::size_t c) {
      const double moves = std::abs(Topology{base_, layout_}.approach(slopes.column(c), j));
      if (speed < slow * base_.speed) return moves / variation_.natural_slopes()[c] > slow;
      return share * std::abs(result_.parameter[c].value) * moves > speed;
    });
  }

  /// What changes where contact j closes once more.
  Names pushed_by(Index j) const {
    Names names{"impulse[" + std::to_string(j) + "]", "icr[" + std::to_string(j) + "]", "time"};
    if (j > 0) names.push_back("icr[" + std::to_string(j - 1) + "]");
    Topology{base_, layout_}.for_each_push(j, [&](Index place, double change) {
      const auto i =
          std::find(layout_.velocity.begin(), layout_.velocity.end(), place) - layout_.velocity.begin();
      if (change != 0) names.push_back("velocity[" + std::to_string(i) + "]");
    });
    return names;
  }

  /// Open contacts whose balls go on together or nearly so: they close again as soon as some number moves.
  template <class System>
  void add_near_closings(const SlopeRun<System>& end) {
    for (Index j = 0; j < layout_.contacts(); ++j) {
      const double speed = std::abs(Topology{base_, layout_}.approach(end.run.state, j));
      if (contact::carries_force(end.mode[j])) continue;
      const auto name = name_of_contact(j);
      auto moving = moving_approach(end.slopes, j, speed);
      if (!moving.empty())
        result_.notes.push_back(
            near_closing_note(name, speed * base_.scale.velocity, pushed_by(j), std::move(moving)));
      if (speed > 0 && speed <= base_.noise_speed)
        result_.notes.push_back(closing_in_noise_note(name, pushed_by(j)));
    }
  }

  /// Linear contacts that touch hardly approaching, or parting: pressed they act at once, apart not at all.
  void add_slow_starts(const SlopedState& start) {
    for (Index j = 0; j < layout_.contacts(); ++j) {
      const double speed = std::abs(Topology{base_, layout_}.approach(start.x, j));
      if (!(contact::is_linear(base_.law[j]) && start.x[layout_.gap[j]] == 0 && speed > 0 &&
            speed < slow * base_.speed))
        continue;
      auto moving = moving_approach(start.slopes, j, speed);
      if (!moving.empty())
        result_.notes.push_back(
            hardly_touching_note(name_of_contact(j), speed * base_.scale.velocity, std::move(moving)));
    }
  }

  /// What returns as fast as it has left turns where it did, and yields beyond; or an open contact turns next
  /// to where it would close.
  void add_near_turns(const std::vector<double>& distance, SlopeNote (*note)(const std::string&, double)) {
    for (Index j = 0; j < layout_.contacts(); ++j)
      if (std::abs(distance[j]) < slow)
        result_.notes.push_back(
            note(name_of_contact(j), std::max(0.0, distance[j]) * base_.length[j] * base_.scale.length));
  }

  const Scaled& base_;
  const model::ContactLayout& layout_;
  const ContactVariation<Topology>& variation_;
  Sensitivity& result_;
};

}  // namespace mariotte::impact
