#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/reason.hpp"

namespace mariotte::report {
namespace {

Json vector(const Vector3& v) {
  return Json::array({v.e1, v.e2, v.e3});
}
Json in_plane(const Vector3& v) {
  return Json::array({v.e2, v.e3});
}
Json quaternion(const Quaternion& q) {
  return Json::array({q.w, q.x, q.y, q.z});
}

Json state(const impact::BodyState& body) {
  const auto angles = to_euler(body.attitude);
  return {{"time", body.time},
          {"position", vector(body.position)},
          {"quaternion", quaternion(body.attitude)},
          {"angles", Json::array({angles.alpha, angles.beta, angles.gamma})},
          {"velocity", vector(body.velocity)},
          {"spin", vector(body.spin)}};
}

Json tip_impact(const impact::TipImpact& impact) {
  const auto after = [&](double value) { return impact.end ? Json(value) : Json(nullptr); };
  return {{"tip", impact.tip + 1},
          {"start", impact.start},
          {"end", nullable(impact.end)},
          {"normal_velocity_in", impact.normal_velocity_in},
          {"normal_velocity_out", after(impact.normal_velocity_out)},
          {"centre_velocity_in", impact.centre_velocity_in},
          {"centre_velocity_out", after(impact.centre_velocity_out)},
          {"slip_out", impact.end ? in_plane(impact.slip_out) : Json(nullptr)},
          {"peak_force", impact.peak_force},
          {"peak_pull", impact.peak_pull},
          {"peak_indentation", impact.peak_indentation}};
}

/// 1 where tip 1 is pushed from now on, −1 where it is pulled.
Json force_signs(const impact::TipEvents& event) {
  Json signs = from_one(event.push);
  for (const Index tip : event.pull) signs.push_back(-(tip + 1));
  return signs;
}

Json event(const impact::TipEvents& event) {
  return {{"time", event.time},
          {"open", from_one(event.open)},
          {"close", from_one(event.close)},
          {"stick", from_one(event.stick)},
          {"slip", from_one(event.slip)},
          {"force_sign", force_signs(event)},
          {"capture", from_one(event.capture)}};
}

Json energy(const impact::MicrobodyLedger& ledger) {
  return {{"initial", ledger.initial},
          {"final", ledger.final},
          {"stored", ledger.stored},
          {"dissipated", ledger.dissipated()},
          {"hertz_damping", ledger.hertz_damping},
          {"adhesion_damping", ledger.adhesion_damping},
          {"friction", ledger.friction},
          {"work", ledger.work},
          {"residual", ledger.residual}};
}

Json rest(const std::optional<impact::RestState>& rest) {
  if (!rest) return nullptr;
  return {{"tip", rest->tip + 1}, {"indentation", rest->indentation}};
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

Json json(const impact::MicrobodyImpact& impact, const scene::Scene& scene) {
  Json result = {{"ending", hybrid::name(impact.ending)}, {"title", scene.title}, {"model", "microbody"}};
  if (const auto why = reason(impact.ending, impact.message, scene.run); !why.empty())
    result["message"] = why;
  result["final"] = state(impact.final);
  result["restitution"] = {{"tip", nullptr}, {"centre", nullptr}};
  if (impact::has_restitution(impact))
    result["restitution"] = {{"tip", impact.restitution.tip}, {"centre", impact.restitution.centre}};
  result["impacts"] = list(impact.impacts, tip_impact);
  result["events"] = list(impact.events, event);
  result["rest"] = rest(impact.rest);
  result["shared_friction"] = impact.shared_friction;
  result["energy"] = energy(impact.energy);
  result["momentum"] = {{"impulse", vector(impact.impulse)}};
  result["accuracy"] = {{"requested", impact.requested_accuracy},
                        {"estimated", nullable(impact.estimated_accuracy)}};
  result["flows"] = list(impact.flows, flow);
  result["skipped"] = skipped(impact.skipped);
  if (!scene.warnings.empty()) result["warnings"] = scene.warnings;
  result["provenance"] = provenance_json(scene.sha256);
  return result;
}

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
