#include "chain_reference.hpp"

#include "measuring/stored_cases.hpp"

namespace mariotte::paper_figures {

using Json = nlohmann::json;
using measuring::find_case;

Json reference(const Triplet& triplet) {
  const std::vector<double> velocity = {1, 0, triplet.third_velocity};
  return find_case("chain/triplets", [&](const Json& one) {
    return one["law"] == triplet.law && one["kappa"] == triplet.ratio && one["velocity"] == velocity;
  });
}

Json equal_chain_reference(std::size_t balls) {
  return find_case("chain/equal_chains", [&](const Json& one) { return one["n"] == balls; });
}

Json big_ball_reference(const std::string& name) {
  return find_case("chain/big_ball_chains", [&](const Json& one) { return one["name"] == name; });
}

}  // namespace mariotte::paper_figures
