// Reference cases from tests/data/laws as chains and numbers: computed in extended precision by two programs
// that share nothing with this one, good to eleven digits and more.
#pragma once
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"

namespace mariotte::test {

inline nlohmann::json law_cases(const std::string& file) {
  std::ifstream in(std::string(MARIOTTE_TEST_DATA) + "/laws/" + file);
  return nlohmann::json::parse(in);
}

/// A law by its name and numbers.
inline contact::Law law_of(const nlohmann::json& c) {
  const auto name = c.at("law").get<std::string>();
  for (const auto& law : contact::named_laws) {
    if (law.name != name) continue;
    contact::LawNumbers numbers;
    if (law.exponent) numbers.exponent = *law.exponent;
    for (const auto& key : law.keys) numbers.*key.number = c.value(std::string(key.key), numbers.*key.number);
    return law.make(numbers);
  }
  throw std::runtime_error("no law is called " + name);
}

inline std::vector<double> sizes(const nlohmann::json& list) {
  std::vector<double> values;
  for (const auto& value : list) values.push_back(value.is_string() ? infinity : value.get<double>());
  return values;
}

inline model::Chain chain_of(const nlohmann::json& c) {
  model::Chain chain{.mass = sizes(c.at("mass")),
                     .law = {},
                     .gap = sizes(c.at("gap")),
                     .velocity = sizes(c.at("velocity")),
                     .precompressed = c.value("precompressed", false)};
  for (const auto& law : c.at("contact")) chain.law.push_back(law_of(law));
  return chain;
}

/// What happened to which contact, when.
struct LawEvent {
  std::string what;
  Index contact;
  double time;
};

/// Closings at the start, which not every program counts, left out.
inline std::vector<LawEvent> events_of(const impact::ContactImpact& impact) {
  using impact::Event;
  std::vector<LawEvent> list;
  for (const auto& event : impact.events) {
    const auto add = [&](const std::vector<Index>& contacts, const char* what) {
      for (const Index j : contacts) list.push_back({what, j, event.time});
    };
    add(event.open, "open");
    if (event.time > 0) add(event.close, "close");
    add(event.yield, "yield");
    add(event.unload, "unload");
  }
  return list;
}

/// The same of a reference, whose slack contacts have opened before.
inline std::vector<LawEvent> events_of(const nlohmann::json& c) {
  std::vector<LawEvent> list;
  for (const auto& event : c.at("events")) {
    const auto from = event.at("from").get<std::string>(), to = event.at("to").get<std::string>();
    if (from == "slack" && to == "open") continue;
    const char* what = from == "open" || from == "slack" ? "close"
                       : to == "open" || to == "slack"   ? "open"
                       : to == "plastic"                 ? "yield"
                                                         : "unload";
    list.push_back({what, event.at("contact"), event.at("time")});
  }
  return list;
}

}  // namespace mariotte::test
