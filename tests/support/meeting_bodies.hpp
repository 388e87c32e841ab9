// Random scenes of bodies that meet, with any friction.
#pragma once
#include <cmath>
#include <memory>
#include <random>

#include "mariotte/contact/brach_dunn_law.hpp"
#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/model/bodies/bodies.hpp"

namespace support {

namespace contact = mariotte::contact;
namespace model = mariotte::model;
using mariotte::Index;
using mariotte::Vector3;
using model::TangentialLaw;

class Scenes {
 public:
  /// `branched`: contacts yield or adhere.
  explicit Scenes(unsigned seed, bool branched = false) : random_(seed), branched_(branched) {}

  /// Three balls or rods that meet one after the other, with any friction.
  model::Bodies next(int dimension) {
    model::Bodies bodies{.dimension = dimension};
    for (int i = 0; i < 3; ++i) bodies.body.push_back(body(i, dimension));
    for (Index a = 0; a < 3; ++a)
      for (Index b = a + 1; b < 3; ++b) join(a, b, bodies);
    return bodies;
  }
  /// A ball falls on three that lie on a plane, touching each other or nearly so.
  model::Bodies heap() {
    model::Bodies bodies{.dimension = 2};
    constexpr double radius = 0.01;
    const double apart = 2 * radius * (in(0, 1) < 0.5 ? 1 : 1 + 1e-4 * in(0, 1));
    for (int i = 0; i < 4; ++i) {
      bodies.body.push_back(body(i, 2));
      bodies.body.back().spheres = {{{}, radius}};
      bodies.body.back().position = {apart * i, radius, 0};
      bodies.body.back().velocity = bodies.body.back().spin = {};
    }
    bodies.body[3].position = {apart * in(0.2, 1.8), 3.2 * radius, 0};
    bodies.body[3].velocity = {in(-1, 1), -1, 0};
    bodies.body[3].spin = {0, 0, in(-60, 60)};
    bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}}};
    for (Index b = 0; b < 4; ++b) {
      bodies.contact.push_back({.a = {0, -1}, .b = {b, 0}, .touching = b < 3});
      for (Index a = 0; a < b; ++a)
        bodies.contact.push_back(
            {.a = {a, 0}, .b = {b, 0}, .touching = b < 3 && b == a + 1 && apart == 2 * radius});
    }
    for (auto& contact : bodies.contact) {
      contact.law = in(0, 1) < 0.3 ? contact::Law(contact::Linear(1e6)) : contact::Law(contact::Hertz(1e9));
      do contact.tangential = tangential();
      while (contact.tangential.law == TangentialLaw::rigid ||
             (contact.tangential.law == TangentialLaw::mindlin &&
              contact::power_law(contact.law)->exponent == 1));
    }
    return bodies;
  }
  double in(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

 private:
  Vector3 vector(double size, int dimension) {
    return {in(-size, size), in(-size, size), dimension == 3 ? in(-size, size) : 0};
  }
  model::Body body(int i, int dimension) {
    constexpr double radius = 0.01, mass = 0.03;
    const bool rod = in(0, 1) < 0.3;
    const double moment = (rod ? 2 : 0.4) * mass * radius * radius;
    model::Body one{.name = "", .mass = mass, .inertia = {moment, moment, moment}};
    one.spheres = rod ? std::vector<model::BodySphere>{{{0.008, 0, 0}, radius}, {{-0.008, 0, 0}, radius}}
                      : std::vector<model::BodySphere>{{{}, radius}};
    one.position = {0.045 * i, 0.004 * in(-1, 1), 0};
    one.velocity = vector(0.3, dimension) + Vector3{1.0 - i, 0, 0};
    one.spin = dimension == 3 ? vector(60, 3) : Vector3{0, 0, in(-60, 60)};
    return one;
  }
  model::Tangential tangential() {
    switch (static_cast<int>(in(0, 4))) {
      case 0:
        return {};
      case 1:
        return {TangentialLaw::rigid, in(0.05, 0.6), 0};
      case 2:
        return {TangentialLaw::spring, in(0.05, 0.6), in(1e5, 1e6)};
      default:
        return {TangentialLaw::mindlin, in(0.05, 0.6), in(0.6e9, 1.4e9)};
    }
  }
  contact::Law branched_law() {
    constexpr double modulus = 1e10, radius = 0.005;
    const double work = std::pow(10, in(1.5, 3.5)), pressure = std::pow(10, in(8, 9));
    switch (static_cast<int>(in(0, 6))) {
      case 0:
        return contact::state(contact::Dmt(modulus, radius, work, in(0, 1) < 0.5 ? 0 : in(1e2, 1e4)));
      case 1:
        return contact::state(contact::Thornton(modulus, radius, pressure));
      case 2:
        return contact::state(contact::ThorntonNing(modulus, radius, pressure, 0.03 * work));
      case 3:
        return contact::state(contact::WaltonBraun(1e6, in(1e6, 4e6)));
      case 4:
        return contact::state(contact::BrachDunnLaw(modulus, radius, work, in(0, 1) < 0.5 ? 0 : in(0, 0.3),
                                                    in(0, 1) < 0.5 ? 0 : in(0, 0.3)));
      default:
        return contact::state(contact::Jkr(modulus, radius, work, in(0, 1) < 0.5 ? 0 : in(1e3, 1e5)));
    }
  }
  contact::Law law() {
    if (branched_) return branched_law();
    switch (static_cast<int>(in(0, 4))) {
      case 0:
        return contact::Linear(1e6);
      case 1:
        return contact::Viscoelastic{1e9, in(1e2, 1e4), 1.5};
      case 2:
        return std::make_shared<contact::HuntCrossley>(1e9, in(0.05, 0.5));
      default:
        return contact::Hertz(1e9);
    }
  }
  void join(Index a, Index b, model::Bodies& bodies) {
    auto friction = tangential();
    while (branched_ && friction.law == TangentialLaw::mindlin) friction = tangential();
    const auto normal = law();
    for (Index p = 0; p < std::ssize(bodies.body[a].spheres); ++p)
      for (Index q = 0; q < std::ssize(bodies.body[b].spheres); ++q)
        bodies.contact.push_back({.a = {a, p}, .b = {b, q}, .law = normal, .tangential = friction});
  }

  std::mt19937 random_;
  bool branched_;
};

}  // namespace support
