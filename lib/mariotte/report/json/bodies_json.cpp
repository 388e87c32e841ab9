#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::report {
namespace {

/// As many components as the dimension has.
Json vector(const Vector3& v, int dimension) {
  Json all = Json::array({v.e1, v.e2});
  if (dimension == 3) all.push_back(v.e3);
  return all;
}

Json body_json(const model::Bodies& bodies, Index i) {
  const auto& body = bodies.body[i];
  const int d = bodies.dimension;
  const auto sphere = [d](const model::BodySphere& one) -> Json {
    return {{"centre", vector(one.centre, d)}, {"radius", one.radius}};
  };
  Json one = {{"name", body.name},
              {"mass", body.mass},
              {"inertia", d == 2 ? Json(body.inertia.e3) : vector(body.inertia, 3)},
              {"spheres", list(body.spheres, sphere)},
              {"position", vector(body.position, d)}};
  if (d == 2)
    one["angle"] = body.angle;
  else
    one["quaternion"] = Json::array({body.attitude.w, body.attitude.x, body.attitude.y, body.attitude.z});
  one["velocity"] = vector(body.velocity, d);
  one["spin"] = d == 2 ? Json(body.spin.e3) : vector(body.spin, 3);
  return one;
}

Json contact_json(const model::Bodies& bodies, const model::BodyContact& contact) {
  Json one = {{"between", Json::array({name_of(bodies, contact.a), name_of(bodies, contact.b)})}};
  one.update(law_json(contact.law));
  const auto& tangential = contact.tangential;
  one["tangential"] = name(tangential.law);
  if (tangential.law != model::TangentialLaw::none) one["friction"] = tangential.friction;
  if (tangential.has_spring()) one["tangential_stiffness"] = tangential.stiffness;
  one["share"] = contact.share;
  one["gap"] = start_gap(bodies, contact);
  return one;
}

}  // namespace

Json json_of_bodies(const model::Bodies& bodies, const scene::Scene& scene) {
  const int d = bodies.dimension;
  Json result = {{"title", scene.title}, {"model", "bodies"}};
  auto& all = result["bodies"] = {{"dimension", d}, {"gravity", vector(bodies.gravity, d)}};
  all["body"] = Json::array();
  for (Index i = 0; i < std::ssize(bodies.body); ++i) all["body"].push_back(body_json(bodies, i));
  all["plane"] = list(bodies.plane, [d](const model::Plane& plane) -> Json {
    return {{"name", plane.name},
            {"point", vector(plane.point, d)},
            {"normal", vector(plane.normal, d)},
            {"velocity", vector(plane.velocity, d)}};
  });
  all["contact"] =
      list(bodies.contact, [&](const model::BodyContact& contact) { return contact_json(bodies, contact); });
  result["run"] = options(scene.run);
  if (!scene.warnings.empty()) result["warnings"] = scene.warnings;
  result["provenance"] = provenance_json(scene.sha256);
  return result;
}

}  // namespace mariotte::report
