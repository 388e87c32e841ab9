#include "mariotte/impact/bodies/contact_instant.hpp"

namespace mariotte::impact {

InContact velocity(const ContactInstant& at) {
  return {at.motion.gap_rate, at.in_contact(at.motion.slip).tangential};
}

namespace {

void add_response(FrictionalContact& rigid, const ContactInstant& at, Index body,
                  const model::Vec<double, 2>& lever) {
  const double mass = at.setting.body[body].mass, inertia = at.setting.body[body].inertia[0];
  const auto arm = at.in_contact(lever);  // the normal has the moment −arm.tangential, the tangent arm.normal
  rigid.nn += 1 / mass + arm.tangential * arm.tangential / inertia;
  rigid.nt -= arm.tangential * arm.normal / inertia;
  rigid.tt += 1 / mass + arm.normal * arm.normal / inertia;
}

}  // namespace

FrictionalContact rigid_contact(const ContactInstant& at) {
  FrictionalContact rigid{.nn = 0, .nt = 0, .tt = 0, .velocity = velocity(at)};
  add_response(rigid, at, at.body_b(), at.motion.lever_b);
  if (at.body_a() >= 0) add_response(rigid, at, at.body_a(), at.motion.lever_a);
  if (at.one.tangential.law != model::TangentialLaw::none) rigid.friction = at.one.tangential.friction;
  return rigid;
}

namespace {

void kick(const ContactInstant& at, Index body, const model::Vec<double, 2>& lever,
          const model::Vec<double, 2>& impulse, std::vector<PlaneMotion>& list) {
  auto& motion = list[body];
  motion.velocity = motion.velocity + (1 / at.setting.body[body].mass) * model::vector3(impulse);
  motion.spin += moment(lever, impulse)[0] / at.setting.body[body].inertia[0];
}

}  // namespace

std::vector<PlaneMotion> struck(const ContactInstant& at, const InContact& impulse,
                                std::vector<PlaneMotion> list) {
  const auto on_b = at.in_space(impulse);
  kick(at, at.body_b(), at.motion.lever_b, on_b, list);
  if (at.body_a() >= 0) kick(at, at.body_a(), at.motion.lever_a, -1.0 * on_b, list);
  return list;
}

}  // namespace mariotte::impact
