#include "mariotte/model/bodies/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/contact/coulomb.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

constexpr std::array law_names = {"none", "rigid", "spring", "mindlin"};

bool is_positive(double value) {
  return value > 0 && std::isfinite(value);
}
bool is_finite(const Vector3& v) {
  return std::isfinite(v.e1) && std::isfinite(v.e2) && std::isfinite(v.e3);
}

std::string numbered(const std::string& name, const char* kind, Index i) {
  return name.empty() ? kind + std::string(" ") + std::to_string(i + 1) : name;
}

Vector3 centre_of(const Bodies& bodies, const Feature& feature) {
  const auto& body = bodies.body[feature.owner];
  const auto turn = bodies.dimension == 2 ? rotation({0, 0, 1}, body.angle) : body.attitude;
  return body.position + rotate(turn, body.spheres[feature.sphere].centre);
}
double radius_of(const Bodies& bodies, const Feature& feature) {
  return bodies.body[feature.owner].spheres[feature.sphere].radius;
}
double radii_of(const Bodies& bodies, const BodyContact& contact) {
  return radius_of(bodies, contact.b) + (contact.a.is_plane() ? 0 : radius_of(bodies, contact.a));
}

/// Speed at which the two come nearer.
double approach(const Bodies& bodies, const BodyContact& contact) {
  const auto velocity = [&](const Feature& feature) {
    const auto& body = bodies.body[feature.owner];
    return body.velocity + cross(body.spin, centre_of(bodies, feature) - body.position);
  };
  const bool is_plane = contact.a.is_plane();
  const auto& plane = bodies.plane;
  const Vector3 apart =
      is_plane ? plane[contact.a.owner].normal : centre_of(bodies, contact.b) - centre_of(bodies, contact.a);
  return dot(apart, (is_plane ? plane[contact.a.owner].velocity : velocity(contact.a)) - velocity(contact.b));
}

template <class Name>
void check_inertia(const Bodies& bodies, const Body& body, const Name& name) {
  const auto& [a, b, c] = body.inertia;
  if (bodies.dimension == 2) {
    if (!is_positive(c)) throw InvalidParameter(name() + ": inertia must be positive and finite");
    return;
  }
  if (!is_positive(a) || !is_positive(b) || !is_positive(c))
    throw InvalidParameter(name() + ": moments of inertia must be positive and finite");
  const double slack = 1 + 8 * epsilon;
  if (a > slack * (b + c) || b > slack * (a + c) || c > slack * (a + b))
    throw InvalidParameter(name() +
                           ": no body has such moments of inertia, one is larger than the others' sum");
}

void check_body(const Bodies& bodies, Index i) {
  const auto& body = bodies.body[i];
  const auto name = [&] { return body_name(bodies, i); };
  if (!is_positive(body.mass)) throw InvalidParameter(name() + ": mass must be positive and finite");
  check_inertia(bodies, body, name);
  if (!is_finite(body.position) || !is_finite(body.velocity) || !is_finite(body.spin))
    throw InvalidParameter(name() + ": position, velocity and spin must be finite");
  for (const auto& sphere : body.spheres)
    if (!(sphere.radius >= 0) || !std::isfinite(sphere.radius) || !is_finite(sphere.centre))
      throw InvalidParameter(name() + ": a sphere has a finite centre and a radius of at least 0");
}

double gap_of_positions(const Bodies& bodies, const BodyContact& contact) {
  const Vector3 centre = centre_of(bodies, contact.b);
  const bool is_plane = contact.a.is_plane();
  const Vector3 other = is_plane ? bodies.plane[contact.a.owner].point : centre_of(bodies, contact.a);
  const double radii = radii_of(bodies, contact);
  const double apart =
      is_plane ? dot(bodies.plane[contact.a.owner].normal, centre - other) : norm(centre - other);
  const double gap = apart - radii, rounding = 16 * epsilon * (norm(centre) + norm(other) + radii);
  return gap < 0 && gap > -rounding ? 0 : gap;
}

/// What is stated to touch stands there but for a tenth of the radii: farther it is a slip of the pen.
void expect_touch(const Bodies& bodies, const BodyContact& contact, const std::string& name) {
  constexpr double most = 0.1;
  const double gap = gap_of_positions(bodies, contact), radii = radii_of(bodies, contact);
  if (contact.touching && radii > 0 && !(std::abs(gap) <= most * radii))
    throw InvalidParameter(name + ": touching = true, but their positions are " + std::to_string(gap) +
                           " m from that");
}

