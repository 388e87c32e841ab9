#include "examine.hpp"

#include <algorithm>
#include <map>

#include "measuring/timing.hpp"
#include "rivals.hpp"
#include "slopes.hpp"

namespace mariotte::stress_study {
namespace {

/// In one period a contact turns, sticks, slips and slips back; one that adheres goes slack, loads and grips.
constexpr double events_with_friction = 8;

/// What the naive simulator is good to, and the steps it may take: many on a share of the scenes only.
constexpr const char* naive_name = "naive simulator";
constexpr double naive_accuracy = 1e-7, naive_accuracy_with_friction = 1e-3;
constexpr test::Effort quick{.tolerance = 1e-10, .share = 0.3, .most_steps = 4000},
    patient{.tolerance = 1e-10, .share = 0.3, .most_steps = 200000},
    careful{.tolerance = 1e-12, .share = 0.1, .most_steps = 1000000, .smoothing = 1e-4};
/// Evaluations of `auto` at the first accuracy, beyond which a brisk campaign leaves a scene out.
constexpr Index most_brisk_work = 200;
constexpr std::uint64_t share_with_many_steps = 50, share_with_general_flow = 10;

/// Whether bodies fly on as they are where nothing touches any more.
bool flies_freely(const model::Chain& chain) {
  return chain.gravity == 0 && chain.drive.empty();
}
bool flies_freely(const model::Network& network) {
  return network.drive.empty();
}
bool flies_freely(const Body&) {
  return false;  // its other tip may come down
}
bool flies_freely(const Group& scene) {
  return norm(scene.bodies.gravity) == 0;
}

/// Perturbations to measure amplification by; those of one size are measured once.
class Perturbations {
 public:
  Perturbations(const Scene& scene, std::string general, const Announce& announce)
      : scene_(scene), general_(std::move(general)), announce_(announce) {}

  /// The smaller of what the automatic choice and, where it is quick, the general flow say: a result that is
  /// wrong by itself must not excuse itself.
  Sensitivity operator()(double size, double enough) {
    if (const auto known = known_.find({size, enough}); known != known_.end()) return known->second;
    auto least = measured({"auto", tight}, size, enough);
    if (!general_.empty() && (least.amplification >= enough || enough == infinity))
      if (const Method method{general_, 1e-11}; plain(method).work < most_work) {
        const auto other = measured(method, size, enough);
        least.amplification = std::min(least.amplification, other.amplification);
        least.counts_change |= other.counts_change;
      }
    return known_[{size, enough}] = least;
  }

 private:
  static constexpr Index most_work = 5000;
  static constexpr std::uint64_t many_directions = 6, few_directions = 2;

  /// The run of the scene as it is.
  const Found& plain(const Method& method) {
    auto [place, is_new] = plain_.try_emplace(method.flow);
    if (is_new) place->second = timed(scene_, method);
    return place->second;
  }
  Sensitivity measured(const Method& method, double size, double enough) {
    const auto& before = plain(method);
    if (!has_ended(before)) return {.amplification = infinity};
    Sensitivity result;
    const auto directions = before.work < most_work ? many_directions : few_directions;
    for (std::uint64_t direction = 0; direction < directions && result.amplification < enough; ++direction) {
      const auto after = timed(perturbed(scene_, size, direction), method);
      if (!has_ended(after)) continue;
      result.amplification = std::max(result.amplification, distance(before, after) / size);
      result.counts_change |= after.periods != before.periods;
    }
    return result;
  }
  Found timed(const Scene& scene, const Method& method) {
    announce_(name(method) + perturbed_mark);
    return run(scene, method);
  }

  const Scene& scene_;
  std::string general_;
  const Announce& announce_;
  std::map<std::pair<double, double>, Sensitivity> known_;  ///< by size and what was enough
  std::map<std::string, Found> plain_;
};

class Examination {
 public:
  Examination(const Scene& scene, std::uint64_t number, const Announce& announce, const Extent& extent)
      : scene_(scene), number_(number), announce_(announce), extent_(extent) {}

  Verdict verdict() {
    for (const double accuracy : asked_) {
      add({.flow = "auto", .accuracy = accuracy, .balances = accuracy == asked_.back()}, accuracy);
      if (extent_.brisk && trials_.front().found.work > most_brisk_work) return left_out(number_);
    }
    best_ = trial({.flow = "auto", .accuracy = tight}, tight);
    general_ = general_flows(scene_, best_.found.time);
    if (!extent_.spare && !extent_.brisk) add_other_flow();
    add_naive();
    Perturbations perturbations(scene_, extent_.spare || general_.empty() ? "" : general_.front(), announce_);
    const auto judgement = judge(best_, trials_, std::ref(perturbations));
    return described(judgement);
  }

