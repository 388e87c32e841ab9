#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/impact/sensitivity/microbody_rest.hpp"
#include "mariotte/impact/sensitivity/microbody_variation.hpp"
#include "mariotte/impact/sensitivity/notes.hpp"
#include "mariotte/impact/sensitivity/resolved.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"
#include "mariotte/model/microbody/microbody_field.hpp"

namespace mariotte::impact {

using model::DimensionlessMicrobody;
using model::Microbody;
using model::MicrobodySystem;

namespace {

/// Everything that a body is asked for at its end, and of its first impact.
struct Reading {
  const char* name;
  const char* unit;
};
constexpr std::array<Reading, 8> readings{{{"normal_velocity", "m/s"},
                                           {"v2", "m/s"},
                                           {"v3", "m/s"},
                                           {"w1", "rad/s"},
                                           {"w2", "rad/s"},
                                           {"w3", "rad/s"},
                                           {"e_n", "1"},
                                           {"e_nm", "1"}}};
using Readings = std::array<double, readings.size()>;

/// Velocities and spins at the end, then normal velocities behind and before the first impact, of the tip and
/// of the mass centre, whose quotients are the restitutions.
constexpr std::size_t at_end = 6, quotients = 2;
using Motions = std::array<double, at_end + 2 * quotients>;

/// `first` is the state at the end of the first impact.
Motions motions(const DimensionlessMicrobody& body, const model::MicrobodyLayout& layout, ConstState start,
                ConstState first, ConstState end) {
  const model::Mechanics mechanics{body, layout};
  const Vector3 v = vector_at(end, layout.place.velocity), w = mechanics.spin(end),
                before = vector_at(start, layout.place.velocity),
                behind = vector_at(first, layout.place.velocity);
  const double speed = body.scale.velocity, turn = 1 / body.scale.time;
  return {speed * v.e1,
          speed * v.e2,
          speed * v.e3,
          turn * w.e1,
          turn * w.e2,
          turn * w.e3,
          mechanics.tip(first, 0).velocity,
          mechanics.tip(start, 0).velocity,
          behind.e1,
          before.e1};
}

Readings readings_of(const Motions& all) {
  Readings read;
  std::copy_n(all.begin(), at_end, read.begin());
  for (std::size_t i = 0; i < quotients; ++i)
    read[at_end + i] = -all[at_end + 2 * i] / all[at_end + 2 * i + 1];
  return read;
}

/// Slopes of readings from those of motions. Differences of quotients would step across poles: a spin may
/// nearly stop the tip that strikes.
Readings slopes_of(const Motions& all, const Motions& slopes) {
  const auto values = readings_of(all);
  Readings by;
  std::copy_n(slopes.begin(), at_end, by.begin());
  for (std::size_t i = 0; i < quotients; ++i) {
    const auto out = at_end + 2 * i, in = out + 1;
    by[at_end + i] = -(slopes[out] + values[at_end + i] * slopes[in]) / all[in];
  }
  return by;
}

/// What readings are compared with.
Readings natural_sizes(const DimensionlessMicrobody& body) {
  const double speed = body.speed * body.scale.velocity,
               turn = body.speed / reach(body.body) / body.scale.time;
  return {speed, speed, speed, turn, turn, turn, 1, 1};
}

class BodySlopes {
 public:
  /// `accuracy` is what was asked for, `options` are those of the run.
  BodySlopes(const Microbody& body, const std::vector<Parameter<Microbody>>& by, double accuracy,
             const hybrid::Options& options, const SlopeWatch& watch)
      : system_(body, options.accuracy, /*balance=*/false, {.force_signs = false}),
        layout_(system_.layout()),
        accuracy_(accuracy),
        x0_(initial_state(system_.body(), layout_)),
        start_(layout_.size, std::ssize(by)) {
    for (const auto& one : by) {
      watch();
      result_.parameter.push_back({one.name, one.value});
      auto& bodies = shifted_.emplace_back();
      bodies.step = one.step;
      for (std::size_t k = 0; k < stencil.size(); ++k)
        bodies.at[k] = restated(one.model(one.value + stencil[k].offset * one.step), system_.body());
    }
    set_start();
    MicrobodyVariation variation(system_, shifted_);
    auto run_options = hybrid::scaled(options, system_.body().scale);
    run_options.accuracy = system_.accuracy();
    auto behind = start_;
    rest_at_start(system_, shifted_, x0_, behind);
    one_sided_ = slips_at_start(system_, shifted_, x0_, start_);
    end_ = SlopeLoop(system_, variation, run_options, watch).follow(x0_, behind);
    move_limit(by, system_.body().scale.time, end_);
    opening_ = variation.opening() ? *variation.opening() : at_the_end();
    comes_off_ = variation.opening().has_value();
    result_.in_doubt = variation.slips_from_rest();
    if (result_.in_doubt) result_.notes.push_back(slip_from_rest_note());
    turning_loss_ = variation.turning_loss();
  }

