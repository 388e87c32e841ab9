#include "mariotte/report/json/propagation_json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using study::Propagation;
using study::UncertainOutcome;

Json outcome_json(const UncertainOutcome& outcome, bool sampled) {
  Json result{{"name", outcome.name},
              {"unit", outcome.unit},
              {"value", nullable(outcome.value)},
              {"deviation", nullable(outcome.deviation)},
              {"share", list(outcome.share, nullable)}};
  if (sampled) {
    result["mean"] = nullable(outcome.mean);
    result["sampled_deviation"] = nullable(outcome.sampled_deviation);
  }
  return result;
}

std::string shown(const std::optional<double>& value, const char* otherwise, int digits) {
  return value ? rounded(*value, digits) : otherwise;
}

/// What rounding alone makes is none.
double beyond_rounding(const UncertainOutcome& outcome) {
  return *outcome.deviation > 16 * epsilon * std::abs(outcome.value.value_or(0)) ? *outcome.deviation : 0;
}

/// "chain.radius 98 %".
std::string largest_share(const UncertainOutcome& outcome, const Propagation& of) {
  if (!outcome.deviation || beyond_rounding(outcome) == 0) return "–";
  std::size_t most = 0;
  for (std::size_t i = 0; i < outcome.share.size(); ++i) {
    if (!outcome.share[i]) return "–";
    if (*outcome.share[i] > *outcome.share[most]) most = i;
  }
  return fmt::format("{} {:.3g} %", of.inputs[most].key, 100 * *outcome.share[most]);
}

}  // namespace

Json json(const Propagation& propagation) {
  Json inputs = Json::array(), outcomes = Json::array();
  for (const auto& input : propagation.inputs)
    inputs.push_back({{"key", input.key}, {"value", input.value}, {"deviation", input.deviation}});
  const bool sampled = propagation.samples.count > 0;
  for (const auto& outcome : propagation.outcomes) outcomes.push_back(outcome_json(outcome, sampled));
  Json result{{"ending", hybrid::name(propagation.ending)},
              {"inputs", std::move(inputs)},
              {"outcomes", std::move(outcomes)},
              {"notes", propagation.notes}};
  if (sampled) {
    result["samples"] = propagation.samples.count;
    result["seed"] = propagation.samples.seed;
    result["others"] = propagation.others;
  }
  return result;
}

std::string table(const Propagation& propagation, const std::string& title) {
  std::string text = fmt::format("{}\n{} · deviations to first order", title.empty() ? "Uncertainty" : title,
                                 hybrid::name(propagation.ending));
  const bool sampled = propagation.samples.count > 0;
  if (sampled)
    text +=
        fmt::format(", beside {} samples of seed {}", propagation.samples.count, propagation.samples.seed);
  text += "\n\n";
  for (const auto& input : propagation.inputs)
    text += fmt::format("{} = {:.6g} ± {:.3g}\n", input.key, input.value, input.deviation);
  std::vector<std::string> head{"outcome", "unit", "value", "±", "most of it by"};
  if (sampled) head.insert(head.end(), {"mean of samples", "± of samples"});
  text += "\n" + columns(head, std::ssize(propagation.outcomes), [&](Index i) -> TableRow {
            const auto& one = propagation.outcomes[static_cast<std::size_t>(i)];
            TableRow row{one.name, one.unit, shown(one.value, "undefined", 10),
                         one.deviation ? shown(beyond_rounding(one), "", 4) : "none",
                         largest_share(one, propagation)};
            if (sampled)
              row.insert(row.end(), {shown(one.mean, "–", 10), shown(one.sampled_deviation, "–", 4)});
            return row;
          });
  if (propagation.others > 0)
    text += fmt::format(
        "\nnote: {} of {} samples end in another way, have other contacts, or make no scene; means and "
        "deviations are those of the rest, and the first order knows nothing of this\n",
        propagation.others, propagation.samples.count);
  for (const auto& note : propagation.notes) text += "\nnote: " + note + "\n";
  return text;
}

}  // namespace mariotte::report
