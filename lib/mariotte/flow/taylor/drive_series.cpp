#include "mariotte/flow/taylor/drive_series.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/flow/taylor/window_parts.hpp"
#include "mariotte/series/unrolled.hpp"

namespace mariotte::flow::taylor {
namespace {

using series::reciprocal;

/// Of the velocity at a place in the state.
int number_of(const Window& w, Index place) {
  if (!w.row) return static_cast<int>(place);
  const auto& body = w.row->body;
  const auto is_it = [&](const SerialPhase::Body& one) { return one.velocity == place; };
  return static_cast<int>(std::find_if(body.begin(), body.end(), is_it) - body.begin());
}

double coefficient_of(const ContactDirection& terms, Index dof) {
  double sum = 0;
  for (const auto& term : terms)
    if (term.dof == dof) sum += term.coefficient;
  return sum;
}

/// use(lane, g, push) for the lanes whose gaps feel a velocity by g, and push it.
template <class Use>
void for_each_lane_at(const Window& w, int number, Use&& use) {
  if (w.row) {
    const double mobility = w.row->body[number].inverse_mass;
    if (number > 0) use(number - 1, 1.0, mobility);
    if (number < w.lanes.count) use(number, -1.0, -mobility);
    return;
  }
  for (int lane = 0; lane < w.lanes.count; ++lane) {
    const double g = coefficient_of(w.network->direction[w.number(lane)], number),
                 push = coefficient_of(w.network->response[w.number(lane)], number);
    if (g != 0 || push != 0) use(lane, g, push);
  }
}

/// A step of the window that has been expanded.
class DrivenStep {
 public:
  DrivenStep(const Window& window, const Expansion& lanes, int order)
      : w_(window), lanes_(lanes), order_(order) {}

  /// Walls work against the forces of their contacts, and given forces on what they push.
  void find_work(const Drive& drive, DriveSeries& one) const {
    one.work = {};
    for (const auto& [place, coefficient] : drive.direction) {
      const int number = number_of(w_, place);
      const auto velocity = velocity_of(number);
      if (drive.is_force)
        add_integral(coefficient, velocity, one.gain, one.work);
      else
        for_each_lane_at(w_, number, [&](int lane, double g, double) {
          add_integral(-g, velocity, impulse_of(lane), one.work);
        });
    }
  }

 private:
  const Window& w_;
  const Expansion& lanes_;
  int order_;

  Coefficients impulse_of(int lane) const {
    Coefficients impulse;
    lanes_.coefficients(Quantity::impulse, lane, impulse.data());
    if (w_.pushes(lane)) impulse[1] -= w_.contact(lane).pull;
    return impulse;
  }
  Coefficients velocity_of(int number) const {
    Coefficients sum = {w_.velocity[number]};
    if (w_.row) sum[1] = w_.row->body[number].acceleration;
    const auto add = [&](double share, const Coefficients& part) {
      for (int k = 0; k <= order_; ++k) sum[k] += share * part[k];
    };
    for_each_lane_at(w_, number, [&](int lane, double, double push) {
      if (push != 0) add(push, impulse_of(lane));
    });
    for (const auto& one : w_.driven)
      for (const auto& [moved, share] : one.on_velocity)
        if (moved == number) add(share, one.gain);
    return sum;
  }
  /// share ∫ a db.
  void add_integral(double share, const Coefficients& a, const Coefficients& b, Coefficients& sum) const {
    for (int k = 1; k <= order_; ++k) {
      double product = 0;
      for (int i = 1; i <= k; ++i) product += a[k - i] * (i * b[i]);
      sum[k] += share * reciprocal.of[k] * product;
    }
  }
};

void find_shares(const Window& w, const Drive& drive, DriveSeries& one) {
  for (const auto& term : drive.response) {
    const int number = number_of(w, term.dof);
    one.on_velocity.push_back({number, term.coefficient});
    for_each_lane_at(w, number, [&](int lane, double g, double) {
      if (g != 0) one.on_lane.push_back({lane, -g * term.coefficient});
    });
  }
}

}  // namespace

void begin_drives(Window& w) {
  w.bend.resize(w.drives ? static_cast<std::size_t>(order_limit * w.lanes.count) : 0);
  w.lanes.bend = w.drives ? w.bend.data() : nullptr;
  w.driven.assign(w.drives ? w.drives->drive.size() : 0, {});
  for (std::size_t k = 0; k < w.driven.size(); ++k) {
    const auto& drive = w.drives->drive[k];
    find_shares(w, drive, w.driven[k]);
    const double kink = w.since + (drive.end - w.x[w.drives->clock]);
    if (!(kink < w.outside_time)) continue;
    w.outside_time = kink;
    w.outside = nullptr;
    w.outside_guard = drive.guard;
  }
}

void expand_drives(Window& w, int order) {
  std::fill(w.bend.begin(), w.bend.end(), 0.0);
  const double time = w.x[w.drives->clock] + (w.time - w.since);
  for (std::size_t k = 0; k < w.driven.size(); ++k) {
    auto& one = w.driven[k];
    Coefficients change;
    expand(w.drives->drive[k].change, time, change);
    one.gain[0] = 0;
    for (int i = 0; i < order_limit; ++i) one.gain[i + 1] = reciprocal.of[i + 1] * change[i];
    for (const auto& [lane, share] : one.on_lane)
      for (int i = 0; i < order; ++i) w.bend[i * w.lanes.count + lane] += share * change[i];
  }
}

double reach_of_drives(const Window& w, int order, double tolerance) {
  double end = infinity;
  const auto bound = [&](double share, const Coefficients& c) {
    for (const int k : {order - 1, order})  // those of a sine vanish in turn
      if (const double size = std::abs(share * c[k]); size > 1e-300)
        end = std::min(end, rough_root(tolerance / size, k));
  };
  for (const auto& one : w.driven) {
    bound(1, one.work);
    for (const auto& [number, share] : one.on_velocity) bound(share, one.gain);
  }
  return end;
}

void find_works(Window& w, const Expansion& lanes, int order) {
  const DrivenStep step(w, lanes, order);
  for (std::size_t k = 0; k < w.driven.size(); ++k) step.find_work(w.drives->drive[k], w.driven[k]);
}

}  // namespace mariotte::flow::taylor
