#include <algorithm>
#include <array>

#include "mariotte/impact/bodies/bodies_frame.hpp"
#include "mariotte/impact/sensitivity/bodies/bodies_variation.hpp"
#include "mariotte/impact/sensitivity/frame_slopes.hpp"
#include "mariotte/impact/sensitivity/notes.hpp"
#include "mariotte/impact/sensitivity/resolved.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

using model::Bodies;
using model::BodiesLayout;
using model::BodyEvent;

namespace {

constexpr const char* loss_names[] = {"friction", "rescale", "damper"};

/// A run of bodies with slopes, and its outcomes.
template <int D>
class GroupSlopes {
 public:
  GroupSlopes(const Bodies& bodies, const std::vector<Parameter<Bodies>>& by, const hybrid::Options& options,
              double resolution, const SlopeWatch& watch)
      : bodies_(bodies),
        system_(bodies, model::setting_of<D>(bodies, options.accuracy, options.max_time),
                options.flies_on ? model::Over::at_time_limit : model::Over::separated),
        x0_(initial_state(bodies, system_.setting())),
        start_(std::ssize(x0_), std::ssize(by)),
        variation_(system_, shifted(by, options.accuracy, watch)),
        end_(SlopeLoop(system_, variation_, options, resolution, watch).follow(x0_, start_)) {
    move_limit(by, 1, end_);
    for (const auto& one : by) result_.parameter.push_back({one.name, one.value});
  }

  Sensitivity take() {
    result_.ending = end_.run.ending;
    result_.message = end_.run.message;
    add_bodies();
    add_contacts();
    add("time", {}, "s", end_.run.time, [&](Index c) -> std::optional<double> {
      if (end_.time_is_noise || end_.time_is_shared[c]) return std::nullopt;
      return end_.time[c];
    });
    add_notes(end_, 1, {}, result_);
    result_.in_doubt = variation_.has_unknown_way();
    if (result_.in_doubt) result_.notes.push_back(unknown_way_note());
    add_note_of_landing(variation_.one_sided(), result_);
    leave_out_unbounded(result_);
    return std::move(result_);
  }

 private:
  static constexpr int tangents = BodiesLayout<D>::tangents;

  /// The bodies around each parameter; slopes of the state at the start on the way.
  std::vector<ShiftedSettings<D>> shifted(const std::vector<Parameter<Bodies>>& by, double accuracy,
                                          const SlopeWatch& watch) {
    std::vector<ShiftedSettings<D>> list;
    std::array<std::vector<double>, stencil.size()> x;
    for (const auto& one : by) {
      watch();
      const Index c = std::ssize(list);
      auto& settings = list.emplace_back();
      settings.step = one.step;
      for (std::size_t k = 0; k < stencil.size(); ++k) {
        const auto moved = one.model(one.value + stencil[k].offset * one.step);
        settings.at[k] = model::setting_of<D>(moved, accuracy);
        x[k] = initial_state(moved, settings.at[k]);
      }
      for (Index row = 0; row < start_.rows; ++row)
        start_(row, c) = stencil_slope(one.step, [&](std::size_t k) { return x[k][row]; });
    }
    return list;
  }

  double slope(Index row, Index c) const { return end_.slopes(row, c) + end_.rate[row] * end_.time[c]; }
  /// None of what moves on where the end of the run has none.
  static std::optional<double> at_end(double slope, bool moves_on) {
    return moves_on ? std::nullopt : std::optional(slope);
  }

  template <class Slope>
  void add(std::string name, std::optional<Index> index, const char* unit, double value, Slope&& slope_of) {
    auto& outcome = result_.outcome.emplace_back(OutcomeSlopes{std::move(name), index, unit, value, {}});
    for (Index c = 0; c < start_.columns; ++c) outcome.slope.push_back(slope_of(c));
  }

  void add_bodies() {
    const auto at = system_.layout(end_.run.state);
    for (Index i = 0; i < at.bodies; ++i) {
      const auto name = "bodies[" + std::to_string(i) + "].";
      for (Index k = 0; k < D; ++k)
        add(name + "velocity", k, "m/s", end_.run.state[at.velocity(i) + k], [&](Index c) {
          return at_end(slope(at.velocity(i) + k, c),
                        end_.time_is_noise && end_.rate[at.velocity(i) + k] != 0);
        });
      add_spin(name + "spin", i);
    }
  }

  /// In space the spin follows from momentum, attitude and moments, all of which move.
  void add_spin(const std::string& name, Index i) {
    const auto at = system_.layout(end_.run.state);
    const auto spin = model::motion_of(system_.setting().body[i], at, ConstState(end_.run.state), i).spin;
    const auto slopes = spin_slopes(at, i);
    const bool moves_on = end_.time_is_noise && is_turned(at, i);
    for (int k = 0; k < model::turns(D); ++k)
      add(name, D == 2 ? std::nullopt : std::optional<Index>(k), "rad/s", spin[k],
          [&](Index c) { return at_end(slopes(k, c), moves_on); });
  }
  /// The spin of body i changes at the end, beyond rounding.
  bool is_turned(const BodiesLayout<D>& at, Index i) const {
    std::vector<model::Sloped> x(end_.run.state.begin(), end_.run.state.end());
    for (Index row = at.shift(i); row < at.shift(i + 1); ++row) x[row].slope[0] = end_.rate[row];
    const auto spin =
        model::motion_of(system_.setting().body[i], at, std::span<const model::Sloped>(x), i).spin;
    double square = 0, fastest = 0;
    for (int k = 0; k < model::turns(D); ++k) {
      square += spin[k].value * spin[k].value;
      fastest = std::max(fastest, std::abs(spin[k].slope[0]));
    }
    return fastest > 1e-9 * square;
  }
  SlopeMatrix spin_slopes(const BodiesLayout<D>& at, Index i) const {
    using model::Sloped;
    SlopeMatrix slopes(model::turns(D), start_.columns);
    std::vector<Sloped> x(end_.run.state.begin(), end_.run.state.end());
    for (Index c = 0; c < start_.columns; ++c) {
      const std::size_t lane = c % model::slope_lanes;
      for (Index row = at.shift(i); row < at.shift(i + 1); ++row) x[row].slope[lane] = slope(row, c);
      const auto motion = model::motion_of(variation_.numbers(c).body[i], at, std::span<const Sloped>(x), i);
      for (int k = 0; k < model::turns(D); ++k) slopes(k, c) = motion.spin[k].slope[lane];
    }
    return slopes;
  }