  double turning_loss() const { return turning_loss_; }

  Sensitivity take() {
    result_.ending = end_.run.ending;
    result_.message = end_.run.message;
    add_readings();
    add_time();
    add_notes(end_, system_.body().scale.time, moving_with_the_end(), result_);
    add_note_of_landing(one_sided_, result_);
    add_note_of_capture();
    leave_out_unbounded(result_);
    return std::move(result_);
  }

 private:
  void set_start() {
    std::array<std::vector<double>, stencil.size()> x;
    for (Index c = 0; c < start_.columns; ++c) {
      for (std::size_t k = 0; k < stencil.size(); ++k) x[k] = initial_state(shifted_[c].at[k], layout_);
      for (Index r = 0; r < start_.rows; ++r)
        start_(r, c) = stencil_slope(shifted_[c].step, [&](std::size_t k) { return x[k][r]; });
    }
  }

  FirstOpening at_the_end() const {
    FirstOpening end{end_.run.time, end_.run.state, end_.slopes, end_.time};
    for (Index c = 0; c < start_.columns; ++c)
      for (Index r = 0; r < start_.rows; ++r) end.slopes(r, c) += end_.rate[r] * end_.time[c];
    return end;
  }

  Motions moved(Index c, std::size_t k) const {
    const double by = stencil[k].offset * shifted_[c].step;
    const auto end = at_the_end();
    std::vector<double> before = x0_, first = opening_.state, after = end.state;
    for (Index r = 0; r < start_.rows; ++r) {
      before[r] += by * start_(r, c);
      first[r] += by * opening_.slopes(r, c);
      after[r] += by * end.slopes(r, c);
    }
    return motions(shifted_[c].at[k], layout_, before, first, after);
  }

  void add_readings() {
    const auto found = motions(system_.body(), layout_, x0_, opening_.state, end_.run.state);
    const auto values = readings_of(found);
    for (std::size_t i = 0; i < readings.size(); ++i)
      result_.outcome.push_back({readings[i].name, {}, readings[i].unit, values[i], {}});
    for (Index c = 0; c < start_.columns; ++c) {
      std::array<Motions, stencil.size()> all;
      for (std::size_t k = 0; k < stencil.size(); ++k) all[k] = moved(c, k);
      Motions slopes;
      for (std::size_t i = 0; i < slopes.size(); ++i)
        slopes[i] = stencil_slope(shifted_[c].step, [&](std::size_t k) { return all[k][i]; });
      const auto by = slopes_of(found, slopes);
      for (std::size_t i = 0; i < readings.size(); ++i) result_.outcome[i].slope.push_back(by[i]);
    }
  }

