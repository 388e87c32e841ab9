#include <iterator>

#include "method.hpp"

namespace mariotte::work_precision {

void append(std::vector<Method>& list, std::vector<Method> more) {
  std::move(more.begin(), more.end(), std::back_inserter(list));
}

std::vector<Method> methods() {
  auto all = own_methods();
  for (auto* rivals : {cvode_rivals, odeint_rivals, fixed_step_rivals}) append(all, rivals());
  return all;
}

}  // namespace mariotte::work_precision
