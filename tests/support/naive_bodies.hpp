// Bodies with friction for the naive simulator, as codes of granular matter do it: steps of a fixed share of
// the shortest contact, springs that grow step by step and are cut at Coulomb's limit, no events. Good to a
// thousandth or so. Balls in space, anything in the plane; friction needs a spring.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mariotte/model/bodies/bodies.hpp"
#include "support/naive_law.hpp"
#include "support/naive_steps.hpp"

namespace mariotte::test {

class NaiveBodies {
 public:
  NaiveBodies(const model::Bodies& bodies, double speed, const Effort& effort)
      : bodies_(bodies), speed_(speed), moving_(bodies.body), load_(bodies.body.size()) {
    for (const auto& contact : bodies.contact)
      contact_.push_back({contact, NaiveLaw(contact.law), contact.touching ? model_gap(contact) : 0});
    shortest_ = infinity;
    for (const auto& one : contact_)
      shortest_ = std::min(shortest_, one.law.natural_depth(mobility(one.pair), speed) / speed);
    step_ = 0.02 * effort.share * shortest_;
    if (bodies.dimension == 2)
      for (auto& body : moving_) body.attitude = {std::cos(body.angle / 2), 0, 0, std::sin(body.angle / 2)};
  }

  static bool can_follow(const model::Bodies& bodies) {
    const auto is_rigid = [](const auto& one) {
      return one.tangential.law == model::TangentialLaw::rigid && one.tangential.friction > 0;
    };
    return std::none_of(bodies.contact.begin(), bodies.contact.end(), is_rigid);
  }

  /// False if that takes more than so many steps.
  bool follow(double end, Index most_steps) {
    find_forces(0);
    double time = 0;
    for (Index count = 0; time < end; ++count) {
      if (count > most_steps) return false;
      const double step = std::min(longest_step(), end - time);
      kick(step / 2);
      drift(step);
      find_forces(step);
      kick(step / 2);
      time += step;
    }
    return true;
  }

  const std::vector<model::Body>& bodies() const { return moving_; }

 private:
  struct Contact {
    model::BodyContact pair;
    NaiveLaw law;
    double offset;         ///< of the gap, so that what touches does so to the last bit
    Vector3 tangential{};  ///< T or k ξ, against the slip of b
    Vector3 normal{};
    NaiveMemory past{};
    double depth = 0;
    double gap = 0;
  };
  struct Load {
    Vector3 force, moment;
  };
  struct Side {
    Vector3 centre, velocity, spin, arm;
    double radius = 0;
  };

  double mobility(const model::BodyContact& pair) const {
    const auto of = [&](const model::Feature& one) {
      return one.is_plane() ? 0 : 1 / bodies_.body[index(one)].mass;
    };
    return of(pair.a) + of(pair.b);
  }
  static std::size_t index(const model::Feature& one) { return static_cast<std::size_t>(one.owner); }

  Side side(const model::Feature& one) const {
    const auto& body = moving_[index(one)];
    const auto& sphere = body.spheres[static_cast<std::size_t>(one.sphere)];
    const Vector3 arm = rotate(body.attitude, sphere.centre);
    return {body.position + arm, body.velocity, body.spin, arm, sphere.radius};
  }
  /// A plane as the point of it that is nearest to a sphere.
  Side side(const model::Feature& one, const Side& other, Vector3& normal) const {
    if (!one.is_plane()) {
      const auto a = side(one);
      normal = (1 / norm(other.centre - a.centre)) * (other.centre - a.centre);
      return a;
    }
    const auto& plane = bodies_.plane[index(one)];
    normal = plane.normal;
    const Vector3 point = plane.point + time_ * plane.velocity;
    return {other.centre - dot(normal, other.centre - point) * normal, plane.velocity, {}, {}, 0};
  }
  double model_gap(const model::BodyContact& pair) const {
    Vector3 normal;
    const auto b = NaiveBodies::side(pair.b);
    const auto a = side(pair.a, b, normal);
    return norm(b.centre - a.centre) - a.radius - b.radius;
  }

  /// Steps of contacts, and longer ones while all are far apart.
  double longest_step() const {
    double least = infinity;
    for (const auto& one : contact_) {
      if (one.gap <= 0) return step_;
      least = std::min(least, one.gap);
    }
    return std::max(step_, 0.05 * least / speed_);
  }

