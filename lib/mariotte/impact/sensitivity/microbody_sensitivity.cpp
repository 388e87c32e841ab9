#include "mariotte/impact/sensitivity/sensitivity.hpp"
namespace mariotte::impact {
Sensitivity sensitivity(const model::Microbody&, const std::vector<Parameter<model::Microbody>>&,
                        const hybrid::Options&) {
  return {};
}
}  // namespace mariotte::impact
