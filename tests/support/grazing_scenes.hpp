// Random chains in which one contact all but opens, or opens for less than a step: always the same ones.
#pragma once
#include <cstdint>
#include <functional>
#include <utility>

#include "support/oracle.hpp"

namespace mariotte::test {

/// Random numbers from a counter [splitmix64, Steele et al. 2014]: scene i can be repeated alone.
class Counter {
 public:
  explicit Counter(std::uint64_t index) : state_(index) { state_ = next(); }
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }
  double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  std::size_t below(std::size_t count) { return next() % count; }
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// What grazes: a closed contact that nearly lets go or does so for a moment; a slack one that is nearly
/// pressed again; a ball that gravity pulls back from a ceiling.
enum class Graze { opening, pressing_again, ceiling };

struct GrazingScene {
  model::Chain chain;
  Graze graze;
  std::size_t contact;  ///< that grazes
  double accuracy;      ///< at which the scene is to be run
  double depth;         ///< of the graze in units of the contact: negative if it falls short of an event
  double until;         ///< time to stop
  Truth truth;
};

enum class Damping { none, usual, strong };

/// n = 3 … 5 balls, masses over 2.4 decades, stiffnesses over 4, damping groups over 2; one kind of law or a
/// mixture; a wall in front of every sixth.
inline model::Chain random_chain(Counter& random, Damping damping) {
  model::Chain chain;
  const std::size_t balls = random.chance(0.5) ? 3 : 4 + random.below(2);
  for (std::size_t i = 0; i < balls; ++i) {
    chain.mass.push_back(random.decades(-1.2, 1.2));
    chain.velocity.push_back(i == 0 ? 1 : random.uniform(-1, 0.5));
  }
  if (random.chance(1.0 / 6)) chain.mass.back() = infinity, chain.velocity.back() = 0;
  const std::size_t kind = random.below(3);
  for (std::size_t j = 0; j + 1 < balls; ++j) {
    const double exponent = (kind == 2 ? random.below(2) : kind) == 0 ? 1 : 1.5;
    const double stiffness = random.decades(-2, 2);
    const double mass = 1 / (1 / chain.mass[j] + 1 / chain.mass[j + 1]);
    const double length = std::pow(mass / stiffness, 1 / (1 + exponent));
    // c v = ζ k L
    const double ratio = damping == Damping::strong ? random.decades(0, 1) : random.decades(-1.5, 0.5);
    if (damping != Damping::none && random.chance(0.7))
      chain.law.push_back(contact::Viscoelastic{stiffness, ratio * stiffness * length, exponent});
    else if (exponent == 1)
      chain.law.push_back(contact::Linear{stiffness});
    else
      chain.law.push_back(contact::Hertz{stiffness});
    chain.gap.push_back(random.chance(0.3) ? 0 : random.decades(-2, 0.3) * length);
  }
  return chain;
}

/// The same under gravity, thrown up towards a ceiling; every other one stands on a floor.
inline model::Chain thrown_chain(Counter& random, Damping damping) {
  auto chain = random_chain(random, damping);
  chain.gravity = random.uniform(0.05, 0.5);
  chain.mass.back() = infinity;
  chain.velocity.back() = 0;
  for (std::size_t i = 1; i + 1 < chain.mass.size(); ++i) chain.velocity[i] = random.uniform(-0.5, 0.5);
  chain.gap.back() = random.uniform(0.1, 1);
  if (random.chance(0.5)) {
    chain.mass.front() = infinity;
    chain.velocity.front() = 0;
    for (std::size_t i = 1; i + 1 < chain.mass.size(); ++i) chain.velocity[i] += 0.5;
  }
  return chain;
}

/// One parameter of a chain as a function of −1 ≤ x ≤ 1.
using Knob = std::function<void(model::Chain&, double)>;

inline Knob random_knob(Counter& random, const model::Chain& chain) {
  const std::size_t ball = random.below(chain.mass.size()), contact = random.below(chain.law.size());
  const double span = random.decades(-0.5, 0);
  switch (random.below(3)) {
    case 0:
      if (ball > 0 && !std::isinf(chain.mass[ball]))
        return [=](model::Chain& c, double x) { c.velocity[ball] += 0.5 * span * x; };
      [[fallthrough]];
    case 1:
      if (chain.gap[contact] > 0)
        return [=](model::Chain& c, double x) { c.gap[contact] *= std::pow(10.0, span * x); };
      [[fallthrough]];
    default:
      if (std::isinf(chain.mass[ball])) return random_knob(random, chain);
      return [=](model::Chain& c, double x) { c.mass[ball] *= std::pow(10.0, span * x); };
  }
}

/// −1 ≤ x ≤ 1 at which f is within `close` of `target`, by secants; empty if that leads nowhere. f may be
/// undefined anywhere.
inline std::optional<double> solve(const std::function<std::optional<double>(double)>& f, double target,
                                   double close) {
  double x = 0, before = 0.1;
  auto f_before = f(before);
  for (int k = 0; k < 12 && f_before; ++k) {
    const auto f_x = f(x);
    if (!f_x) return std::nullopt;
    if (std::abs(*f_x - target) <= close) return x;
    const double next = x - (*f_x - target) * (x - before) / (*f_x - *f_before);
    if (!(std::abs(next) <= 1)) return std::nullopt;
    before = std::exchange(x, next);
    f_before = f_x;
  }
  return std::nullopt;
}

/// A turning point of that kind which is not far from grazing, if there is one.
inline std::optional<Probe> near_graze(Counter& random, const model::Chain& chain, Graze graze) {
  if (graze == Graze::ceiling) return Probe{.contact = chain.law.size() - 1, .minimum = false, .stretch = 0};
  std::vector<Probe> found;
  for (auto [probe, value] : Oracle(chain).truth().turns) {
    if (probe.minimum != (graze == Graze::opening) || std::abs(value) > 0.4) continue;
    if (graze == Graze::pressing_again) {
      if (contact::damping(chain.law[probe.contact]) == 0) continue;
      if (value > 0) --probe.stretch;  // it was pressed again, lightly
    }
    if (probe.stretch > 0) found.push_back(probe);
  }
  if (found.empty()) return std::nullopt;
  return found[random.below(found.size())];
}

/// What a scene is to be: the same in every attempt to find it.
inline GrazingScene wanted(Counter random) {
  constexpr double accuracies[] = {1e-6, 1e-8, 1e-10};
  GrazingScene scene;
  const double kind = random.uniform();
  scene.graze = kind < 0.84 ? Graze::opening : kind < 0.87 ? Graze::pressing_again : Graze::ceiling;
  scene.accuracy = accuracies[random.below(3)];
  scene.depth = random.decades(std::log10(10 * scene.accuracy), -2) * (random.chance(0.5) ? 1 : -1);
  scene.until = scene.graze == Graze::ceiling ? random.uniform(3, 6) : infinity;
  return scene;
}

/// Light balls that rattle between heavy ones blow up every error on the way, some by 1e10: where an error of
/// `accuracy` in one incident velocity changes who touches whom, nobody can say at that accuracy. Trying the
/// ends of that range tells only as long as the answer is nearly linear: growth by 1e3 at most.
inline bool is_determined(const GrazingScene& scene) {
  Oracle straight(scene.chain);
  straight.truth(scene.until);
  for (std::size_t ball = 0; ball < scene.chain.mass.size(); ++ball)
    for (const double sign : {1.0, -1.0}) {
      if (std::isinf(scene.chain.mass[ball])) continue;
      auto chain = scene.chain;
      chain.velocity[ball] += sign * scene.accuracy;
      Oracle shifted(chain);
      if (shifted.truth(scene.until).periods != scene.truth.periods) return false;
      for (std::size_t i = 0; i < chain.mass.size(); ++i)
        if (std::abs(shifted.velocity()[i] - straight.velocity()[i]) > 1e3 * scene.accuracy) return false;
    }
  return true;
}

/// One attempt; empty if nothing grazes in the chain drawn, if another decision in it is closer than ten
/// times the accuracy, or if the accuracy leaves the outcome open.
inline std::optional<GrazingScene> attempt(GrazingScene scene, Counter random) {
  const Damping damping = scene.graze == Graze::pressing_again ? Damping::strong
                          : random.chance(0.4)                 ? Damping::usual
                                                               : Damping::none;
  const auto base =
      scene.graze == Graze::ceiling ? thrown_chain(random, damping) : random_chain(random, damping);
  const auto probe = near_graze(random, base, scene.graze);
  if (!probe) return std::nullopt;
  scene.contact = probe->contact;
  const auto knob = random_knob(random, base);
  const auto turned = [&](double x) {
    auto chain = base;
    knob(chain, x);
    return chain;
  };
  const double target = probe->minimum ? -scene.depth : scene.depth;
  const auto x = solve([&](double at) { return Oracle(turned(at)).turning_value(*probe, scene.until); },
                       target, 1e-3 * std::abs(scene.depth));
  if (!x) return std::nullopt;
  scene.chain = turned(*x);
  scene.truth = Oracle(scene.chain).truth(scene.until);
  const bool clear = scene.truth.complete && scene.truth.margin >= 0.998 * 10 * scene.accuracy;
  if (!clear || !is_determined(scene)) return std::nullopt;
  return scene;
}

/// Scene number `index`.
inline GrazingScene grazing_scene(std::uint64_t index) {
  const auto scene = wanted(Counter(index << 20));
  for (std::uint64_t tries = 1;; ++tries)
    if (auto found = attempt(scene, Counter((index << 20) + tries))) return *found;
}

}  // namespace mariotte::test