  /// The time, unless the first contact has ended before, and what goes on to move then, by more than the
  /// accuracy in a natural time.
  Names moving_with_the_end() const {
    constexpr double little = 1e-3;
    const auto& body = system_.body();
    auto later = end_.run.state;
    for (std::size_t r = 0; r < later.size(); ++r) later[r] += little * body.time * end_.rate[r];
    const bool ends_first = opening_.time < end_.run.time;
    const auto &last = end_.run.state, &first = ends_first ? opening_.state : later;
    const auto before = readings_of(motions(body, layout_, x0_, ends_first ? first : last, last)),
               after = readings_of(motions(body, layout_, x0_, first, later));
    const auto natural = natural_sizes(body);
    Names names;
    if (!ends_first) names.push_back("contact_time");
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const double size = std::max(std::abs(before[i]), natural[i]);
      if (std::abs(after[i] - before[i]) > accuracy_ * little * size) names.push_back(readings[i].name);
    }
    return names;
  }

  void add_time() {
    const double unit = system_.body().scale.time;
    OutcomeSlopes time{"contact_time", {}, "s", opening_.time * unit, {}};
    for (Index c = 0; c < start_.columns; ++c) time.slope.push_back(opening_.time_slopes[c] * unit);
    result_.outcome.push_back(std::move(time));
  }

  /// And what depends on the instant of the capture.
  void leave_out_rebound() {
    SlopeNote note{
        .text =
            "the body is captured: there is no rebound that could have slopes, and it is so when its "
            "motion has come down to the accuracy, which has none either",
        .outcomes = {"e_n", "e_nm", "contact_time"}};
    if (end_.time_is_noise)
      for (auto& name : moving_with_the_end()) note.outcomes.push_back(std::move(name));
    leave_out(std::move(note));
  }

  /// Of a body that has come off before it was captured.
  void leave_out_end() {
    if (!end_.time_is_noise) return;
    leave_out({.text = "the body is captured in the end, when its motion has come down to the accuracy: this "
                       "instant has no slopes",
               .outcomes = moving_with_the_end()});
  }

  void leave_out(SlopeNote note) {
    if (note.outcomes.empty()) return;
    for (auto& outcome : result_.outcome)
      if (std::find(note.outcomes.begin(), note.outcomes.end(), outcome.name) != note.outcomes.end())
        std::fill(outcome.slope.begin(), outcome.slope.end(), std::nullopt);
    result_.notes.push_back(std::move(note));
  }

  /// Above the capture velocity v_c the rebound is ~ √(v − v_c): its slopes grow like the inverse.
  void add_note_of_capture() {
    if (end_.run.ending == hybrid::Ending::captured)
      return comes_off_ ? leave_out_end() : leave_out_rebound();
    for (const auto& outcome : result_.outcome)
      if (outcome.name == "e_n" && std::abs(*outcome.value) < 0.1)
        result_.notes.push_back(
            {.text = "the rebound is " + std::to_string(*outcome.value) +
                     " of the approach, near capture: slopes grow as it vanishes, and hold only while "
                     "it changes by a small part",
             .error = 0});
  }

  MicrobodySystem system_;
  const model::MicrobodyLayout& layout_;
  double accuracy_;
  double turning_loss_ = 0;
  std::vector<bool> one_sided_;  ///< by parameter
  std::vector<double> x0_;
  SlopeMatrix start_;
  std::vector<ShiftedBodies> shifted_;
  SlopeRun<MicrobodySystem> end_;
  FirstOpening opening_;
  bool comes_off_ = false;
  Sensitivity result_;
};

}  // namespace

Sensitivity sensitivity(const Microbody& body, const std::vector<Parameter<Microbody>>& by,
                        const hybrid::Options& asked, const SlopeWatch& watch) {
  model::validate(body);
  hybrid::validate(asked);
  return resolved(
      asked,
      [&](const hybrid::Options& options) {
        BodySlopes run(body, by, asked.accuracy, options, watch);
        return std::pair(run.take(), run.turning_loss());
      },
      turning_slip_note);
}

}  // namespace mariotte::impact
