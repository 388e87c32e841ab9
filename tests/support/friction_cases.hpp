// Reference impacts of bodies with friction, by two independent methods: tests/data/bodies/friction.json.
#pragma once
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"

namespace mariotte::test {

using Json = nlohmann::json;

inline Vector3 vector_of(const Json& list) {
  return {list[0], list[1], list.size() > 2 ? list[2].get<double>() : 0};
}

inline model::Body body_of(const Json& one, bool plane) {
  model::Body body{.name = one["name"], .mass = one["mass"]};
  if (plane) {
    body.inertia.e3 = one["inertia"];
    body.angle = one.value("angle", 0.0);
    body.spin.e3 = one["spin"];
  } else {
    body.inertia = vector_of(one["inertia"]);
    body.spin = vector_of(one["spin"]);
    if (one.contains("quaternion")) {
      const auto& q = one["quaternion"];
      body.attitude = normalized(Quaternion{q[0], q[1], q[2], q[3]});
    }
  }
  body.position = vector_of(one["position"]);
  body.velocity = vector_of(one["velocity"]);
  for (const auto& sphere : one["spheres"])
    body.spheres.push_back({vector_of(sphere["centre"]), sphere["radius"]});
  return body;
}

inline contact::Law law_of(const Json& normal) {
  const double k = normal["k"];
  if (normal["law"] == "hertz") return contact::Hertz(k);
  if (normal["law"] == "linear") return contact::Linear(k);
  return contact::Viscoelastic{.stiffness = k, .damping = normal["c"], .exponent = normal["exponent"]};
}

inline model::Feature feature_of(const Json& one) {
  if (one.contains("plane")) return {one["plane"], -1};
  return {one["body"], one["sphere"]};
}

inline model::Bodies bodies_of(const Json& scene) {
  model::Bodies bodies{.dimension = scene["dimension"], .gravity = vector_of(scene["gravity"])};
  for (const auto& one : scene["bodies"]) bodies.body.push_back(body_of(one, bodies.dimension == 2));
  for (const auto& one : scene["planes"])
    bodies.plane.push_back({.name = "",
                            .point = vector_of(one["point"]),
                            .normal = vector_of(one["normal"]),
                            .velocity = vector_of(one["velocity"])});
  for (const auto& one : scene["contacts"]) {
    const auto& tangential = one["tangential"];
    const char* stiffness = tangential.contains("kappa") ? "kappa" : "k_t";
    bodies.contact.push_back(
        {.a = feature_of(one["a"]),
         .b = feature_of(one["b"]),
         .law = law_of(one["normal"]),
         .tangential = {.law = *model::tangential_law(tangential["law"].get<std::string>()),
                        .friction = tangential.value("mu", 0.0),
                        .stiffness = tangential.value(stiffness, 0.0)},
         .share = one["share"]});
  }
  for (const Index contact : scene["touching"]) bodies.contact[contact].touching = true;
  bodies.named = std::ssize(bodies.contact);
  return bodies;
}

inline std::vector<Json> friction_cases() {
  Json all;
  std::ifstream(MARIOTTE_TEST_DATA "/bodies/friction.json") >> all;
  return all["cases"];
}

}  // namespace mariotte::test
