#include "mariotte/report/validity.hpp"

#include <fmt/format.h>

namespace mariotte::report {

std::vector<std::string> warnings(const impact::Validity& validity, const char* thing) {
  std::vector<std::string> list;
  for (const auto& one : impact::validity_limits)
    if (is_beyond(one, validity)) {
      const auto& [value, contact] = *(validity.*one.number);
      list.push_back(fmt::format("{} {}: {} = {:.3g} is {} {:g}: {}", thing, contact + 1, one.symbol, value,
                                 one.from_below ? "above" : "below", one.limit, one.otherwise));
    }
  return list;
}

}  // namespace mariotte::report
