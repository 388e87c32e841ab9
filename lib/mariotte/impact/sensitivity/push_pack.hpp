// The series of as many parameters as N registers hold, or of a lone one with N = 0, as far as they are
// right, for one instruction set.
#pragma once
#include "mariotte/impact/sensitivity/push_clock.hpp"
#include "mariotte/impact/sensitivity/push_end.hpp"
#include "mariotte/impact/sensitivity/push_start.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

/// Keeps its memory from step to step.
template <int N>
class PackSeries {
 public:
  using Pack = Lanes<N>;

  /// Parameters from `first` on, up to `stop` at most: how far the series reaches.
  double expand(const Forces& forces, const Start& start, Index first, double stop,
                const PushExpansion::Bound& bound, const PushExpansion::End& to) {
    forces_ = &forces;
    columns_.set(start, first);
    stop = forces.series->power > 0 ? expand_start(bound) : expand_clock(stop, bound);
    if (stop > 0) end_.tell(columns_, to);
    return stop;
  }

 private:
  using Rows = std::vector<Row<N>>;

  const Forces* forces_ = nullptr;
  Columns<N> columns_;
  ClockSeries<N> in_clock_;
  StartSeries<N> in_start_;
  Rows rows_, logs_;  ///< by contact
  PushEnd<N> end_;

  int order() const { return forces_->series->order; }

  double expand_clock(double stop, const PushExpansion::Bound& bound) {
    constexpr int attempts = 3;
    const bool has_logs = finds_logs();
    if (has_logs) in_clock_.expand_logs(*forces_, columns_, logs_);
    in_clock_.expand(*forces_, columns_, has_logs ? &logs_ : nullptr, rows_);
    for (int n = 0; n < attempts; ++n) {
      begin_end(value_at(stop, forces_->time, order()));
      evaluate_clock(rows_, 1, 1, stop);
      if (has_logs) evaluate_clock(logs_, 0, std::log(stop), stop);
      const double over = end_.excess(columns_, bound);
      if (over <= 1) return stop;
      stop *= 0.95 * std::pow(over, -1.0 / (order() - 1));
    }
    return 0;
  }

  /// Whether a contact closes here by whose exponent there are slopes.
  bool finds_logs() const {
    for (std::size_t j = 0; j < columns_.contact.size(); ++j)
      if (columns_.contact[j].has_exponent && forces_->contact[j].has_log) return true;
    return false;
  }

  double expand_start(const PushExpansion::Bound& bound) {
    begin_end(forces_->series->end);
    for (const int e : {0, 1}) {
      in_start_.expand(*forces_, columns_, e, rows_);
      evaluate_start(e);
    }
    return end_.excess(columns_, bound) <= 1 ? end_.time : 0;
  }

  void begin_end(double time) {
    end_.time = time;
    end_.last = Pack(0.0);
    end_.given.assign(forces_->contact.size(), {});
  }

  /// Add `unit` times these rows at s, and `share` of what they are slopes of.
  void evaluate_clock(const Rows& rows, double share, double unit, double s) {
    const int n = order();
    for (std::size_t j = 0; j < rows.size(); ++j) {
      auto& given = end_.given[j];
      given.impulse += unit * s * value_at(s, rows[j].impulse, 1, n);
      given.travel += unit * s * value_at(s, rows[j].travel, 1, n);
      given.impulse_itself += share * value_at(s, forces_->contact[j].impulse, n);
      given.travel_itself += share * value_at(s, forces_->contact[j].travel, n);
    }
    end_.last += std::abs(unit) * std::pow(s, n - 1) * last_terms(rows, share, n, s);
  }

  void evaluate_start(int e) {
    const int n = order() - 1;
    const double t = end_.time, z = std::pow(t, forces_->series->power), unit = std::pow(t, e + 1.5);
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      auto& given = end_.given[j];
      given.impulse += unit * value_at(z, rows_[j].impulse, 0, n);
      given.travel += unit * t * value_at(z, rows_[j].travel, 0, n);
      given.impulse_itself += e * unit * value_at(z, forces_->contact[j].impulse, n);
      given.travel_itself += e * unit * t * value_at(z, forces_->contact[j].travel, n);
    }
    end_.last = largest(end_.last, Pack(unit * std::pow(z, n - 1) * last_terms(rows_, e, n, z)));
  }

  /// Orders n − 1 and n of velocities, over the place to the power n − 1. Contacts have given them `share` of
  /// their own slopes.
  Pack last_terms(const Rows& rows, double share, int n, double place) const {
    Pack most(0.0);
    for (const auto& effects : columns_.on_velocity) {
      Pack highest(0.0), before(0.0);
      for (const auto& effect : effects) {
        const auto& impulse = forces_->contact[effect.by].impulse;
        effect.add_to(highest, rows[effect.by].impulse[n], share * impulse[n]);
        effect.add_to(before, rows[effect.by].impulse[n - 1], share * impulse[n - 1]);
      }
      most = largest(most, Pack(place * magnitude(highest) + magnitude(before)));
    }
    return most;
  }
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
