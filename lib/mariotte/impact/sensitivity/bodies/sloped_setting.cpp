#include "mariotte/impact/sensitivity/bodies/sloped_setting.hpp"

#include "mariotte/core/error.hpp"

namespace mariotte::impact {

using model::lift;
using model::Sloped;

namespace {

/// Every number that the field is made from.
template <class Setting, class Use>
void for_each_number(Setting& setting, Use&& use) {
  const auto each = [&](auto& vector) {
    for (auto& number : vector.at) use(number);
  };
  each(setting.gravity);
  for (auto& body : setting.body) {
    use(body.mass);
    each(body.inertia);
    for (auto* part : {&body.attitude.w, &body.attitude.x, &body.attitude.y, &body.attitude.z}) use(*part);
  }
  for (auto& sphere : setting.sphere) each(sphere.arm), use(sphere.radius);
  for (auto& velocity : setting.plane_velocity) each(velocity);
  for (auto& contact : setting.contact) {
    each(contact.apart);
    for (auto* number :
         {&contact.distance, &contact.gap, &contact.numbers.stiffness, &contact.numbers.damping,
          &contact.tangential.friction, &contact.tangential.stiffness, &contact.share})
      use(*number);
  }
}

template <int D>
std::vector<double> numbers(const model::BodiesSetting<D>& setting) {
  std::vector<double> list;
  for_each_number(setting, [&](double number) { list.push_back(number); });
  return list;
}

/// The same numbers without slopes.
template <int D>
SlopedSetting<D> lifted(const model::BodiesSetting<D>& base) {
  SlopedSetting<D> setting;
  setting.gravity = lift<Sloped>(base.gravity);
  for (const auto& one : base.body) {
    const auto& q = one.attitude;
    setting.body.push_back({.mass = one.mass,
                            .inertia = lift<Sloped>(one.inertia),
                            .attitude = {q.w, q.x, q.y, q.z},
                            .is_round = one.is_round,
                            .reach = one.reach,
                            .has_arms = one.has_arms,
                            .push = one.push});
  }
  for (const auto& one : base.sphere) setting.sphere.push_back({one.body, lift<Sloped>(one.arm), one.radius});
  for (const auto& one : base.plane_velocity) setting.plane_velocity.push_back(lift<Sloped>(one));
  for (const auto& one : base.contact)
    setting.contact.push_back(
        {.plane = one.plane,
         .a = one.a,
         .b = one.b,
         .apart = lift<Sloped>(one.apart),
         .distance = one.distance,
         .gap = one.gap,
         .law = one.law,
         .numbers = {one.numbers.stiffness, one.numbers.damping},
         .tangential = {one.tangential.law, one.tangential.friction, one.tangential.stiffness},
         .share = one.share,
         .mass = one.mass,
         .length = one.length,
         .time = one.time,
         .force = one.force});
  setting.speed = base.speed;
  setting.length = base.length;
  setting.time = base.time;
  setting.smallest_indentation = base.smallest_indentation;
  setting.slip_noise = base.slip_noise;
  setting.gap_noise = base.gap_noise;
  setting.skin = base.skin;
  setting.onset_noise = base.onset_noise;
  setting.faint = base.faint;
  setting.rounding = base.rounding;
  return setting;
}

template <int D>
void expect_power_laws(const model::BodiesSetting<D>& base, const model::BodiesSetting<D>& moved) {
  for (std::size_t j = 0; j < base.contact.size(); ++j) {
    const auto *before = contact::power_law(base.contact[j].law),
               *after = contact::power_law(moved.contact[j].law);
    if (!before || !after)
      throw InvalidParameter("slopes of bodies are known for linear, hertz and viscoelastic contacts alone");
    if (before->exponent != after->exponent)
      throw InvalidParameter("slopes of bodies by an exponent are not known");
  }
}

/// Of a round body attitudes are not followed.
template <int D>
void expect_same_roundness(const model::BodiesSetting<D>& base, const model::BodiesSetting<D>& moved) {
  for (std::size_t i = 0; i < base.body.size(); ++i)
    if (base.body[i].is_round != moved.body[i].is_round)
      throw InvalidParameter("moments of a body that are equal have slopes together, not one by one");
}

template <int D>
void set_slopes(const ShiftedSettings<D>& shifted, std::size_t lane, SlopedSetting<D>& setting) {
  std::array<std::vector<double>, stencil.size()> moved;
  for (std::size_t k = 0; k < stencil.size(); ++k) moved[k] = numbers(shifted.at[k]);
  std::size_t place = 0;
  for_each_number(setting, [&](Sloped& number) {
    number.slope[lane] = stencil_slope(shifted.step, [&](std::size_t k) { return moved[k][place]; });
    ++place;
  });
}

}  // namespace

template <int D>
std::vector<SlopedSetting<D>> sloped_settings(const model::BodiesSetting<D>& base,
                                              const std::vector<ShiftedSettings<D>>& shifted) {
  std::vector<SlopedSetting<D>> list;
  expect_power_laws(base, base);
  for (std::size_t c = 0; c < shifted.size(); ++c) {
    const std::size_t lane = c % model::slope_lanes;
    if (lane == 0) list.push_back(lifted(base));
    expect_power_laws(base, shifted[c].at.back());
    expect_same_roundness(base, shifted[c].at.back());
    set_slopes(shifted[c], lane, list.back());
  }
  return list;
}

template std::vector<SlopedSetting<2>> sloped_settings(const model::BodiesSetting<2>&,
                                                       const std::vector<ShiftedSettings<2>>&);
template std::vector<SlopedSetting<3>> sloped_settings(const model::BodiesSetting<3>&,
                                                       const std::vector<ShiftedSettings<3>>&);

}  // namespace mariotte::impact
