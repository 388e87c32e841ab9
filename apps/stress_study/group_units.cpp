#include "group_units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mariotte::stress_study {

double reach(const model::Body& body) {
  double most = 0;
  for (const auto& one : body.spheres) most = std::max(most, norm(one.centre) + one.radius);
  return most;
}

namespace {

/// Where it is, and how fast it goes along the normal, of what a contact joins.
std::pair<Vector3, Vector3> place_and_velocity(const model::Bodies& bodies, const model::Feature& feature) {
  const auto i = static_cast<std::size_t>(feature.owner);
  if (feature.is_plane()) return {bodies.plane[i].point, bodies.plane[i].velocity};
  return {bodies.body[i].position, bodies.body[i].velocity};
}
/// Of two balls, or a ball and a plane.
double approach(const model::Bodies& bodies, const model::BodyContact& contact) {
  const auto [a, va] = place_and_velocity(bodies, contact.a);
  const auto [b, vb] = place_and_velocity(bodies, contact.b);
  const auto normal = contact.a.is_plane() ? bodies.plane[static_cast<std::size_t>(contact.a.owner)].normal
                                           : (1 / norm(b - a)) * (b - a);
  return dot(va - vb, normal);
}

/// Whether body i touches something, and whether it does so at rest along the normal.
struct Touch {
  bool any = false, at_rest = false;
  bool is_stated = true;  ///< wherever bodies are put
  double gap = infinity;  ///< the least of those that do not touch
};
Touch touch_of(const model::Bodies& bodies, std::size_t i, double speed) {
  Touch touch;
  const auto is_own = [i](const model::Feature& one) {
    return !one.is_plane() && one.owner == static_cast<Index>(i);
  };
  for (const auto& contact : bodies.contact) {
    if (!is_own(contact.a) && !is_own(contact.b)) continue;
    const double gap = contact.touching ? 0 : model::start_gap(bodies, contact);
    if (gap > 1e-9 * reach(bodies.body[i])) {
      touch.gap = std::min(touch.gap, gap);
      continue;
    }
    touch.any = true;
    touch.is_stated = touch.is_stated && contact.touching;
    touch.at_rest |= std::abs(approach(bodies, contact)) < 1e-9 * speed;
  }
  return touch;
}

std::size_t body_of(const std::string& name) {
  return static_cast<std::size_t>(std::stoul(name.substr(name.find('[') + 1)));
}

}  // namespace

std::optional<double> unit_of(const model::Bodies& bodies, const impact::Parameter<model::Bodies>& one,
                              double speed) {
  if (!one.name.starts_with("body[")) return std::abs(one.value);
  const auto i = body_of(one.name);
  const auto& body = bodies.body[i];
  const auto touch = touch_of(bodies, i, speed);
  const auto is = [&](const char* part) { return one.name.find(part) != std::string::npos; };
  if (is(".position") || is(".angle")) {
    if (touch.any) return std::nullopt;
    return is(".angle") ? 1 : reach(body);
  }
  if (is("radius") && !touch.is_stated) return std::nullopt;
  if (!is(".velocity") && !is(".spin")) return std::abs(one.value);
  if (touch.at_rest) return std::nullopt;
  return is(".spin") ? speed / reach(body) : speed;
}

double longest_step(const model::Bodies& bodies, const impact::Parameter<model::Bodies>& one, double unit) {
  const double step = std::min(one.step, 0.01 * unit);
  const bool moves = one.name.find(".position") != std::string::npos ||
                     one.name.find(".angle") != std::string::npos ||
                     one.name.find("radius") != std::string::npos;
  if (!moves) return step;
  const auto i = body_of(one.name);
  const double length = one.name.find(".angle") == std::string::npos ? 1 : reach(bodies.body[i]);
  return std::min(step, 0.1 * touch_of(bodies, i, 1).gap / length);
}

}  // namespace mariotte::stress_study
