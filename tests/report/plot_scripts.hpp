// Scripts of figures of runs that are made up.
#pragma once
#include <string>

#include "mariotte/report/figure/plot.hpp"

namespace mariotte::test {

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline impact::Trace trace_of(std::size_t balls) {
  impact::Trace trace;
  for (const double time : {0.0, 5e-5}) {
    trace.time.push_back(time);
    trace.velocity.emplace_back(balls, 1.0);
    trace.gap.emplace_back(balls - 1, 0.0);
    trace.force.emplace_back(balls - 1, 2e4);
  }
  return trace;
}

inline report::RunPlot plot_of(std::size_t balls, const std::string& title = "") {
  impact::ChainImpact impact;
  impact.trace = trace_of(balls);
  return report::plot(impact, title);
}

inline impact::ChainImpact impact_of(const impact::Trace& trace) {
  impact::ChainImpact impact;
  impact.trace = trace;
  return impact;
}

inline std::string script_of(const impact::Trace& trace) {
  return report::plot(impact_of(trace), "").script;
}

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

inline constexpr std::size_t terminals = 3;

}  // namespace mariotte::test
