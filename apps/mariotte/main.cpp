#include "command.hpp"

int main(int argc, char** argv) {
  return mariotte::command::command_line(argc, argv);
}
