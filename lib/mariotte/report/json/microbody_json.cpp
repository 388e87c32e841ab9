#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::report {
namespace {

Json vector(const Vector3& v) {
  return Json::array({v.e1, v.e2, v.e3});
}
Json quaternion(const Quaternion& q) {
  return Json::array({q.w, q.x, q.y, q.z});
}

Json tip(const model::Tip& tip) {
  return {{"centre", vector(tip.centre)}, {"radius", tip.radius}};
}

Json law(const contact::BrachDunn& law) {
  return {{"hertz_stiffness", law.stiffness},
          {"adhesion", law.adhesion},
          {"damping_hertz", law.damping_hertz},
          {"damping_adhesion", law.damping_adhesion},
          {"rest_indentation", contact::rest_indentation(law)}};
}

}  // namespace

Json json_of_body(const model::Microbody& body, const scene::Scene& scene) {
  Json result = {{"title", scene.title}, {"model", "microbody"}};
  result["body"] = {
      {"mass", body.body.mass}, {"inertia", vector(body.body.inertia)}, {"tips", list(body.body.tips, tip)}};
  result["surface"] = {{"tips", list(body.law, law)},
                       {"friction", body.friction.coefficient},
                       {"lever", body.lever == model::Lever::radius ? "radius" : "indented"}};
  const auto angles = to_euler(body.attitude);
  result["incidence"] = {{"velocity", vector(body.velocity)},
                         {"angles", Json::array({angles.alpha, angles.beta, angles.gamma})},
                         {"quaternion", quaternion(body.attitude)},
                         {"spin", vector(body.spin)}};
  result["run"] = options(scene.run);
  result["run"]["impacts"] = body.impacts;
  result["run"]["gravity"] = body.gravity;
  if (!scene.warnings.empty()) result["warnings"] = scene.warnings;
  result["provenance"] = provenance_json(scene.sha256);
  return result;
}

}  // namespace mariotte::report
