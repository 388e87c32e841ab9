#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/promise.hpp"

namespace mariotte::python {
namespace {

std::vector<Index> all(Index count) {
  std::vector<Index> places(static_cast<std::size_t>(count));
  std::iota(places.begin(), places.end(), 0);
  return places;
}

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void add(const impact::Sample& sample, double time, Samples& samples) {
  samples.time.push_back(time);
  append(samples.velocity, sample.velocity);
  append(samples.gap, sample.gap);
  append(samples.force, sample.force);
}

/// The contacts of a result among those that a run samples.
std::vector<Index> contacts_of(const scene::Impact& impact, Index sampled) {
  const auto* bodies = std::get_if<impact::BodiesImpact>(&impact);
  if (!bodies) return all(sampled);
  std::vector<Index> some;
  for (const auto& one : bodies->contacts) some.push_back(one.contact);
  return some;
}

Samples with_shape(const Impact& impact) {
  Samples samples;
  std::visit(Overload{[&](const model::Microbody& body) {
                        samples.velocities = 3;
                        samples.contacts = body.impacts == 1 ? 1 : std::ssize(body.body.tips);
                      },
                      [&](const model::Bodies& bodies) {
                        samples.velocities = bodies.dimension * std::ssize(bodies.body);
                        samples.contacts =
                            std::ssize(std::get<impact::BodiesImpact>(impact.whole()).contacts);
                      },
                      [&](const scene::LawAlone&) {},
                      [&](const auto& model) {
                        samples.velocities = std::ssize(model.velocity);
                        samples.contacts = std::ssize(model.gap);
                      }},
             impact.box().scene.model);
  return samples;
}

void add(const impact::Trace& trace, Samples& samples) {
  samples.time = trace.time;
  for (std::size_t row = 0; row < trace.time.size(); ++row) {
    append(samples.velocity, trace.velocity[row]);
    append(samples.gap, trace.gap[row]);
    append(samples.force, trace.force[row]);
  }
}

void add(const impact::BodyTrace& trace, Samples& samples) {
  for (std::size_t row = 0; row < trace.state.size(); ++row) {
    const auto& v = trace.state[row].velocity;
    samples.time.push_back(trace.state[row].time);
    append(samples.velocity, {v.e1, v.e2, v.e3});
    append(samples.gap, trace.gap[row]);
    append(samples.force, trace.normal_force[row]);
  }
  if (!trace.gap.empty()) samples.contacts = std::ssize(trace.gap.front());
}

/// All components of all velocities.
std::vector<double> velocities(const std::vector<impact::BodyEnd>& bodies, int dimension) {
  std::vector<double> all;
  for (const auto& body : bodies) {
    append(all, {body.velocity.e1, body.velocity.e2});
    if (dimension == 3) all.push_back(body.velocity.e3);
  }
  return all;
}

/// Puts samples where they were asked for; the first comes at the start, the last at the ending.
struct Taker {
  const std::vector<double>& times;
  Samples& samples;
  impact::Sample last = {};

  bool done() const { return samples.time.size() == times.size(); }
  double next() const { return times[samples.time.size()]; }
  double operator()(const impact::Sample& sample) {
    last = sample;
    while (!done() && next() <= sample.time * (1 + 4 * epsilon)) add(sample, next(), samples);
    return done() ? infinity : next() - sample.time;
  }
  /// The run may end a rounding before the impact did.
  void finish() {
    while (!done()) add(last, next(), samples);
  }
};

std::vector<double> velocity_at_end(const scene::Impact& impact) {
  return std::visit(
      Overload{[](const impact::MicrobodyImpact& one) {
                 const auto& v = one.final.velocity;
                 return std::vector{v.e1, v.e2, v.e3};
               },
               [](const impact::BodiesImpact& one) { return velocities(one.body, one.dimension); },
               [](const auto& one) { return one.velocity; }},
      impact);
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

Samples sample(const Impact& impact, const std::vector<double>& times) {
  const auto& box = impact.box();
  const auto expected = velocity_at_end(impact.whole());
  auto options = impact.options();
  const double asked = options.accuracy, speed = largest(expected);
  for (;;) {
    Samples samples = with_shape(impact);
    Taker taker{.times = times, .samples = samples};
    const impact::Sampling sampling{.velocities = all(samples.velocities),
                                    .contacts = contacts_of(impact.whole(), samples.contacts),
                                    .take = std::ref(taker),
                                    .restart = [&] { samples = with_shape(impact); }};
    simulate(box, options, {.samplings = {sampling}});
    taker.finish();
    const double apart = impact::difference(expected, taker.last.velocity, speed);
    if (apart <= 2 * asked || options.accuracy <= 16 * epsilon) return samples;
    options.accuracy = std::max(1e-2 * options.accuracy, 16 * epsilon);
  }
}

Samples steps(const Impact& impact) {
  Samples samples = with_shape(impact);
  const auto traced = simulate(impact.box(), impact.options(), {.trace = true});
  std::visit(Overload{[&](const impact::BodiesImpact& one) { add(contact_trace(one), samples); },
                      [&](const auto& one) { add(one.trace, samples); }},
             traced);
  return samples;
}

}  // namespace mariotte::python
