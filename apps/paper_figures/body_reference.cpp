#include "body_reference.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

#include "stored_numbers.hpp"

namespace mariotte::paper_figures {
namespace {

using Json = nlohmann::json;

const Json& cases(const char* text) {
  static std::map<const char*, Json> parsed;
  auto& found = parsed[text];
  if (found.is_null()) found = Json::parse(text).at("cases");
  return found;
}

bool same(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::abs(b);
}

bool is_case(const Json& one, double tilt, double friction, double ratio) {
  return same(one["angles"][1], tilt) && same(one["friction"], friction) && same(one["length_ratio"], ratio);
}

Json find(const char* text, double tilt, double friction, double ratio) {
  for (const auto& one : cases(text))
    if (is_case(one, tilt, friction, ratio)) return one;
  throw std::out_of_range("there is no such reference");
}

}  // namespace

Json body_reference(const Strike& strike) {
  const char* text = strike.shape == "dumbbell" ? stored::dumbbell_length
                     : strike.speed == 2        ? stored::rod_length
                                                : stored::rod_tilt;
  return find(text, strike.tilt, strike.friction, strike.length_ratio);
}

Json rod_reference(double tilt, double friction) {
  return find(stored::rod_events, tilt, friction, 10);
}

std::vector<Json> sphere_references(double radius) {
  std::vector<Json> list;
  for (const auto& one : cases(stored::sphere_normal))
    if (same(one["radius"], radius)) list.push_back(one);
  return list;
}

}  // namespace mariotte::paper_figures
