#include "mariotte/study/constant_restitution.hpp"

#include "mariotte/contact/law.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::study {
namespace {

std::vector<double> dampings(const scene::Scene& scene) {
  std::vector<double> all;
  const auto of_contacts = [&](const auto& model) {
    for (const auto& law : model.law)
      for (const auto& one : contact::parameters(law))
        if (one.key == "damping") all.push_back(one.value);
  };
  const auto of_body = [&](const model::Microbody& body) {
    for (const auto& law : body.law) all.push_back(law.damping_hertz);
  };
  std::visit(Overload{[&](const model::Chain& one) { of_contacts(one); },
                      [&](const model::Network& one) { of_contacts(one); }, of_body, [](const auto&) {}},
             scene.model);
  return all;
}

/// The table that says it, and no speed.
std::optional<std::string> table_of_restitution(const scene::Document& document) {
  const scene::Field root{&document.tree, ""};
  for (const char* name : {"chain", "network", "surface"})
    if (const auto table = find(root, name); table && table->node->table())
      if (find(*table, "restitution") && !find(*table, "at")) return name;
  return std::nullopt;
}

}  // namespace

bool is_speed(const std::string& key) {
  return key.find("velocity") != key.npos || key.find("speed") != key.npos;
}

std::vector<std::string> warn_of_constant_restitution(const scene::Document& document,
                                                      const scene::Scene& slow, const scene::Scene& fast) {
  const auto table = table_of_restitution(document);
  if (!table || dampings(slow) == dampings(fast)) return {};
  return {"'" + *table + ".restitution' is met at every speed, by another damping at each; '" + *table +
          ".at' says for which speed it holds"};
}

}  // namespace mariotte::study
