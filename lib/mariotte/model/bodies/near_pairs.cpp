#include "mariotte/model/bodies/near_pairs.hpp"

namespace mariotte::model {
namespace {

template <int D>
bool has_strayed(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x, ConstState from) {
  for (Index i = 0; i < at.bodies; ++i) {
    const auto gone = vec_at<D>(x, at.shift(i)) - vec_at<D>(from, D * i);
    if (!(norm(gone) < 0.5 * setting.skin)) return true;
  }
  return false;
}

}  // namespace

template <int D>
double least_gap(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
                 const SettingContact<D>& c) {
  const auto centre = [&](const SettingSphere<D>& s) { return vec_at<D>(x, at.shift(s.body)) - s.arm; };
  const auto& b = setting.sphere[c.b];
  if (c.plane >= 0) {
    const auto moved = centre(b) - x[at.clock()] * setting.plane_velocity[c.plane];
    return c.gap + b.radius + dot(c.apart, moved) - setting.body[b.body].reach;
  }
  const auto& a = setting.sphere[c.a];
  return norm(c.apart + centre(b) - centre(a)) - setting.body[a.body].reach - setting.body[b.body].reach;
}

template <int D>
bool stays_open(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
                const SettingContact<D>& c, double time, std::span<const double> reach) {
  const double a =
      c.plane < 0 ? reach[setting.sphere[c.a].body] : time * norm(setting.plane_velocity[c.plane]);
  return least_gap(setting, at, x, c) > a + reach[setting.sphere[c.b].body];
}

template <int D>
void refresh_near(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
                  BodiesMode& mode) {
  if (setting.skin == 0 || mode.closed.empty()) return;
  if (!mode.from.empty() && !has_strayed(setting, at, x, mode.from)) return;
  mode.from.clear();
  for (Index i = 0; i < at.bodies; ++i)
    mode.from.insert(mode.from.end(), x.begin() + at.shift(i), x.begin() + at.shift(i) + D);
  mode.near.clear();
  for (Index c = 0; c < std::ssize(setting.contact); ++c)
    if (setting.contact[c].plane >= 0 || least_gap(setting, at, x, setting.contact[c]) < setting.skin)
      mode.near.push_back(c);
}

template double least_gap(const BodiesSetting<2>&, const BodiesLayout<2>&, ConstState,
                          const SettingContact<2>&);
template double least_gap(const BodiesSetting<3>&, const BodiesLayout<3>&, ConstState,
                          const SettingContact<3>&);
template bool stays_open(const BodiesSetting<2>&, const BodiesLayout<2>&, ConstState,
                         const SettingContact<2>&, double, std::span<const double>);
template bool stays_open(const BodiesSetting<3>&, const BodiesLayout<3>&, ConstState,
                         const SettingContact<3>&, double, std::span<const double>);
template void refresh_near(const BodiesSetting<2>&, const BodiesLayout<2>&, ConstState, BodiesMode&);
template void refresh_near(const BodiesSetting<3>&, const BodiesLayout<3>&, ConstState, BodiesMode&);

}  // namespace mariotte::model
