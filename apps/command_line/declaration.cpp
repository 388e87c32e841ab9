#include "command_line/declaration.hpp"

namespace mariotte::command {

OptionList joined(std::initializer_list<OptionList> lists) {
  OptionList all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace mariotte::command
