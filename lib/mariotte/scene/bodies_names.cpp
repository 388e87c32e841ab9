#include "mariotte/scene/bodies_names.hpp"

namespace mariotte::scene {
using model::Feature;

std::vector<Feature> all_spheres(const model::Bodies& bodies, Index body) {
  std::vector<Feature> list;
  for (Index k = 0; k < std::ssize(bodies.body[body].spheres); ++k) list.push_back({body, k});
  return list;
}

namespace {

void add_body(const std::string& name, bool is_given, const std::vector<Feature>& spheres,
              std::vector<Called>& list) {
  list.push_back({name, spheres, is_given});
  for (const auto& one : spheres)
    list.push_back({name + "." + std::to_string(one.sphere + 1), {one}, is_given, false});
}

}  // namespace

std::vector<Called> called(const model::Bodies& bodies) {
  std::vector<Called> list;
  for (Index i = 0; i < std::ssize(bodies.body); ++i) {
    const auto& name = bodies.body[i].name;
    const auto spheres = all_spheres(bodies, i);
    if (!name.empty()) add_body(name, true, spheres, list);
    add_body("body " + std::to_string(i + 1), false, spheres, list);
  }
  for (Index i = 0; i < std::ssize(bodies.plane); ++i) {
    const auto& name = bodies.plane[i].name;
    if (!name.empty()) list.push_back({name, {{i, -1}}, true});
    list.push_back({"plane " + std::to_string(i + 1), {{i, -1}}});
  }
  return list;
}

}  // namespace mariotte::scene
