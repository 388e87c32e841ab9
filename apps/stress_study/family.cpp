#include "family.hpp"

#include <algorithm>

namespace mariotte::stress_study {

std::vector<Family> slope_families() {
  auto list = families({"chains", "networks", "bodies", "laws"});
  std::erase_if(list, [](const Family& family) { return family.every > 1; });  // those that take long
  for (auto& family : list) {
    family.name = "slopes, " + family.name;
    family.slopes = true;
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
  add("slopes", slope_families);
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
