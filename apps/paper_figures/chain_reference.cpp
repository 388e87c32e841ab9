#include "chain_reference.hpp"

#include <stdexcept>

#include "stored_numbers.hpp"

namespace mariotte::paper_figures {
namespace {

using Json = nlohmann::json;

template <class Matches>
Json find(const char* text, const Matches& matches) {
  const auto all = Json::parse(text);
  for (const auto& one : all.at("cases"))
    if (matches(one)) return one;
  throw std::out_of_range("there is no such reference");
}

}  // namespace

Json reference(const Triplet& triplet) {
  const std::vector<double> velocity = {1, 0, triplet.third_velocity};
  return find(stored::triplets, [&](const Json& one) {
    return one["law"] == triplet.law && one["kappa"] == triplet.ratio && one["velocity"] == velocity;
  });
}

Json equal_chain_reference(std::size_t balls) {
  return find(stored::equal_chains, [&](const Json& one) { return one["n"] == balls; });
}

Json big_ball_reference(const std::string& name) {
  return find(stored::big_ball_chains, [&](const Json& one) { return one["name"] == name; });
}

}  // namespace mariotte::paper_figures
