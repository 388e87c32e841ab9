#include "mariotte/study/sweep/numbers.hpp"

#include <algorithm>

#include "mariotte/core/overload.hpp"

namespace mariotte::study {
namespace {

void add(std::vector<double>& values, std::vector<double*>& all) {
  for (double& value : values) all.push_back(&value);
}

bool is_power_law(const contact::Law& law) {
  return power_law(law);
}

std::vector<double*> numbers_of_chain(model::Chain& chain, scene::Scene& scene) {
  std::vector<double*> all;
  if (!chain.drive.empty()) return all;
  if (!std::all_of(chain.law.begin(), chain.law.end(), is_power_law)) return all;
  for (auto* values : {&chain.mass, &chain.velocity, &chain.gap, &scene.radius}) add(*values, all);
  for (auto& any : chain.law) {
    auto& law = std::get<contact::PowerLaw>(any);
    all.insert(all.end(), {&law.stiffness, &law.damping, &law.exponent});
  }
  all.insert(all.end(), {&chain.gravity, &scene.run.accuracy, &scene.run.max_time});
  return all;
}

bool same_chain(const model::Chain& a, const model::Chain& b) {
  const auto same_law = [](const contact::Law& x, const contact::Law& y) { return x.index() == y.index(); };
  return a.mass.size() == b.mass.size() && a.precompressed == b.precompressed && a.drive.empty() &&
         b.drive.empty() && std::equal(a.law.begin(), a.law.end(), b.law.begin(), b.law.end(), same_law);
}

bool same_model(const scene::Model& a, const scene::Model& b) {
  return std::visit(
      Overload{[&](const model::Chain& chain) {
                 const auto* other = std::get_if<model::Chain>(&b);
                 return other && same_chain(chain, *other);
               },
               [](const model::Network&) { return false; }, [](const model::Microbody&) { return false; },
               [](const model::Bodies&) { return false; }, [](const scene::LawAlone&) { return false; }},
      a);
}

}  // namespace

std::vector<double*> numbers(scene::Scene& scene) {
  using List = std::vector<double*>;
  return std::visit(Overload{[&](model::Chain& chain) { return numbers_of_chain(chain, scene); },
                             [](model::Network&) { return List(); }, [](model::Microbody&) { return List(); },
                             [](model::Bodies&) { return List(); }, [](scene::LawAlone&) { return List(); }},
                    scene.model);
}

bool same_form(const scene::Scene& a, const scene::Scene& b) {
  return same_model(a.model, b.model) && a.radius.size() == b.radius.size() && a.touching == b.touching &&
         a.run.max_events == b.run.max_events && a.run.flow == b.run.flow && a.title == b.title;
}

}  // namespace mariotte::study
