#include "mariotte/study/sensitivity/model_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "mariotte/core/overload.hpp"

namespace mariotte::study {
namespace {

constexpr double place_rounding = 64 * epsilon;  ///< of differences of places, and of parts of directions

class Numbers {
 public:
  void add(double value, double rounding_of_it = 0) { all_.push_back({value, rounding_of_it}); }
  void add(const std::vector<double>& list) {
    for (const double one : list) add(one);
  }
  void add(const Vector3& vector) {
    for (const double one : {vector.e1, vector.e2, vector.e3}) add(one);
  }
  /// Parts of a direction or an attitude, and cosine and sine of an angle.
  void add_direction(std::initializer_list<double> parts) {
    for (const double one : parts) add(one, place_rounding);
  }
  /// Forces of powers are compared at small depths, where they change most with the exponent.
  void add(const contact::Law& law) {
    constexpr double small = 1e-9;
    for (const auto& one : contact::parameters(law)) {
      add(one.value);
      if (one.key == "exponent") add(std::pow(small, one.value));
    }
  }
  void add(const std::vector<contact::Law>& laws) {
    for (const auto& law : laws) add(law);
  }
  std::vector<ModelNumber> take() { return std::move(all_); }

 private:
  std::vector<ModelNumber> all_;
};

void add(const model::Chain& chain, Numbers& all) {
  for (const auto* list : {&chain.mass, &chain.velocity, &chain.gap}) all.add(*list);
  all.add(chain.law);
  all.add(chain.gravity);
}

void add(const model::Network& network, Numbers& all) {
  for (const auto* list : {&network.mass, &network.velocity}) all.add(*list);
  for (std::size_t j = 0; j < network.gap.size(); ++j)
    all.add(network.gap[j], network.distance.empty() ? 0 : place_rounding * network.distance[j]);
  all.add(network.law);
  for (const auto& direction : network.direction)
    for (const auto& [dof, coefficient] : direction) {
      all.add(static_cast<double>(dof));
      all.add(coefficient, place_rounding);
    }
}

void add(const Quaternion& attitude, Numbers& all) {
  all.add_direction({attitude.w, attitude.x, attitude.y, attitude.z});
}

void add(const model::Microbody& body, Numbers& all) {
  all.add(body.body.mass);
  for (const auto& vector : {body.body.inertia, body.velocity, body.spin}) all.add(vector);
  for (const auto& tip : body.body.tips) all.add(tip.centre), all.add(tip.radius);
  for (const auto& law : body.law)
    for (const double one : {law.stiffness, law.adhesion, law.damping_hertz, law.damping_adhesion})
      all.add(one);
  add(body.attitude, all);
  all.add(body.friction.coefficient);
  all.add(body.gravity);
}

void add(const model::Bodies& bodies, Numbers& all) {
  for (const auto& one : bodies.body) {
    all.add(one.mass);
    for (const auto& vector : {one.inertia, one.position, one.velocity, one.spin}) all.add(vector);
    for (const auto& sphere : one.spheres) all.add(sphere.centre), all.add(sphere.radius);
    add(one.attitude, all);
    all.add_direction({std::cos(one.angle), std::sin(one.angle)});
  }
  for (const auto& one : bodies.plane) {
    all.add_direction({one.normal.e1, one.normal.e2, one.normal.e3});
    for (const auto& vector : {one.point, one.velocity}) all.add(vector);
  }
  all.add(bodies.gravity);
  for (const auto& contact : bodies.contact) {
    all.add(contact.law);
    all.add(contact.tangential.friction);
    all.add(contact.tangential.stiffness);
    all.add(contact.share);
  }
}

/// Second differences that rounding alone can make, relative to the number, beside its own.
constexpr double noise = 1e-11, times_rounding = 2e4;
/// How many times larger they are at ten times the distance. Of pᵐ with a step of h p they are (m h)²·4/3
/// more than a hundred times as large, and the stencil is off by (m h)⁸/630.
constexpr double least_growth = 98, most_growth = 102;

bool is_smooth(const ModelNumber (&x)[5]) {
  const double middle = x[2].value, near = std::abs(x[1].value - 2 * middle + x[3].value),
               far = std::abs(x[0].value - 2 * middle + x[4].value);
  if (!std::isfinite(far)) return std::isinf(middle) && x[0].value == middle && x[4].value == middle;
  const double most = std::max(std::abs(x[0].value), std::abs(x[4].value)),
               harmless = noise * most + times_rounding * x[2].rounding;
  return far <= harmless || (far >= least_growth * near && far <= most_growth * near);
}

}  // namespace

std::vector<ModelNumber> model_numbers(const scene::Scene& scene) {
  Numbers all;
  std::visit(Overload{[&](const auto& model) { add(model, all); }, [](const scene::LawAlone&) {}},
             scene.model);
  return all.take();
}

bool is_smooth(const std::vector<ModelNumber> (&at)[5]) {
  for (const auto& one : at)
    if (one.size() != at[0].size()) return false;
  for (std::size_t i = 0; i < at[0].size(); ++i)
    if (!is_smooth({at[0][i], at[1][i], at[2][i], at[3][i], at[4][i]})) return false;
  return true;
}

}  // namespace mariotte::study
