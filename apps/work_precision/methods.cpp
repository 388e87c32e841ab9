#include "method.hpp"

namespace mariotte::work_precision {

std::vector<Method> methods() {
  auto all = own_methods();
  for (auto* rivals : {cvode_rivals, odeint_rivals, fixed_step_rivals})
    for (auto& method : rivals()) all.push_back(std::move(method));
  return all;
}

}  // namespace mariotte::work_precision
