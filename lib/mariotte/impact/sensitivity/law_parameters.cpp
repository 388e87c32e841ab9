#include "mariotte/impact/sensitivity/law_parameters.hpp"

#include <algorithm>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"

namespace mariotte::impact {
namespace {

using contact::Law;

bool is_chosen(const Law& law, const contact::LawParameter& number) {
  const auto* power = power_law(law);
  if (number.value == 0) return false;
  if (number.key == "exponent")
    return number.value > 1 && !(power && power->damping == 0 && power->exponent == 1.5);
  return true;
}

contact::LawNumbers numbers(const contact::NamedLaw& named, const Law& law) {
  contact::LawNumbers result;
  for (const auto& one : parameters(law))
    if (const auto* key = named.find(one.key)) result.*(key->number) = one.value;
  return result;
}

/// The step, or as much less of it as leaves laws at four times that on both sides: an unloading stiffness
/// may be hardly above that of loading. 0 where the laws end at the number itself.
double step_within(double value, double step, const std::function<Law(double)>& law) {
  for (const double share : {1.0, 1e-1, 1e-2, 1e-3, 1e-4}) try {
      law(value - 4 * share * step), law(value + 4 * share * step);
      return share * step;
    } catch (const InvalidParameter&) {
    }
  return 0;
}

/// "linear", "hertz" and "viscoelastic" are one law.
const contact::NamedLaw* named(const Law& law) {
  const auto wanted = power_law(law) ? std::string_view("viscoelastic") : name(law);
  const auto place = std::find_if(contact::named_laws.begin(), contact::named_laws.end(),
                                  [&](const auto& one) { return one.name == wanted; });
  return place == contact::named_laws.end() || place->has_table ? nullptr : &*place;
}

}  // namespace

std::vector<LawParameterChoice> law_parameters(const Law& law) {
  const auto* known = named(law);
  std::vector<LawParameterChoice> list;
  if (!known) return list;
  const bool is_uncut = contact::is_uncut(law);
  for (const auto& number : parameters(law)) {
    const auto* key = known->find(number.key);
    if (!key || !is_chosen(law, number)) continue;
    // Lengths of a micrometre to the power n change by e^{14 dn}.
    const double step =
        number.key == "exponent" ? 1e-3 * std::min(1.0, number.value - 1) : stencil_share * number.value;
    const auto moved_to = [=, start = numbers(*known, law)](double value) {
      auto moved = start;
      moved.*(key->number) = value;
      auto made = known->make(moved);
      return is_uncut ? contact::uncut(std::move(made)) : made;
    };
    const double power = known->exponent.value_or(numbers(*known, law).exponent);
    const bool is_linear = power_law(law) && number.key != "exponent";
    const double within = step_within(number.value, step, moved_to);
    if (within > 0)
      list.push_back(
          {std::string(number.key), number.value, within, moved_to, key->dimension(power), is_linear});
  }
  return list;
}

}  // namespace mariotte::impact
