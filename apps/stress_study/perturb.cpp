#include <memory>

#include "dice.hpp"
#include "law_numbers.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "natural.hpp"
#include "run.hpp"

namespace mariotte::stress_study {
namespace {

/// Numbers between −size and size.
class Noise {
 public:
  Noise(double size, std::uint64_t direction) : size_(size), dice_(0x70657274, direction) {}
  double operator()() { return size_ * dice_.uniform(-1, 1); }
  void scale(double& value) { value *= 1 + (*this)(); }

 private:
  double size_;
  Dice dice_;
};

/// All indentations by one factor, and all forces by another.
contact::Law disturbed(const CubicCurve& curve, Noise& noise) {
  std::vector<contact::LawPoint> points;
  const double longer = 1 + noise(), stronger = 1 + noise();
  for (const auto& segment : curve) points.push_back({longer * segment.from, stronger * segment.a[0]});
  return contact::SharedLaw(std::make_shared<contact::Tabulated>(std::move(points)));
}

void disturb(contact::Law& law, Noise& noise) {
  if (auto* power = std::get_if<contact::PowerLaw>(&law)) {
    noise.scale(power->stiffness);
    if (power->damping > 0) noise.scale(power->damping);
    return;
  }
  if (const auto* curve = contact::curve(law)) {
    law = disturbed(*curve, noise);
    return;
  }
  law = with_numbers(law, [&](std::string_view key, double& value) {
    if (key != "exponent") noise.scale(value);
  });
}

void disturb_contact(contact::Law& law, double& gap, double inverse_mass, double speed, Noise& noise) {
  const double moved = gap + noise() * (std::abs(gap) + natural_depth(law, inverse_mass, speed));
  gap = gap < 0 ? moved : std::max(0.0, moved);
  disturb(law, noise);
}

void disturb(model::Chain& chain, double speed, Noise& noise) {
  for (double& mass : chain.mass) noise.scale(mass);
  for (std::size_t i = 0; i < chain.velocity.size(); ++i)
    if (std::isfinite(chain.mass[i]) || chain.velocity[i] != 0) chain.velocity[i] += speed * noise();
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    disturb_contact(chain.law[j], chain.gap[j], 1 / chain.mass[j] + 1 / chain.mass[j + 1], speed, noise);
  noise.scale(chain.gravity);
}

void disturb(model::Network& network, double, Noise& noise) {
  const double speed = reference_speed(network);
  const auto response = model::responses(network.mass, network.direction, std::ssize(network.velocity));
  for (double& v : network.velocity) noise.scale(v);
  for (std::size_t j = 0; j < network.law.size(); ++j)
    disturb_contact(network.law[j], network.gap[j], dot(network.direction[j], response[j]), speed, noise);
}

void disturb(Body& scene, double speed, Noise& noise) {
  auto& body = scene.body;
  for (double* v : {&body.velocity.e1, &body.velocity.e2, &body.velocity.e3}) noise.scale(*v);
  for (double* w : {&body.spin.e1, &body.spin.e2, &body.spin.e3}) noise.scale(*w);
  for (double* part : {&body.attitude.w, &body.attitude.x, &body.attitude.y, &body.attitude.z})
    noise.scale(*part);
  body.attitude = normalized(body.attitude);
  for (auto& law : body.law)
    for (double* number : {&law.stiffness, &law.adhesion, &law.damping_hertz, &law.damping_adhesion})
      noise.scale(*number);
  noise.scale(body.friction.coefficient);
  (void)speed;
}

void disturb(Group& scene, double speed, Noise& noise) {
  for (auto& body : scene.bodies.body) {
    const double change = 1 + noise();
    body.mass *= change;
    body.inertia = change * body.inertia;
    for (Vector3* part : {&body.velocity, &body.spin})
      for (double* v : {&part->e1, &part->e2, &part->e3}) noise.scale(*v);
    if (body.spheres.size() > 1) body.angle += noise();
  }
  for (auto& contact : scene.bodies.contact) {
    disturb(contact.law, noise);
    noise.scale(contact.tangential.friction);
    noise.scale(contact.tangential.stiffness);
  }
  (void)speed;
}

}  // namespace

Scene perturbed(const Scene& scene, double size, std::uint64_t direction) {
  auto other = scene;
  Noise noise(size, direction);
  const double speed = reference_speed(scene.model);
  std::visit([&](auto& model) { disturb(model, speed, noise); }, other.model);
  return other;
}

}  // namespace mariotte::stress_study
