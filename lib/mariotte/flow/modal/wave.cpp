#include "mariotte/flow/modal/wave.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/roots/enclosure.hpp"

namespace mariotte::flow {
namespace {

constexpr int deepest = 60;        ///< halvings until an interval is shorter than rounding
constexpr int most_guesses = 200;  ///< of a root; ten are usual

/// Root of a function that falls from `low` to `high`, by Newton's rule as long as that gets on between what
/// is known to be above and below zero, else by halves; to a share of the time, or where the value is no more
/// than its `noise`.
template <class Function, class Noise>
double fall_between(Function&& f, Noise&& noise, double low, double high, double share) {
  double time = 0.5 * (low + high), last = infinity;
  for (int i = 0; i < most_guesses; ++i) {
    const Slope now = f(time);
    const double ahead = -now.value / now.rate, step = std::abs(ahead);
    const bool stalls = step >= 0.5 * last;
    if (step <= share * time || (stalls && std::abs(now.value) <= noise(time)))
      return std::clamp(time + ahead, low, high);
    (now.value > 0 ? low : high) = time;
    const bool inside = !stalls && time + ahead > low && time + ahead < high;
    last = inside ? step : infinity;
    time = inside ? time + ahead : 0.5 * (low + high);
  }
  return time;
}

/// What rounding makes of the value of a wave.
double rounding(const Wave& wave, const std::vector<NaturalMode>& modes, double time) {
  double size = std::abs(wave.constant) + std::abs(wave.slope * time);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto now = values(modes[i], time);
    size += std::abs(wave.weight[i].even * now.even) + std::abs(wave.weight[i].odd * now.odd);
  }
  return 16 * epsilon * size;
}

/// The wave is positive, or rising from zero, at `from`.
std::optional<double> search(const Wave& wave, const std::vector<NaturalMode>& modes, double from, double to,
                             int depth) {
  const Enclosure enclosure(wave, modes, from, to);
  if (enclosure.value().low > 0) return std::nullopt;
  const auto rate = enclosure.rate();
  if (rate.low >= 0) return std::nullopt;
  if (rate.high <= 0 || depth == deepest) {
    if (wave.at(modes, to) > 0) return std::nullopt;
    if (!(wave.at(modes, from) > 0)) return from;
    return fall_between([&](double time) { return wave.slope_at(modes, time); },
                        [&](double time) { return rounding(wave, modes, time); }, from, to, 4 * epsilon);
  }
  const double middle = 0.5 * (from + to);
  if (const auto early = search(wave, modes, from, middle, depth + 1)) return early;
  return search(wave, modes, middle, to, depth + 1);
}

/// What is higher by less than that, relative, is not higher.
constexpr double level = 1e-13;

/// Intervals after which a search is content with the highest point it knows: of an undamped wave that swings
/// for long, very many maxima are equally high.
constexpr int most_intervals = 20000;

/// Branch and bound for the highest point.
struct Climb {
  const Wave& wave;
  const std::vector<NaturalMode>& modes;
  double height;                 ///< of the highest point known
  std::optional<Summit> summit;  ///< where that is, unless at an end
  int intervals = 0;             ///< searched so far

  void offer(double value, double time, double reach) {
    if (!(value > height)) return;
    height = value;
    summit = {time, reach};
  }
  /// The more promising half first: its height may spare the other.
  void search(double from, double to, const Enclosure& enclosure, double bound, int depth) {
    if (bound <= height + level * std::abs(height) || ++intervals > most_intervals) return;
    const auto rate = enclosure.rate();
    if (rate.low >= 0 || rate.high <= 0) return;  // no maximum inside; the ends belong to neighbours
    if (enclosure.bend().high < 0) return climb(from, to);
    const double middle = 0.5 * (from + to);
    offer(wave.at(modes, middle), middle, 0);
    if (depth == deepest) return;
    const Enclosure early(wave, modes, from, middle), late(wave, modes, middle, to);
    const double early_bound = early.value().high, late_bound = late.value().high;
    const bool early_first = early_bound > late_bound;
    if (early_first) search(from, middle, early, early_bound, depth + 1);
    search(middle, to, late, late_bound, depth + 1);
    if (!early_first) search(from, middle, early, early_bound, depth + 1);
  }
  void climb(double from, double to) {
    if (!(wave.slope_at(modes, from).rate > 0 && wave.slope_at(modes, to).rate < 0)) return;
    const double time =
        fall_between([&](double t) { return bend_at(t); }, [](double) { return 0.0; }, from, to, 1e-9);
    offer(wave.at(modes, time), time, std::min({1e-3 * (to - from), time - from, to - time}));
  }
  Slope bend_at(double time) const {
    Slope sum{wave.slope, 0};
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const auto first = derivative(modes[i], wave.weight[i]), second = derivative(modes[i], first);
      const auto now = values(modes[i], time);
      sum.value += dot(first, now);
      sum.rate += dot(second, now);
    }
    return sum;
  }
};

}  // namespace

double Wave::at(const std::vector<NaturalMode>& modes, double time) const {
  double sum = constant + slope * time;
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (weight[i].even != 0 || weight[i].odd != 0) sum += dot(weight[i], values(modes[i], time));
  return sum;
}
Slope Wave::slope_at(const std::vector<NaturalMode>& modes, double time) const {
  Slope sum{constant + slope * time, slope};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (weight[i].even == 0 && weight[i].odd == 0) continue;
    const auto now = values(modes[i], time);
    sum.value += dot(weight[i], now);
    sum.rate += dot(derivative(modes[i], weight[i]), now);
  }
  return sum;
}

std::optional<double> first_fall(const Wave& wave, const std::vector<NaturalMode>& modes, double from,
                                 double to) {
  return search(wave, modes, from, to, 0);
}

std::optional<Summit> highest(const Wave& wave, const std::vector<NaturalMode>& modes, double from,
                              double to) {
  if (!(to > from)) return std::nullopt;
  Climb climb{.wave = wave,
              .modes = modes,
              .height = std::max(wave.at(modes, from), wave.at(modes, to)),
              .summit = std::nullopt};
  const Enclosure enclosure(wave, modes, from, to);
  climb.search(from, to, enclosure, enclosure.value().high, 0);
  return climb.summit;
}

}  // namespace mariotte::flow
