#include "mariotte/contact/named_laws.hpp"

#include <iterator>

namespace mariotte::contact {

std::string names_of_laws() {
  std::string text;
  for (std::size_t i = 0; i < std::size(named_laws); ++i) {
    if (i > 0) text += i + 1 < std::size(named_laws) ? ", " : " or ";
    text += named_laws[i].name;
  }
  return text;
}

}  // namespace mariotte::contact