  void kick(double time) {
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      auto& body = moving_[i];
      body.velocity = body.velocity + (time / body.mass) * load_[i].force;
      body.spin = body.spin + (time / body.inertia.e3) * load_[i].moment;
    }
  }
  void drift(double time) {
    time_ += time;
    for (auto& body : moving_) {
      body.position = body.position + time * body.velocity;
      const double half = time / 2 * norm(body.spin), share = half > 0 ? time / 2 * std::sin(half) / half : 0;
      const Quaternion turn{std::cos(half), share * body.spin.e1, share * body.spin.e2, share * body.spin.e3};
      body.attitude = normalized(turn * body.attitude);
    }
  }
  void find_forces(double step) {
    for (std::size_t i = 0; i < moving_.size(); ++i) load_[i] = {moving_[i].mass * bodies_.gravity, {}};
    for (auto& one : contact_) press(one, step);
  }

  void press(Contact& one, double step) {
    const auto b = side(one.pair.b);
    Vector3 normal;
    const auto a = side(one.pair.a, b, normal);
    one.gap = dot(normal, b.centre - a.centre) - a.radius - b.radius - one.offset;
    const double depth = -one.gap;
    one.past = {.peak = std::max(one.past.peak, depth), .attached = one.law.adheres(one.past, depth)};
    if (depth <= 0 && !one.past.attached) {
      one.tangential = {};
      one.depth = 0;
      return;
    }
    const Vector3 lever_b = b.arm - (b.radius - one.pair.share * depth) * normal;
    const Vector3 lever_a = a.arm + (a.radius - (1 - one.pair.share) * depth) * normal;
    const Vector3 relative = b.velocity + cross(b.spin, lever_b) - a.velocity -
                             (one.pair.a.is_plane() ? Vector3{} : cross(a.spin, lever_a));
    const double force = one.law.force(one.past, depth, -dot(relative, normal));
    grow(one, normal, depth, force, relative, a.spin + b.spin, step);
    const Vector3 push = force * normal - one.tangential;
    add(one.pair.b, push, lever_b);
    if (!one.pair.a.is_plane()) add(one.pair.a, -1.0 * push, lever_a);
  }
  void add(const model::Feature& one, const Vector3& force, const Vector3& lever) {
    auto& load = load_[index(one)];
    load.force = load.force + force;
    load.moment = load.moment + cross(lever, force);
  }

  void grow(Contact& one, const Vector3& normal, double depth, double force, const Vector3& relative,
            const Vector3& spin, double step) {
    const auto& law = one.pair.tangential;
    if (law.law == model::TangentialLaw::none) return;
    const bool mindlin = law.law == model::TangentialLaw::mindlin;
    if (one.depth > 0) {
      carry(one, normal, spin, step);
      if (mindlin && depth < one.depth) one.tangential = std::sqrt(depth / one.depth) * one.tangential;
    }
    const double middle = (one.depth + depth) / 2;
    const double stiffness = mindlin ? law.stiffness * std::sqrt(middle) : law.stiffness;
    const Vector3 slip = relative - dot(relative, normal) * normal;
    one.tangential = one.tangential + (stiffness * step) * slip;
    const double size = norm(one.tangential), limit = law.friction * std::max(0.0, force);
    if (size > limit) one.tangential = (limit / size) * one.tangential;
    one.normal = normal;
    one.depth = depth;
  }
  /// With the plane of contact, and half the spins about its normal.
  static void carry(Contact& one, const Vector3& normal, const Vector3& spin, double step) {
    const double before = norm(one.tangential);
    Vector3 t = one.tangential - dot(one.tangential, normal) * normal;
    t = t + (step / 2 * dot(spin, normal)) * cross(normal, t);
    if (const double after = norm(t); after > 0) one.tangential = (before / after) * t;
  }

  const model::Bodies& bodies_;
  double speed_, step_ = 0, shortest_ = 0, time_ = 0;
  std::vector<model::Body> moving_;
  std::vector<Load> load_;
  std::vector<Contact> contact_;
};

}  // namespace mariotte::test
