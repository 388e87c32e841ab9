// What a note says of slopes, and of which.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {

/// Of slopes that are large, one-sided, uncertain or missing.
struct SlopeNote {
  std::string text = {};
  std::vector<std::string> outcomes = {};    ///< "velocity[0]", "time"; empty: all
  std::vector<std::string> parameters = {};  ///< by these; empty: by all
  double error = infinity;  ///< by how much of their natural size slopes may be off; zero where they hold
};

/// Whether a note is about the slope of an outcome by a parameter.
inline bool concerns(const SlopeNote& note, const std::string& outcome, const std::string& parameter) {
  const auto has = [](const std::vector<std::string>& list, const std::string& name) {
    return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
  };
  return has(note.outcomes, outcome) && has(note.parameters, parameter);
}

/// What notes say, in their order, and of which parameters.
inline std::vector<std::string> texts(const std::vector<SlopeNote>& notes) {
  constexpr std::size_t most_names = 4;
  std::vector<std::string> list;
  for (const auto& note : notes) {
    auto& text = list.emplace_back(note.text);
    const auto& names = note.parameters;
    if (names.size() > most_names) text += " (by " + std::to_string(names.size()) + " parameters)";
    if (names.empty() || names.size() > most_names) continue;
    for (const auto& name : names) text += (&name == &names.front() ? " (by " : ", ") + name;
    text += ")";
  }
  return list;
}

}  // namespace mariotte::impact
