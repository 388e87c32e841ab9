#include "slope_subject.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "group_units.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/study/sensitivity/scene_numbers.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "natural.hpp"
#include "run.hpp"

namespace mariotte::stress_study {
namespace {

constexpr std::size_t most_probes = 3;
constexpr double best_accuracy = 1e-12;  ///< of which slopes ask for a hundredth

hybrid::Options options_for(double max_time, double accuracy) {
  return {.accuracy = accuracy, .max_time = max_time, .max_events = most_events};
}

/// "gap[3]" is number 3 of the gaps.
bool is_element(const std::string& name, const char* list) {
  return name.starts_with(list) && name[std::char_traits<char>::length(list)] == '[';
}
std::size_t index_of(const std::string& name) {
  return static_cast<std::size_t>(std::stoul(name.substr(name.find('[') + 1)));
}

double mobility(const model::Chain& chain, std::size_t j) {
  return 1 / chain.mass[j] + 1 / chain.mass[j + 1];
}
double mobility(const model::Network& network, std::size_t j) {
  return dot(network.direction[j],
             model::responses(network.mass, network.direction, std::ssize(network.velocity))[j]);
}

bool moves(const model::Chain&, std::size_t j, std::size_t i) {
  return i == j || i == j + 1;
}
bool moves(const model::Network& network, std::size_t j, std::size_t i) {
  const auto& direction = network.direction[j];
  return std::any_of(direction.begin(), direction.end(), [&](const auto& term) {
    return static_cast<std::size_t>(term.dof) == i && term.coefficient != 0;
  });
}
double approach(const model::Chain& chain, std::size_t j) {
  return chain.velocity[j] - chain.velocity[j + 1];
}
double approach(const model::Network& network, std::size_t j) {
  return -gap_rate(network.direction[j], network.velocity);
}

/// Whether a velocity opens or closes a contact that touches at rest.
template <class Model>
bool decides_a_touch(const Model& model, std::size_t i) {
  for (std::size_t j = 0; j < model.law.size(); ++j)
    if (model.gap[j] == 0 && approach(model, j) == 0 && moves(model, j, i)) return true;
  return false;
}

using stress_study::longest_step, stress_study::unit_of;  // of bodies

/// By how much a number moves results; nothing for one that can move only one way.
template <class Model>
std::optional<double> unit_of(const Model& model, const impact::Parameter<Model>& one, double speed) {
  if (is_element(one.name, "velocity")) {
    if (decides_a_touch(model, index_of(one.name))) return std::nullopt;
    return speed;
  }
  if (!is_element(one.name, "gap")) return one.name.ends_with("exponent") ? 1 : std::abs(one.value);
  const auto j = index_of(one.name);
  if (one.value == 0) return std::nullopt;
  const double depth = natural_depth(model.law[j], mobility(model, j), speed);
  return depth > 0 ? depth : std::abs(one.value);
}

/// Stencils reach four times as far, and a gap must not close.
template <class Model>
double longest_step(const Model&, const impact::Parameter<Model>& one, double unit) {
  const double step = std::min(one.step, 0.01 * unit);
  return is_element(one.name, "gap") ? std::min(step, 0.1 * std::abs(one.value)) : step;
}

/// So many of a list, in its order.
template <class T>
std::vector<T> some_of(std::vector<T> list, Dice& dice) {
  while (list.size() > most_probes)
    list.erase(list.begin() + dice.whole(0, static_cast<int>(list.size()) - 1));
  return list;
}

/// The parameters of another model that have the names of these.
template <class Model>
std::vector<impact::Parameter<Model>> named_as(const std::vector<impact::Parameter<Model>>& list,
                                               const Model& model) {
  auto all = impact::parameters(model);
  std::erase_if(all, [&](const auto& one) {
    return std::none_of(list.begin(), list.end(), [&](const auto& own) { return own.name == one.name; });
  });
  return all;
}

template <class Model>
SlopeSubject subject_of(const Model& model, double speed, double max_time, Dice& dice) {
  SlopeSubject subject{.speed = speed};
  std::vector<impact::Parameter<Model>> all;
  for (auto& one : impact::parameters(model))
    if (const auto unit = unit_of(model, one, speed)) {
      all.push_back(std::move(one));
      subject.all_units.push_back(*unit);
    }
  subject.all_slopes = [=] { return impact::sensitivity(model, all, options_for(max_time, best_accuracy)); };
  const auto by = some_of(all, dice);
  const auto slopes_of = [by, max_time](const Model& moved, double accuracy) {
    const std::vector<impact::Parameter<Model>> list = named_as(by, moved);
    return impact::sensitivity(moved, list, options_for(max_time, accuracy));
  };
  for (const auto& one : by) {
    const double unit = *unit_of(model, one, speed);
    subject.probes.push_back(
        {one.name, one.value, unit, longest_step(model, one, unit),
         [one, max_time](double value) {
           const std::vector<impact::Parameter<Model>> none;
           return impact::sensitivity(one.model(value), none, options_for(max_time, best_accuracy));
         },
         [one, slopes_of](double value) { return slopes_of(one.model(value), best_accuracy); }});
  }
  subject.slopes = [model, slopes_of](double accuracy) { return slopes_of(model, accuracy); };
  return subject;
}

constexpr std::array keys_of_bodies = {"body.radius",
                                       "body.density",
                                       "body.length_ratio",
                                       "surface.stiffness",
                                       "surface.work_of_adhesion",
                                       "surface.zeta_hertz",
                                       "surface.zeta_adhesion",
                                       "surface.damping_hertz",
                                       "surface.friction",
                                       "incidence.normal_speed",
                                       "incidence.tangential_velocity[0]",
                                       "incidence.tangential_velocity[1]",
                                       "incidence.angles[1]",
                                       "incidence.spin[1]",
                                       "incidence.spin[2]"};

impact::Sensitivity slopes_of(const std::string& text, const scene::Overrides& overrides, double accuracy,
                              const std::vector<std::string>& keys) {
  const auto document = scene::parse_document(text, "stress", overrides);
  auto scene = resolve(document);
  scene.run = options_for(infinity, accuracy);
  return keys.empty() ? study::outcomes(scene) : study::sensitivity(document, scene, keys);
}

scene::Overrides moved_to(const std::string& key, double value) {
  return {key + "=" + report::exact(value)};
}

/// The number that a text gives a key, if it is not zero and can move both ways as far as slopes ask.
std::optional<double> value_of(const std::string& text, const std::string& key) {
  try {
    const double value = study::expect_number(scene::parse_document(text, "stress"), key).value;
    if (value == 0) return std::nullopt;
    for (const double share : {0.96, 1.04})
      resolve(scene::parse_document(text, "stress", moved_to(key, share * value)));
    return value;
  } catch (const scene::SceneError&) {
    return std::nullopt;
  }
}

SlopeSubject subject(const Body& body, double, Dice& dice) {
  SlopeSubject subject{.speed = reference_speed(body)};
  const auto& text = body.text;
  for (const std::string key : keys_of_bodies)
    if (const auto value = value_of(text, key))
      subject.probes.push_back({key, *value, std::abs(*value), 0.002 * std::abs(*value)});
  subject.probes = some_of(std::move(subject.probes), dice);
  std::vector<std::string> keys;
  for (const auto& one : subject.probes) keys.push_back(one.name);
  for (auto& one : subject.probes) {
    one.outcomes = [=, key = one.name](double value) {
      return slopes_of(text, moved_to(key, value), best_accuracy, {});
    };
    one.slopes = [=, key = one.name](double value) {
      return slopes_of(text, moved_to(key, value), best_accuracy, keys);
    };
  }
  subject.slopes = [text, keys](double accuracy) { return slopes_of(text, {}, accuracy, keys); };
  return subject;
}

double largest_reach(const model::Bodies& bodies) {
  double most = 0;
  for (const auto& body : bodies.body)
    for (const auto& sphere : body.spheres) most = std::max(most, norm(sphere.centre) + sphere.radius);
  return most;
}

SlopeSubject subject(const Group& group, double max_time, Dice& dice) {
  auto subject = subject_of(group.bodies, reference_speed(group), max_time, dice);
  const auto lightest = std::min_element(group.bodies.body.begin(), group.bodies.body.end(),
                                         [](const auto& a, const auto& b) { return a.mass < b.mass; });
  subject.impulse = lightest->mass * subject.speed;
  subject.spin = subject.speed / largest_reach(group.bodies);
  return subject;
}

/// Of a chain or a network: what moves by the least push in a contact.
template <class Model>
SlopeSubject subject(const Model& model, double max_time, Dice& dice) {
  auto subject = subject_of(model, reference_speed(model), max_time, dice);
  double most = 0;
  for (std::size_t j = 0; j < model.law.size(); ++j) most = std::max(most, mobility(model, j));
  if (most > 0) subject.impulse = subject.speed / most;
  return subject;
}

}  // namespace

SlopeSubject slope_subject(const Scene& scene, Dice dice) {
  return std::visit([&](const auto& model) { return subject(model, scene.max_time, dice); }, scene.model);
}

}  // namespace mariotte::stress_study