  bool acts(Index contact) const {
    const auto& changes = end_.run.changes;
    return contact < bodies_.named || std::any_of(changes.begin(), changes.end(), [&](const auto& one) {
             return one.change.contact == contact && one.change.event != BodyEvent::part;
           });
  }

  /// ∫f_n, ∫f_t and losses of contacts that are named or have closed, by their numbers in results.
  void add_contacts() {
    Index number = 0;
    for (Index j = 0; j < std::ssize(bodies_.contact); ++j) {
      const bool is_outcome = acts(j);
      if (is_outcome) add_contact(j, "contacts[" + std::to_string(number) + "].");
      number += is_outcome || j < always_told(bodies_);
    }
  }
  void add_contact(Index j, const std::string& name) {
    const auto at = system_.layout(end_.run.state);
    const auto values = exchanged(j);
    const auto& closed = end_.mode.closed;
    const auto own =
        std::find_if(closed.begin(), closed.end(), [&](const auto& one) { return one.contact == j; });
    const auto one = [&](const std::string& what, std::optional<Index> index, const char* unit, Index k) {
      add(name + what, index, unit, values[k], [&](Index c) {
        const double still = own == closed.end() ? 0 : slope(at.normal(own->slot) + k, c);
        return variation_.totals(j)(k, c) + still;
      });
    };
    one("normal_impulse", {}, "N s", 0);
    for (Index k = 0; k < tangents; ++k)
      one("tangential_impulse", D == 2 ? std::nullopt : std::optional<Index>(k), "N s", 1 + k);
    for (Index k = 0; k < 3; ++k)
      if (values[1 + tangents + k] != 0)
        one(std::string("losses.") + loss_names[k], {}, "J", 1 + tangents + k);
    if (variation_.faded(j) > 1e-6) doubt_rescale(name + "losses.rescale", variation_.faded(j));
  }
  /// Slopes that may be off by more than a tenth are left out.
  void doubt_rescale(const std::string& name, double error) {
    for (auto& outcome : result_.outcome) {
      if (outcome.name != name) continue;
      if (error > 0.1) outcome.slope.assign(outcome.slope.size(), std::nullopt);
      result_.notes.push_back(error > 0.1 ? faded_spring_note({name}) : fading_spring_note(error, {name}));
    }
  }
  std::vector<double> exchanged(Index j) const {
    const auto& totals = end_.mode.totals[j];
    std::vector<double> values{totals.normal};
    values.insert(values.end(), totals.tangential.begin(), totals.tangential.end());
    values.insert(values.end(), {totals.friction, totals.rescale, totals.damper});
    const auto at = system_.layout(end_.run.state);
    for (const auto& one : end_.mode.closed)
      if (one.contact == j)
        for (std::size_t k = 0; k < values.size(); ++k) values[k] += end_.run.state[at.normal(one.slot) + k];
    return values;
  }

  const Bodies& bodies_;
  model::BodiesSystem<D> system_;
  std::vector<double> x0_;
  SlopeMatrix start_;
  BodiesVariation<D> variation_;
  SlopeRun<model::BodiesSystem<D>> end_;
  Sensitivity result_;
};

/// The same numbers of bodies as seen in the frame.
std::vector<Parameter<Bodies>> within(const MovingFrame& frame, std::vector<Parameter<Bodies>> by) {
  if (!frame) return by;
  for (auto& one : by)
    one.set = [frame, set = one.set](double at, Bodies& bodies) {
      set(at, bodies);
      bodies = within(frame, std::move(bodies));
    };
  return by;
}

template <int D>
Sensitivity slopes_in(const Bodies& bodies, const std::vector<Parameter<Bodies>>& by, hybrid::Options options,
                      const SlopeWatch& watch) {
  const double asked = options.accuracy, resolution = for_slopes(options).accuracy;
  const auto setting = model::setting_of<D>(bodies, asked, options.max_time);
  options.accuracy = std::max(resolution, setting.rounding);
  const BodiesLayout<D> at{.bodies = std::ssize(bodies.body), .slots = 0};
  expect_few(at.size(), std::ssize(by));
  auto found = GroupSlopes<D>(bodies, by, options, resolution, watch).take();
  const double error = setting.rounding / slope_share;
  if (error > asked) found.notes.push_back(long_way_note(error));
  return found;
}

}  // namespace

Sensitivity sensitivity(const Bodies& bodies, const std::vector<Parameter<Bodies>>& by,
                        const hybrid::Options& options, const SlopeWatch& watch) {
  model::validate(bodies);
  hybrid::validate(options);
  model::expect_end(bodies, options.max_time);
  const auto frame = moving_frame(bodies);
  const auto moving = within(frame, bodies);
  const auto by_same = within(frame, by);
  auto found = bodies.dimension == 2 ? slopes_in<2>(moving, by_same, options, watch)
                                     : slopes_in<3>(moving, by_same, options, watch);
  leave(frame, found);
  return found;
}

}  // namespace mariotte::impact
