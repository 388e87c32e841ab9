#include "mariotte/model/bodies/bodies_setting.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/core/state_vectors.hpp"
#include "mariotte/model/contacts/bound.hpp"
#include "mariotte/model/contacts/scaled_contacts.hpp"
#include "mariotte/model/fault.hpp"

namespace mariotte::model {
namespace {

template <int D>
SettingBody<D> body_of(const Body& body) {
  SettingBody<D> one{.mass = body.mass, .inertia = {}, .attitude = {}, .is_round = true};
  if constexpr (D == 2) {
    one.inertia = {{body.inertia.e3}};
    one.attitude = rotation({0, 0, 1}, body.angle);
  } else {
    const auto& j = body.inertia;
    one.inertia = vec<3>(j);
    one.attitude = normalized(body.attitude);
    one.is_round = j.e1 == j.e2 && j.e2 == j.e3;
  }
  for (const auto& sphere : body.spheres) {
    one.reach = std::max(one.reach, norm(sphere.centre) + sphere.radius);
    one.has_arms = one.has_arms || norm(sphere.centre) > 0;
  }
  return one;
}

/// Index of the first sphere of each body in the list of all.
std::vector<Index> first_spheres(const Bodies& bodies) {
  std::vector<Index> first{0};
  for (const auto& body : bodies.body) first.push_back(first.back() + std::ssize(body.spheres));
  return first;
}

template <int D>
void add_spheres(const Bodies& bodies, BodiesSetting<D>& setting) {
  for (Index i = 0; i < std::ssize(bodies.body); ++i)
    for (const auto& sphere : bodies.body[i].spheres)
      setting.sphere.push_back({i, vec<D>(rotate(setting.body[i].attitude, sphere.centre)), sphere.radius});
}

template <int D>
void add_contact(const Bodies& bodies, const BodyContact& contact, const std::vector<Index>& first,
                 BodiesSetting<D>& setting) {
  SettingContact<D> one{
      .apart = {}, .law = contact.law, .tangential = contact.tangential, .share = contact.share};
  if (const auto* power = contact::power_law(one.law)) one.numbers = {power->stiffness, power->damping};
  if (one.tangential.friction == 0) one.tangential.law = TangentialLaw::none;
  one.gap = start_gap(bodies, contact);
  one.b = first[contact.b.owner] + contact.b.sphere;
  if (contact.a.is_plane()) {
    one.plane = contact.a.owner;
    const auto& normal = bodies.plane[one.plane].normal;
    one.apart = vec<D>((1 / norm(normal)) * normal);
  } else {
    one.a = first[contact.a.owner] + contact.a.sphere;
    const auto centre = [&](Index sphere) {
      return vec<D>(bodies.body[setting.sphere[sphere].body].position) + setting.sphere[sphere].arm;
    };
    one.apart = centre(one.b) - centre(one.a);
    one.distance = norm(one.apart);
  }
  const double inverse = 1 / setting.body[contact.b.owner].mass +
                         (contact.a.is_plane() ? 0 : 1 / setting.body[contact.a.owner].mass);
  one.mass = 1 / inverse;
  setting.contact.push_back(one);
}

/// Indentation in which a contact stores this energy.
double natural_indentation(const contact::Law& law, double energy) {
  const auto* power = contact::power_law(law);
  return power ? natural_root(energy / power->stiffness, power->exponent)
               : std::get<contact::SharedLaw>(law)->natural_indentation(energy);
}

/// By how much weights press contacts whose gap is not wider, at most. One that cannot carry its weight has
/// no rest.
template <int D>
double sag(const BodiesSetting<D>& setting, double widest) {
  const double g = norm(setting.gravity);
  double depth = 0;
  for (const auto& c : setting.contact)
    if (g > 0 && c.gap <= widest) {
      const double weight = setting.body[setting.sphere[c.b].body].mass * g;
      depth = std::max(depth, contact::find_static_indentation(c.law, weight).value_or(0));
    }
  return depth;
}

/// Speed that gravity gives over a height, until the end.
template <int D>
double fallen(const BodiesSetting<D>& setting, double height, double max_time) {
  const double g = norm(setting.gravity);
  return g == 0 ? 0 : std::min(std::sqrt(2 * g * height), g * max_time);
}

/// That of what is not at rest on a plane yet.
template <int D>
double falling_speed(const BodiesSetting<D>& setting, double max_time) {
  double height = sag(setting, infinity);
  for (const auto& c : setting.contact) {
    if (c.plane < 0) continue;
    const auto& sphere = setting.sphere[c.b];
    const double reach = norm(sphere.arm) > 0 ? setting.body[sphere.body].reach : 0;
    height = std::max({height, c.gap, 0.02 * reach});
  }
  return fallen(setting, height, max_time);
}

/// Speed that adhesion gives what it draws in.
template <int D>
double well_speed(const BodiesSetting<D>& setting) {
  double squared = 0;
  for (const auto& c : setting.contact) squared = std::max(squared, 2 * well_energy(c.law) / c.mass);
  return std::sqrt(squared);
}

template <int D>
double surface_speed(const Bodies& bodies, const BodiesSetting<D>& setting, Index body) {
  return norm(bodies.body[body].spin) * setting.body[body].reach;
}

/// The largest speed of parts that come nearer at the start, or are pressed or swing then: without gravity no
/// others meet, unless these strike them.
template <int D>
double meeting_speed(const Bodies& bodies, const BodiesSetting<D>& setting) {
  double largest = 0;
  for (const auto& c : setting.contact) {
    const Index b = setting.sphere[c.b].body, a = c.plane < 0 ? setting.sphere[c.a].body : b;
    const auto& from = c.plane < 0 ? bodies.body[a].velocity : bodies.plane[c.plane].velocity;
    const auto rate = vec<D>(bodies.body[b].velocity - from);
    const double turning = std::max(surface_speed(bodies, setting, a), surface_speed(bodies, setting, b));
    const bool swings = turning > 0 && (setting.body[a].has_arms || setting.body[b].has_arms);
    if (dot(c.apart, rate) < 0 || c.gap < 0 || swings) largest = std::max({largest, norm(rate), turning});
  }
  return largest;
}

template <int D>
double reference_speed(const Bodies& bodies, const BodiesSetting<D>& setting, double max_time) {
  double speed = falling_speed(setting, max_time);
  for (Index i = 0; i < std::ssize(bodies.body); ++i)
    speed = std::max({speed, norm(bodies.body[i].velocity), surface_speed(bodies, setting, i)});
  for (const auto& plane : bodies.plane) speed = std::max(speed, norm(plane.velocity));
  if (norm(setting.gravity) == 0) speed = of_what_meets(meeting_speed(bodies, setting), speed);
  speed = std::hypot(speed, well_speed(setting));
  return speed > 0 ? speed : 1;
}

template <int D>
void set_natural_sizes(BodiesSetting<D>& setting) {
  setting.length = setting.time = infinity;
  for (auto& c : setting.contact) {
    c.length = natural_indentation(c.law, c.mass * setting.speed * setting.speed);
    c.time = c.length / setting.speed;
    c.force = c.mass * setting.speed / c.time;
    setting.length = std::min(setting.length, c.length);
    setting.time = std::min(setting.time, c.time);
  }
  if (setting.contact.empty()) setting.length = setting.time = 1;
  std::vector<double> push(setting.body.size(), 0);
  for (const auto& c : setting.contact)
    for (const Index sphere : {c.a, c.b}) {
      if (sphere < 0) continue;
      auto& most = push[setting.sphere[sphere].body];
      most = std::max(most, std::min(1.0, 2 * c.mass / setting.body[setting.sphere[sphere].body].mass));
    }
  for (std::size_t i = 0; i < push.size(); ++i) setting.body[i].push = push[i] > 0 ? push[i] : 1;
}

/// Share of its indentation that the first contact loses, of those that are reached in time.
template <int D>
double first_rounding(const BodiesSetting<D>& setting, double max_time) {
  const double way = 2 * setting.speed * max_time;
  double nearest = infinity;
  for (const auto& c : setting.contact)
    if (c.gap <= way) nearest = std::min(nearest, c.gap / c.length);
  return nearest < infinity ? lost_digits * nearest : 0;
}

/// Where there are many pairs, those are watched that are not far apart: a tenth of the smallest body, or
/// many indentations.
template <int D>
double skin_of(const BodiesSetting<D>& setting) {
  constexpr std::size_t few = 64;
  if (setting.contact.size() <= few) return 0;
  double least = infinity;
  for (const auto& body : setting.body)
    if (body.reach > 0) least = std::min(least, body.reach);
  return std::max(0.1 * least, 20 * setting.length);
}

}  // namespace

template <int D>
BodiesSetting<D> setting_of(const Bodies& bodies, double accuracy, double max_time) {
  BodiesSetting<D> setting;
  setting.gravity = vec<D>(bodies.gravity);
  setting.body.reserve(bodies.body.size());
  setting.contact.reserve(bodies.contact.size());
  for (const auto& body : bodies.body) setting.body.push_back(body_of<D>(body));
  for (const auto& plane : bodies.plane) setting.plane_velocity.push_back(vec<D>(plane.velocity));
  add_spheres(bodies, setting);
  const auto first = first_spheres(bodies);
  for (const auto& contact : bodies.contact) add_contact(bodies, contact, first, setting);
  setting.speed = reference_speed(bodies, setting, max_time);
  setting.sag_speed = fallen(setting, sag(setting, 0), max_time);
  set_natural_sizes(setting);
  setting.smallest_indentation = 1e-60 * setting.length;
  setting.slip_noise = std::max(1e-13, 1e-3 * accuracy);
  setting.gap_noise = std::max(1e-12, 1e-2 * accuracy);
  setting.faint = std::max(1e-7, 0.03 * std::sqrt(accuracy));
  setting.onset_noise = 0.1 * accuracy;
  setting.has_limit = !std::isinf(max_time);
  allow_rounding(setting, first_rounding(setting, max_time));
  setting.skin = skin_of(setting);
  return setting;
}

template <int D>
void expect_digits(const BodiesSetting<D>& setting) {
  constexpr double useless = 1e-6;
  if (setting.rounding > useless)
    throw InvalidParameter(
        "indentations are too small beside the gaps at the start: start nearer to the impact",
        fault::unrepresentable);
}

void expect_digits(const Bodies& bodies) {
  bodies.dimension == 2 ? expect_digits(setting_of<2>(bodies, 1)) : expect_digits(setting_of<3>(bodies, 1));
}

template <int D>
std::vector<double> initial_state(const Bodies& bodies, const BodiesSetting<D>& setting) {
  const BodiesLayout<D> at{.bodies = std::ssize(bodies.body), .slots = 0};
  std::vector<double> x(at.size(), 0.0);
  for (Index i = 0; i < at.bodies; ++i) {
    const auto& body = bodies.body[i];
    put(State(x), at.velocity(i), vec<D>(body.velocity));
    if constexpr (D == 2) {
      x[at.momentum(i)] = body.spin.e3;
    } else {
      const auto& one = setting.body[i];
      const Vector3 w = rotate(conjugate(one.attitude), body.spin);
      const Vector3 momentum{one.inertia[0] * w.e1, one.inertia[1] * w.e2, one.inertia[2] * w.e3};
      put(State(x), at.momentum(i),
          one.is_round ? one.inertia[0] * vec<3>(body.spin) : vec<3>(rotate(one.attitude, momentum)));
      x[at.turn(i)] = 1;
    }
  }
  return x;
}

template <int D>
void set_magnitudes(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, const BodiesMode& mode,
                    std::vector<double>& magnitude) {
  magnitude.assign(at.size(), 1.0);
  const auto fill = [&](Index place, Index count, double size) {
    std::fill_n(magnitude.begin() + place, count, size);
  };
  for (Index i = 0; i < at.bodies; ++i) {
    const auto& body = setting.body[i];
    const double reach = body.reach > 0 ? body.reach : setting.length;
    double inertia = body.inertia[0];
    for (int k = 0; k < turns(D); ++k) inertia = std::min(inertia, body.inertia[k]);
    const double spin = body.push * setting.speed / reach;
    fill(at.shift(i), D, setting.length);
    fill(at.turn(i), at.attitude, setting.length / reach);
    fill(at.velocity(i), D, body.push * setting.speed);
    fill(at.momentum(i), turns(D), D == 2 ? spin : inertia * spin);
  }
  magnitude[at.clock()] = setting.time;
  for (const auto& one : mode.closed) {
    const auto& c = setting.contact[one.contact];
    const bool as_force = c.tangential.law == TangentialLaw::mindlin && !one.unloading;
    const double elastic = as_force ? c.force : c.length;
    fill(at.spring(one.slot), at.tangents, one.friction == Friction::slip ? direction_magnitude : elastic);
    fill(at.normal(one.slot), 1 + at.tangents, c.mass * setting.speed);
    fill(at.losses(one.slot), 3, c.mass * setting.speed * setting.speed);
  }
}

template BodiesSetting<2> setting_of(const Bodies&, double, double);
template BodiesSetting<3> setting_of(const Bodies&, double, double);
template void expect_digits(const BodiesSetting<2>&);
template void expect_digits(const BodiesSetting<3>&);
template std::vector<double> initial_state(const Bodies&, const BodiesSetting<2>&);
template std::vector<double> initial_state(const Bodies&, const BodiesSetting<3>&);
template void set_magnitudes(const BodiesSetting<2>&, const BodiesLayout<2>&, const BodiesMode&,
                             std::vector<double>&);
template void set_magnitudes(const BodiesSetting<3>&, const BodiesLayout<3>&, const BodiesMode&,
                             std::vector<double>&);

}  // namespace mariotte::model
