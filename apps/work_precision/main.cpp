#include "command_line.hpp"

int main(int argc, char** argv) {
  return mariotte::work_precision::command_line(argc, argv);
}
