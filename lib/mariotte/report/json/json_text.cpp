#include <nlohmann/json.hpp>

#include "mariotte/report/json/json.hpp"
#include "mariotte/report/json/json_stream.hpp"

namespace mariotte::report {

std::string text(const Json& json) {
  std::string all;
  JsonStream stream([&](std::string_view piece) { all += piece; });
  stream.value(json);
  return all;
}

}  // namespace mariotte::report
