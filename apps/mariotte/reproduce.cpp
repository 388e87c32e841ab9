#include "command.hpp"
#include "companion.hpp"

namespace mariotte::command {

Command reproduce_command() {
  return {.name = "reproduce",
          .about = "Figures of the papers, computed again and checked",
          .pass_on = [](const Words& rest) -> int { become("paper_figures", rest); }};
}

}  // namespace mariotte::command
