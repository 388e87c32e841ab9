#include "mariotte/report/table/law_name.hpp"

#include "mariotte/contact/named_laws.hpp"

namespace mariotte::report {

std::string law_name(const contact::Law& law) {
  std::string text(name(law));
  if (text != "viscoelastic") return text;
  for (const auto& [key, value] : parameters(law))
    for (const auto& one : contact::named_laws)
      if (key == "exponent" && one.relaxation && one.exponent == value)
        text += " (" + std::string(one.name) + ")";
  return text;
}

}  // namespace mariotte::report