 private:
  /// Whether the load of a contact that creeps, ζ⁻³ of its natural force, is above such an error: else its
  /// sign, and how often it opens, are chance.
  bool loads_are_certain(double error) const { return std::pow(damping_group_, 3) * error < 1e-2; }

  Trial trial(const Method& method, double accuracy) {
    announce_(name(method));
    auto found = run(scene_, method);
    const double each = std::holds_alternative<Group>(scene_.model) ? events_with_friction : 1;
    const bool has_time = each * most_contacts(scene_, found.time) > most_events;
    return {.name = name(method),
            .accuracy = accuracy,
            .found = std::move(found),
            .many_events = has_time || !loads_are_certain(epsilon)};
  }
  void add(const Method& method, double accuracy) {
    trials_.push_back(trial(method, accuracy));
    trials_.back().counts = accuracy == asked_.back() && loads_are_certain(accuracy);
  }

  void add_other_flow() {
    auto flows = special_flows(scene_, best_.found.time);
    const bool general = number_ % share_with_general_flow == 0 && !general_.empty();
    if (general) flows = general_;
    if (flows.empty()) return;
    add({.flow = flows[number_ / share_with_general_flow % flows.size()], .accuracy = asked_.back()},
        asked_.back());
    trials_.back().rival = true;
  }

  /// The naive simulator has impacts at other times, after a long flight much later: it follows for longer
  /// where nothing comes after.
  double naive_end() const {
    constexpr double longer = 1.05;
    const bool flies_on = best_.found.ending == hybrid::Ending::separated &&
                          std::visit([](const auto& model) { return flies_freely(model); }, scene_.model);
    return (flies_on ? longer : 1) * best_.found.time;
  }

  void add_naive() {
    if (!has_ended(best_.found)) return;
    announce_(naive_name);
    const double end = naive_end();
    const auto found = run_naively(scene_, end, number_ % share_with_many_steps == 0 ? patient : quick);
    if (!found) return;
    const auto* body = std::get_if<Body>(&scene_.model);
    const bool rough =
        std::holds_alternative<Group>(scene_.model) || (body && body->body.friction.coefficient > 0);
    Trial trial{.name = naive_name,
                .accuracy = rough ? naive_accuracy_with_friction : naive_accuracy,
                .found = *found};
    if (distance(*found, best_.found) > tolerated * trial.accuracy) {
      const auto again = run_naively(scene_, end, careful);  // its own error tells what it may be off by
      if (!again) return;
      trial.accuracy = std::max(naive_accuracy, distance(*found, *again));
      trial.found = *again;
    }
    trial.found.ending = best_.found.ending;  // it knows of none
    trials_.push_back(std::move(trial));
  }

  Verdict described(const Judgement& judgement) const {
    Verdict verdict{.scene = number_,
                    .worst = judgement.worst,
                    .seconds = trials_[asked_.size() - 1].found.seconds,
                    .naive = trials_.back().name == naive_name,
                    .counts_differ = judgement.counts_differ,
                    .failures = judgement.failures,
                    .limits = judgement.limits,
                    .refusals = judgement.refusals,
                    .rivals = judgement.rivals + extent_.spare,
                    .findings = judgement.findings};
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const bool known = has_ended(best_.found) && has_ended(trials_[i].found);
      verdict.error[i] = known ? distance(best_.found, trials_[i].found) / asked_[i] : -1;
    }
    return verdict;
  }

  const Scene& scene_;
  std::uint64_t number_;
  const Announce& announce_;
  Extent extent_;
  const std::array<double, accuracies.size()> asked_ = accuracies_of(number_);
  std::vector<Trial> trials_;
  Trial best_;
  std::vector<std::string> general_;
  double damping_group_ = damping_group(scene_.model);
};

}  // namespace

std::array<double, accuracies.size()> accuracies_of(std::uint64_t scene) {
  constexpr double golden = 0.618033988749894848;  // its multiples fill an interval evenly
  const double turns = golden * static_cast<double>(scene), share = std::pow(10, std::floor(turns) - turns);
  auto all = accuracies;
  for (double& accuracy : all) accuracy *= share;
  return all;
}

Verdict examine(const std::vector<Family>& list, std::uint64_t seed, std::uint64_t number,
                const Announce& announce, const Extent& extent) {
  announce("drawing");
  const double start = measuring::cpu_seconds();
  const auto scene = scene_of(list, seed, number);
  auto verdict =
      list[family_of(list, number)].slopes
          ? examine_slopes(slope_subject(scene, Dice(~seed, number)), number, announce, extent.brisk)
          : Examination(scene, number, announce, extent).verdict();
  verdict.cost = measuring::cpu_seconds() - start;
  return verdict;
}

}  // namespace mariotte::stress_study
