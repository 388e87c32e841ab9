#include "mariotte/scene/run_reader.hpp"

#include <array>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/error_list.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 8> run_keys{"until",   "accuracy", "max_time", "max_events",
                                                   "gravity", "impacts",  "flow",     "after_capture"};
constexpr Index no_limit = 1'000'000'000'000'000;  // still a whole number in a double

double read_accuracy(Source& source, const Field& field) {
  const double accuracy = number(source, field, dimension::none, Domain::finite);
  if (!(accuracy > 0 && accuracy < 1)) reject(source, field, fault::out_of_range, "must be between 0 and 1");
  if (accuracy < 1e-14) warn(source, field, "finer than double precision can give");
  if (accuracy > 1e-2) warn(source, field, "so coarse that the result says little");
  return accuracy;
}

std::optional<flow::Kind> read_flow(const Source& source, const Field& field) try {
  return flow::parse_kind(text(source, field));
} catch (const InvalidParameter& problem) {
  reject(source, field, problem.fault, problem.what());
}

void read_until(const Source& source, const Field& run, const Field& until, hybrid::Options& options) {
  if (find(run, "max_time"))
    reject(source, until, fault::contradiction, "'max_time' is given, too; give one of them");
  options.max_time = number(source, until, dimension::time, Domain::positive);
  options.flies_on = true;
}

}  // namespace

hybrid::Options read_run(Source& source, const Field& run, bool of_body) {
  if (!run.node->table()) expect_keys(source, run, run_keys);  // says that it is no table
  hybrid::Options options;
  ErrorList errors;
  const auto part = [&](const char* key, auto&& read) {
    if (const auto field = find(run, key)) errors.attempt([&] { read(*field); });
  };
  errors.attempt([&] { expect_keys(source, run, run_keys); });
  part("accuracy", [&](const Field& field) { options.accuracy = read_accuracy(source, field); });
  part("max_time", [&](const Field& field) {
    options.max_time = number(source, field, dimension::time, Domain::positive_or_infinite);
  });
  part("until", [&](const Field& field) { read_until(source, run, field, options); });
  part("max_events", [&](const Field& field) { options.max_events = whole(source, field, 1, no_limit); });
  part("flow", [&](const Field& field) { options.flow = read_flow(source, field); });
  if (!of_body) {
    for (const auto* key : {"impacts", "after_capture"})
      if (const auto field = find(run, key)) warn(source, *field, "has no effect without a [body]");
    part("impacts", [&](const Field& field) { whole(source, field, 1, no_limit); });
  }
  errors.raise();
  return options;
}

}  // namespace mariotte::scene
