#include "verdict_text.hpp"

#include <limits>
#include <nlohmann/json.hpp>

namespace mariotte::stress_study {
namespace {

/// JSON has no infinity.
double finite(double value) {
  return std::min(value, std::numeric_limits<double>::max());
}

}  // namespace

std::string packed(const Verdict& v) {
  return nlohmann::json{v.scene,         {finite(v.error[0]), finite(v.error[1]), finite(v.error[2])},
                        v.seconds,       v.naive,
                        v.counts_differ, v.failures,
                        v.limits,        v.refusals,
                        v.killed,        v.findings,
                        finite(v.worst), v.cost,
                        v.rivals,        v.left_out}
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

Verdict unpacked(const std::string& text) {
  const auto j = nlohmann::json::parse(text);
  return {.scene = j[0],
          .error = {j[1][0], j[1][1], j[1][2]},
          .worst = j[10],
          .seconds = j[2],
          .cost = j[11],
          .naive = j[3],
          .counts_differ = j[4],
          .left_out = j[13],
          .failures = j[5],
          .limits = j[6],
          .refusals = j[7],
          .killed = j[8],
          .rivals = j[12],
          .findings = j[9]};
}

}  // namespace mariotte::stress_study
