#include "measuring/stored_cases.hpp"

#include <cmath>
#include <map>

namespace mariotte::measuring {
namespace {

const std::map<std::string, const char*> texts = {
#include "stored_cases.inc"
};

}  // namespace

const nlohmann::json& cases(const std::string& name) {
  static std::map<std::string, nlohmann::json> parsed;
  auto& found = parsed[name];
  if (found.is_null()) found = nlohmann::json::parse(texts.at(name)).at("cases");
  return found;
}

bool same(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::abs(b);
}

}  // namespace mariotte::measuring
