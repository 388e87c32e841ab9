#include "family.hpp"

#include <algorithm>

namespace mariotte::stress_study {

namespace {

bool has_slopes(const Scene& scene) {
  const auto* group = std::get_if<Group>(&scene.model);
  return !group || std::all_of(group->bodies.contact.begin(), group->bodies.contact.end(),
                               [](const auto& one) { return contact::power_law(one.law) != nullptr; });
}

}  // namespace

std::vector<Family> slope_families(const std::vector<std::string>& kinds) {
  auto list = families(kinds);
  std::erase_if(list, [](const Family& family) { return family.every > 1; });  // those that take long
  for (auto& family : list) {
    family.name = "slopes, " + family.name;
    family.slopes = true;
    family.draw = [draw = family.draw](Dice& dice) {
      auto scene = draw(dice);
      while (!has_slopes(scene)) scene = draw(dice);
      return scene;
    };
  }
  return list;
}

std::vector<Family> families(const std::vector<std::string>& kinds) {
  std::vector<Family> list;
  const auto add = [&](const char* kind, auto&& make) {
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) return;
    const auto more = make();
    list.insert(list.end(), more.begin(), more.end());
  };
  add("chains", chain_families);
  add("networks", network_families);
  add("bodies", body_families);
  add("laws", law_families);
  add("friction", friction_families);
  add("rows", row_families);
  add("slopes", [] { return slope_families({"chains", "networks", "bodies", "laws"}); });
  add("friction-slopes", [] { return slope_families({"friction"}); });
  return list;
}

std::size_t family_of(const std::vector<Family>& list, std::uint64_t number) {
  const auto size = list.size();
  const auto turn = number / size;
  const auto place = number % size;
  if (turn % list[place].every == 0) return place;
  for (std::uint64_t other = place + turn;; ++other)
    if (list[other % size].every == 1) return other % size;
}

Scene scene_of(const std::vector<Family>& list, std::uint64_t seed, std::uint64_t number) {
  Dice dice(seed, number);
  return list[family_of(list, number)].draw(dice);
}

}  // namespace mariotte::stress_study
