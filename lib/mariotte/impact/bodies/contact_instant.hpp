// One contact of bodies in the plane at an instant, as if it were rigid.
#pragma once
#include "mariotte/impact/bodies/first_impact.hpp"
#include "mariotte/model/bodies/bodies_motion.hpp"

namespace mariotte::impact {

/// One contact of bodies as they are at one instant.
struct ContactInstant {
  explicit ContactInstant(const model::Bodies& bodies, Index contact)
      : setting(model::setting_of<2>(bodies, 1)),
        one(setting.contact[contact]),
        motion(contact_motion(setting, {.bodies = std::ssize(setting.body)}, one,
                              model::initial_state(bodies, setting))) {}

  ContactInstant(const ContactInstant&) = delete;

  Index body_a() const { return one.plane < 0 ? setting.sphere[one.a].body : Index{-1}; }
  Index body_b() const { return setting.sphere[one.b].body; }
  InContact in_contact(const model::Vec<double, 2>& v) const {
    return {dot(v, motion.normal), motion.normal[0] * v[1] - motion.normal[1] * v[0]};
  }
  model::Vec<double, 2> in_space(const InContact& p) const {
    const auto& n = motion.normal;
    return {{p.normal * n[0] - p.tangential * n[1], p.normal * n[1] + p.tangential * n[0]}};
  }

  model::BodiesSetting<2> setting;
  const model::SettingContact<2>& one;
  model::ContactMotion<double, 2> motion;
};

/// Of b on a.
InContact velocity(const ContactInstant& at);
/// W, velocity and friction.
FrictionalContact rigid_contact(const ContactInstant& at);
/// Motions that go on from `list` once b has had an impulse, and a its opposite.
std::vector<PlaneMotion> struck(const ContactInstant& at, const InContact& impulse,
                                std::vector<PlaneMotion> list);

}  // namespace mariotte::impact
