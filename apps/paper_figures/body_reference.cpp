#include "body_reference.hpp"

#include "measuring/stored_cases.hpp"

namespace mariotte::paper_figures {

using Json = nlohmann::json;
using measuring::same;

namespace {

Json find(const std::string& name, double tilt, double friction, double ratio) {
  return measuring::find_case(name, [&](const Json& one) {
    return same(one["angles"][1], tilt) && same(one["friction"], friction) &&
           same(one["length_ratio"], ratio);
  });
}

}  // namespace

Json body_reference(const Strike& strike) {
  const char* name = strike.shape == "dumbbell" ? "body/dumbbell_length"
                     : strike.speed == 2        ? "body/rod_length"
                                                : "body/rod_tilt";
  return find(name, strike.tilt, strike.friction, strike.length_ratio);
}

Json rod_reference(double tilt, double friction) {
  return find("body/rod_events", tilt, friction, 10);
}

std::vector<Json> sphere_references(double radius) {
  std::vector<Json> list;
  for (const auto& one : measuring::cases("body/sphere_normal"))
    if (same(one["radius"], radius)) list.push_back(one);
  return list;
}

}  // namespace mariotte::paper_figures
