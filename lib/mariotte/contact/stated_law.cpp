#include "mariotte/contact/stated_law.hpp"

#include <cmath>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::contact {

void expect_numbers(std::string_view law, const std::vector<LawParameter>& parameters) {
  for (const auto& [key, value] : parameters) {
    const bool may_vanish = key.starts_with("damping");
    if ((may_vanish ? value >= 0 : value > 0) && std::isfinite(value)) continue;
    throw InvalidParameter(std::string(law) + ": " + std::string(key) + " must be " +
                           (may_vanish ? "finite and not negative" : "positive and finite"));
  }
}

}  // namespace mariotte::contact
