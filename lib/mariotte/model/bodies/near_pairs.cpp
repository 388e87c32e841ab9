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

/// Whatever the bodies' attitudes, the gap is no smaller than that of balls around them.
template <int D>
bool is_near(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
             const SettingContact<D>& c) {
  if (c.plane >= 0) return true;
  const auto &a = setting.sphere[c.a], &b = setting.sphere[c.b];
  const auto centre = [&](const SettingSphere<D>& s) { return vec_at<D>(x, at.shift(s.body)) - s.arm; };
  const double apart = norm(c.apart + centre(b) - centre(a));
  return apart < setting.body[a.body].reach + setting.body[b.body].reach + setting.skin;
}

}  // namespace

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
    if (is_near(setting, at, x, setting.contact[c])) mode.near.push_back(c);
}

template void refresh_near(const BodiesSetting<2>&, const BodiesLayout<2>&, ConstState, BodiesMode&);
template void refresh_near(const BodiesSetting<3>&, const BodiesLayout<3>&, ConstState, BodiesMode&);

}  // namespace mariotte::model
