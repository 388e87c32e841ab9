#include "mariotte/study/sweep/numbers.hpp"

#include <algorithm>

namespace mariotte::study {
namespace {

void add(std::vector<double>& values, std::vector<double*>& all) {
  for (double& value : values) all.push_back(&value);
}

void add(contact::Linear& law, std::vector<double*>& all) {
  all.push_back(&law.stiffness);
}
void add(contact::Hertz& law, std::vector<double*>& all) {
  all.push_back(&law.stiffness);
}
void add(contact::Viscoelastic& law, std::vector<double*>& all) {
  all.insert(all.end(), {&law.stiffness, &law.damping, &law.exponent});
}

}  // namespace

std::vector<double*> numbers(scene::Scene& scene) {
  std::vector<double*> all;
  auto& chain = scene.chain;
  if (chain.mass.empty()) return all;
  for (auto* values : {&chain.mass, &chain.velocity, &chain.gap, &scene.radius}) add(*values, all);
  for (auto& law : chain.law) std::visit([&](auto& one) { add(one, all); }, law);
  all.insert(all.end(), {&chain.gravity, &scene.run.accuracy, &scene.run.max_time});
  return all;
}

bool same_form(const scene::Scene& a, const scene::Scene& b) {
  const auto same_law = [](const contact::Law& x, const contact::Law& y) { return x.index() == y.index(); };
  return a.chain.mass.size() == b.chain.mass.size() && a.radius.size() == b.radius.size() &&
         std::equal(a.chain.law.begin(), a.chain.law.end(), b.chain.law.begin(), b.chain.law.end(),
                    same_law) &&
         a.chain.precompressed == b.chain.precompressed && a.run.max_events == b.run.max_events &&
         a.run.flow == b.run.flow && a.title == b.title;
}

}  // namespace mariotte::study
