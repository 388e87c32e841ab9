#include "rivals.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/overload.hpp"
#include "natural.hpp"

namespace mariotte::stress_study {
namespace {

struct Contact {
  contact::Law law;
  double mobility;
};

std::vector<Contact> contacts_of(const model::Chain& chain) {
  std::vector<Contact> list;
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    list.push_back({chain.law[j], 1 / chain.mass[j] + 1 / chain.mass[j + 1]});
  return list;
}
std::vector<Contact> contacts_of(const model::Network& network) {
  const auto response = model::responses(network.mass, network.direction, std::ssize(network.velocity));
  std::vector<Contact> list;
  for (std::size_t j = 0; j < network.law.size(); ++j)
    list.push_back({network.law[j], dot(network.direction[j], response[j])});
  return list;
}
std::vector<Contact> contacts_of(const Body&) {
  return {};
}

std::vector<Contact> contacts_of(const Group& scene) {
  std::vector<Contact> list;
  for (const auto& contact : scene.bodies.contact) {
    const auto mobility = [&](const model::Feature& one) {
      return one.is_plane() ? 0 : 1 / scene.bodies.body[static_cast<std::size_t>(one.owner)].mass;
    };
    list.push_back({contact.law, mobility(contact.a) + mobility(contact.b)});
  }
  return list;
}

std::vector<Contact> contacts_of(const Model& model) {
  return std::visit([](const auto& one) { return contacts_of(one); }, model);
}

/// In natural times: beyond this, general flows need more steps than patience allows. Where damping is
/// strong, BDF takes over from Adams.
constexpr double longest = 300, stiff = 5;
/// Phases that closed forms and modes do not admit go to a general flow: contacts × natural times that it may
/// take. Explicit series creep where damping is stronger than this.
constexpr double most_work = 1000, creeping = 100;

}  // namespace

double damping_group(const Model& model) {
  const double speed = reference_speed(model);
  double most = 0;
  for (const auto& [law, mobility] : contacts_of(model))
    if (const auto* power = contact::power_law(law); power && mobility > 0)
      most = std::max(most, power->damping / power->stiffness / natural_time(law, mobility, speed));
  return most;
}

double stiffness(const Scene& scene, double end) {
  const double speed = reference_speed(scene.model);
  double most = 1;
  for (const auto& one : contacts_of(scene.model))
    if (one.mobility > 0) most = std::max(most, end / natural_time(one.law, one.mobility, speed));
  return most;
}

double most_contacts(const Scene& scene, double time) {
  const double speed = reference_speed(scene.model);
  double sum = 0;
  for (const auto& one : contacts_of(scene.model))
    if (one.mobility > 0) sum += time / natural_time(one.law, one.mobility, speed);
  return sum;
}

std::vector<std::string> general_flows(const Scene& scene, double end) {
  if (std::holds_alternative<Body>(scene.model)) return {"cvode-adams", "cvode-bdf-dense"};
  if (stiffness(scene, end) > longest) return {};
  if (damping_group(scene.model) > stiff) return {"cvode-bdf-klu", "cvode-bdf-dense"};
  return {"cvode-adams", "cvode-bdf-klu"};
}

std::vector<std::string> special_flows(const Scene& scene, double end) {
  using Names = std::vector<std::string>;
  const auto is_quick = [&] {
    const auto contacts = static_cast<double>(contacts_of(scene.model).size());
    return contacts * stiffness(scene, end) < most_work;
  };
  return std::visit(Overload{[&](const model::Chain&) {
                               Names flows;
                               if (is_quick()) flows = {"modal", "pair"};
                               if (damping_group(scene.model) < creeping) flows.push_back("taylor");
                               return flows;
                             },
                             [&](const model::Network&) { return is_quick() ? Names{"modal"} : Names{}; },
                             [](const Body&) { return Names{"taylor"}; },
                             [](const Group&) { return Names{"cvode-adams"}; }},
                    scene.model);
}

}  // namespace mariotte::stress_study
