#include "mariotte/report/csv.hpp"

#include <fmt/format.h>

#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

std::string from_one(const std::vector<Index>& positions) {
  std::vector<Index> counted;
  for (const Index position : positions) counted.push_back(position + 1);
  return fmt::format("{}", fmt::join(counted, " "));
}

std::string names(const std::string& quantity, std::size_t count, const std::string& unit) {
  std::string text;
  for (std::size_t i = 1; i <= count; ++i) text += fmt::format(",{}{} [{}]", quantity, i, unit);
  return text;
}

void append(std::string& text, const std::vector<double>& values) {
  for (const double value : values) text.append(",").append(exact(value));
}

}  // namespace

std::string events_csv(const impact::ChainImpact& impact) {
  std::string text = "time [s],open,close\n";
  for (const auto& event : impact.events)
    text += fmt::format("{},{},{}\n", exact(event.time), from_one(event.open), from_one(event.close));
  return text;
}

std::string trace_csv(const impact::ChainImpact& impact) {
  const auto& trace = impact.trace;
  const std::size_t contacts = impact.contacts.size();
  std::string text = "time [s]" + names("v", impact.velocity.size(), "m/s") + names("gap", contacts, "m") +
                     names("force", contacts, "N") + "\n";
  for (std::size_t row = 0; row < trace.time.size(); ++row) {
    text += exact(trace.time[row]);
    append(text, trace.velocity[row]);
    append(text, trace.gap[row]);
    append(text, trace.force[row]);
    text += "\n";
  }
  return text;
}

}  // namespace mariotte::report