void check_contact(const Bodies& bodies, const BodyContact& contact) {
  const auto name = [&] { return name_of(bodies, contact.a) + " and " + name_of(bodies, contact.b); };
  const auto& tangential = contact.tangential;
  if (!(tangential.friction >= 0 && tangential.friction <= contact::most_friction))
    throw InvalidParameter(name() + ": friction must be between 0 and 1e9, beyond which nothing slips");
  if (tangential.has_spring() && !is_positive(tangential.stiffness))
    throw InvalidParameter(name() + ": the tangential stiffness must be positive and finite");
  if (tangential.law == TangentialLaw::mindlin && contact::branched(contact.law))
    throw InvalidParameter(name() + ": Mindlin's stiffness is that of a Hertz contact; beside a law that " +
                           "pulls, yields or ends with its indentation, friction is rigid or a spring");
  if (!(contact.share >= 0 && contact.share <= 1))
    throw InvalidParameter(name() + ": share must be between 0 and 1");
  if (!contact.a.is_plane() && radii_of(bodies, contact) == 0)
    throw InvalidParameter(name() + ": two points never touch");
  expect_touch(bodies, contact, name());
  if (start_gap(bodies, contact) < 0)
    throw InvalidParameter(name() + " overlap at the start, by " +
                           std::to_string(-start_gap(bodies, contact)) +
                           " m; say touching = true if that is rounding");
  if (contact::adheres(contact.law) && start_gap(bodies, contact) == 0 && !(approach(bodies, contact) > 0))
    throw InvalidParameter(name() +
                           " touch at rest and adhere: whether they have snapped in is open; leave a gap");
}

}  // namespace

const char* name(TangentialLaw law) {
  return law_names[static_cast<std::size_t>(law)];
}

std::optional<TangentialLaw> tangential_law(std::string_view name) {
  const auto found = std::find(law_names.begin(), law_names.end(), name);
  if (found == law_names.end()) return std::nullopt;
  return static_cast<TangentialLaw>(found - law_names.begin());
}

std::string body_name(const Bodies& bodies, Index i) {
  return numbered(bodies.body[i].name, "body", i);
}

std::string name_of(const Bodies& bodies, const Feature& feature) {
  if (feature.is_plane()) return numbered(bodies.plane[feature.owner].name, "plane", feature.owner);
  const auto& body = bodies.body[feature.owner];
  const auto name = body_name(bodies, feature.owner);
  return body.spheres.size() == 1 ? name : name + "." + std::to_string(feature.sphere + 1);
}

Index always_told(const Bodies& bodies) {
  constexpr Index few = 200;
  const Index all = std::ssize(bodies.contact);
  return all <= few ? all : bodies.named;
}

double start_gap(const Bodies& bodies, const BodyContact& contact) {
  return contact.touching ? 0 : gap_of_positions(bodies, contact);
}

void expect_end(const Bodies& bodies, double max_time) {
  if (max_time < infinity) return;
  for (const auto& contact : bodies.contact)
    if (contact::adheres(contact.law))
      throw InvalidParameter(name_of(bodies, contact.a) + " and " + name_of(bodies, contact.b) +
                             " adhere, and may stay together for ever: give the run an end");
}

void validate(const Bodies& bodies) {
  if (bodies.dimension != 2 && bodies.dimension != 3) throw InvalidParameter("dimension must be 2 or 3");
  if (bodies.body.empty()) throw InvalidParameter("there must be at least one body");
  if (!is_finite(bodies.gravity)) throw InvalidParameter("gravity must be finite");
  for (Index i = 0; i < std::ssize(bodies.body); ++i) check_body(bodies, i);
  for (Index i = 0; i < std::ssize(bodies.plane); ++i) {
    const auto& plane = bodies.plane[i];
    if (!is_finite(plane.point) || !is_finite(plane.velocity) || !(std::abs(norm(plane.normal) - 1) < 1e-9))
      throw InvalidParameter(numbered(plane.name, "plane", i) + ": its normal must have the length 1");
  }
  for (const auto& contact : bodies.contact) check_contact(bodies, contact);
}

}  // namespace mariotte::model
