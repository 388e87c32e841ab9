// Prints the page of the result format.
#include "mariotte/report/page/result_format.hpp"

#include <cstdio>

int main() {
  std::fputs(mariotte::report::result_format().c_str(), stdout);
}
