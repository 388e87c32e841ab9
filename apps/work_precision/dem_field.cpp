#include "dem_field.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::work_precision {

using model::Bodies;

bool DemField::admits(const Bodies& bodies) {
  return std::all_of(bodies.contact.begin(), bodies.contact.end(),
                     [](const auto& c) { return c.tangential.law == model::TangentialLaw::mindlin; });
}

DemField::DemField(const Bodies& bodies)
    : length_(bodies.body[0].spheres[0].radius), mass_(bodies.body[0].mass) {
  for (const auto& body : bodies.body) add(body);
  if (!bodies.plane.empty()) {
    const auto& plane = bodies.plane[0];
    normal_x_ = plane.normal.e1, normal_y_ = plane.normal.e2;
    height_ = dot(plane.normal, plane.point) / length_;
  }
  for (const auto& contact : bodies.contact) add(contact);
  start_.resize(spring(pair_.size()), 0.0);
}

void DemField::add(const model::Body& body) {
  ball_.push_back(
      {body.mass / mass_, body.inertia.e3 / (mass_ * length_ * length_), body.spheres[0].radius / length_});
  start_.insert(start_.end(), {body.position.e1 / length_, body.position.e2 / length_, body.velocity.e1,
                               body.velocity.e2, body.spin.e3 * length_});
}

void DemField::add(const model::BodyContact& c) {
  const double unit = mass_ / std::pow(length_, 2.5);
  const double stiffness = contact::power_law(c.law)->stiffness / unit;
  pair_.push_back({c.a.is_plane() ? -1 : static_cast<int>(c.a.owner), static_cast<int>(c.b.owner), stiffness,
                   c.tangential.stiffness / unit, c.tangential.friction});
  contact_time_ = std::min(contact_time_, std::pow(stiffness, -0.4));
}

DemField::Touch DemField::touch(const Pair& pair, const State& x) const {
  const double *b = &x[5 * pair.b], *a = pair.a < 0 ? nullptr : &x[5 * pair.a];
  const double radius_b = ball_[pair.b].radius, radius_a = a ? ball_[pair.a].radius : 0;
  double n1 = normal_x_, n2 = normal_y_, gap = n1 * b[0] + n2 * b[1] - height_ - radius_b;
  if (a) {
    const double apart_x = b[0] - a[0], apart_y = b[1] - a[1], apart = std::hypot(apart_x, apart_y);
    gap = apart - radius_a - radius_b;
    n1 = apart_x / apart, n2 = apart_y / apart;
  }
  if (gap >= 0) return {};
  const double v1 = b[2] - (a ? a[2] : 0), v2 = b[3] - (a ? a[3] : 0);
  const double lever_b = radius_b + 0.5 * gap, lever_a = a ? radius_a + 0.5 * gap : 0;
  return {-gap, -(n1 * v1 + n2 * v2), n1 * v2 - n2 * v1 - lever_b * b[4] - (a ? lever_a * a[4] : 0), n1, n2};
}

double DemField::cap_of(const Pair& pair, const Touch& now) const {
  return pair.friction * pair.stiffness * now.depth * std::sqrt(now.depth);
}

/// `tangential` holds back b.
void DemField::push(const Pair& pair, const Touch& now, double tangential, State& dx) const {
  const double normal = pair.stiffness * now.depth * std::sqrt(now.depth);
  const double f1 = normal * now.normal_x + tangential * now.normal_y,
               f2 = normal * now.normal_y - tangential * now.normal_x;
  const auto on = [&](int i, double sign) {
    const auto& ball = ball_[i];
    double* rate = &dx[5 * i];
    rate[2] += sign * f1 / ball.mass;
    rate[3] += sign * f2 / ball.mass;
    rate[4] += (ball.radius - 0.5 * now.depth) * tangential / ball.moment;
  };
  on(pair.b, 1);
  if (pair.a >= 0) on(pair.a, -1);
}

void DemField::operator()(const State& x, State& dx) const {
  std::fill(dx.begin(), dx.end(), 0.0);
  for (std::size_t i = 0; i < 5 * ball_.size(); i += 5) dx[i] = x[i + 2], dx[i + 1] = x[i + 3];
  for (std::size_t c = 0; c < pair_.size(); ++c) {
    const auto& pair = pair_[c];
    const auto now = touch(pair, x);
    if (!(now.depth > 0)) continue;
    const double cap = cap_of(pair, now), held = std::clamp(x[spring(c)], -cap, cap);
    dx[spring(c)] = pair.grip * std::sqrt(now.depth) * now.slip;
    if (now.rate < 0) dx[spring(c)] += 0.5 * held * now.rate / now.depth;
    push(pair, now, held, dx);
  }
}

void DemField::settle(State& x) const {
  for (std::size_t c = 0; c < pair_.size(); ++c) {
    const double cap = cap_of(pair_[c], touch(pair_[c], x));
    x[spring(c)] = std::clamp(x[spring(c)], -cap, cap);
  }
}

void DemField::verlet(double h, State& x, State& dx) const {
  kick(0.5 * h, x, dx);
  for (std::size_t i = 0; i < 5 * ball_.size(); i += 5) x[i] += h * x[i + 2], x[i + 1] += h * x[i + 3];
  std::fill(dx.begin(), dx.end(), 0.0);
  for (std::size_t c = 0; c < pair_.size(); ++c) {
    const auto now = touch(pair_[c], x);
    const double root = std::sqrt(now.depth), cap = cap_of(pair_[c], now);
    double& force = x[spring(c)];
    if (now.rate < 0) force *= root / std::sqrt(now.depth - h * now.rate);
    force = std::clamp(force + h * pair_[c].grip * root * now.slip, -cap, cap);
    if (now.depth > 0) push(pair_[c], now, force, dx);
  }
  kick(0.5 * h, x, dx);
}

void DemField::kick(double h, State& x, const State& dx) const {
  for (std::size_t i = 0; i < 5 * ball_.size(); i += 5)
    for (std::size_t k = 2; k < 5; ++k) x[i + k] += h * dx[i + k];
}

std::vector<double> DemField::velocities(const State& x) const {
  std::vector<double> list;
  for (std::size_t i = 0; i < 5 * ball_.size(); i += 5)
    list.insert(list.end(), {x[i + 2], x[i + 3], x[i + 4]});
  return list;
}

}  // namespace mariotte::work_precision
