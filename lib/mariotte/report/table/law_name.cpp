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

LawCells law_cells(const contact::Law& law, const std::function<std::string(double)>& number) {
  LawCells cells;
  const auto add = [&](const std::string& text) {
    cells.others += (cells.others.empty() ? "" : ", ") + text;
  };
  for (const auto& [key, value] : parameters(law))
    if (key == "stiffness")
      cells.stiffness = number(value);
    else if (key == "exponent")
      cells.exponent = number(value);
    else if (power_law(contact::cut(law)))
      cells.damping = number(value);
    else
      add(std::string(key) + " " + number(value));
  if (contact::is_uncut(law)) add("separation indentation");
  return cells;
}

}  // namespace mariotte::report
