// Reference cases from tests/data/body as microbodies and numbers.
#pragma once
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "mariotte/impact/microbody/microbody_impact.hpp"

namespace mariotte::test {

inline nlohmann::json body_cases(const std::string& file) {
  std::ifstream in(std::string(MARIOTTE_TEST_DATA) + "/body/" + file);
  return nlohmann::json::parse(in).at("cases");
}

inline Vector3 vector_of(const nlohmann::json& list, std::size_t at = 0) {
  return {list.at(at), list.at(at + 1), list.at(at + 2)};
}

/// Ammonium fluorescein on silicon [Cheng 2002, Table 1, corrected].
inline constexpr contact::Surface table_1{.stiffness = 1.74e9, .adhesion = 0.38};
inline constexpr double density = 1350;

inline model::RigidBody shape_of(const std::string& shape, double radius, double ratio) {
  if (shape == "rod") return model::rod(radius, ratio, density);
  return shape == "dumbbell" ? model::dumbbell(radius, ratio, density) : model::sphere(radius, density);
}

inline model::Microbody microbody(const nlohmann::json& c) {
  constexpr double degree = std::numbers::pi / 180;
  const double radius = c.at("radius");
  model::Microbody body;
  body.body = shape_of(c.at("shape"), radius, c.value("length_ratio", 0.0));
  body.law.assign(body.body.tips.size(),
                  contact::brach_dunn(table_1, radius, c.at("damping_hertz"), c.at("damping_adhesion")));
  body.friction = {c.at("friction")};
  const auto angles = c.value("angles", std::vector<double>{0, 0, 0});
  body.attitude = from_euler({angles[0] * degree, angles[1] * degree, angles[2] * degree});
  body.velocity = vector_of(c.at("velocity"));
  if (c.contains("spin")) body.spin = vector_of(c.at("spin"));
  body.gravity = c.value("gravity", 0.0);
  if (c.contains("lever")) body.lever = model::Lever::indented;
  body.impacts = c.value("impacts", 1);
  return body;
}

/// Largest incident speed of a case: of the mass centre or of the tip.
inline double speed_scale(const model::Microbody& body) {
  const Vector3 tip = cross(body.spin, rotate(body.attitude, body.body.tips[0].centre));
  return std::max(norm(body.velocity), norm(body.velocity + tip));
}

/// What an error of the spin is multiplied by to be a velocity.
inline double reach(const model::Microbody& body) {
  return norm(body.body.tips[0].centre) + body.body.tips[0].radius;
}

struct NamedEvent {
  std::string kind;
  Index tip;
  double time;
};

/// Changes of friction that last less than this are left out of comparisons: when, and whether, they happen
/// is decided by rounding.
inline constexpr double shortest_episode = 1e-12;

inline bool is_friction(const NamedEvent& event) {
  return event.kind == "stick" || event.kind == "slip";
}

/// Of several changes of friction within the shortest episode only the last counts, and only if it changes
/// anything: stick after stick does not. A force that changes sign and back in so short a time has not.
inline std::vector<NamedEvent> lasting(const std::vector<NamedEvent>& events) {
  std::vector<NamedEvent> result;
  std::string state;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!is_friction(events[i])) {
      const bool back = !result.empty() && ((events[i].kind == "push" && result.back().kind == "pull") ||
                                            (events[i].kind == "pull" && result.back().kind == "push"));
      if (back && events[i].time - result.back().time < shortest_episode)
        result.pop_back();
      else
        result.push_back(events[i]);
      continue;
    }
    bool brief = false;
    for (std::size_t j = i + 1; j < events.size(); ++j)
      if ((is_friction(events[j]) || events[j].kind == "open") &&
          events[j].time - events[i].time < shortest_episode)
        brief = true;
    if (brief || (events[i].kind == "stick" && state == "stick")) continue;
    state = events[i].kind;
    result.push_back(events[i]);
  }
  return result;
}

inline std::vector<NamedEvent> events_of(const nlohmann::json& c) {
  std::vector<NamedEvent> list;
  for (const auto& e : c.at("events")) list.push_back({e[0], e[1], e[2]});
  return list;
}

inline std::vector<NamedEvent> events_of(const impact::MicrobodyImpact& impact) {
  std::vector<NamedEvent> list;
  for (const auto& e : impact.events) {
    const std::pair<const char*, const std::vector<Index>*> kinds[] = {
        {"close", &e.close}, {"push", &e.push}, {"pull", &e.pull},      {"stick", &e.stick},
        {"slip", &e.slip},   {"open", &e.open}, {"capture", &e.capture}};
    for (const auto& [kind, tips] : kinds)
      for (const Index tip : *tips) list.push_back({kind, tip, e.time});
  }
  return list;
}

inline std::string text(const std::vector<NamedEvent>& events) {
  std::string all;
  for (const auto& e : events) all += e.kind + std::to_string(e.tip) + " ";
  return all;
}

}  // namespace mariotte::test
