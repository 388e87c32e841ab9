#include "mariotte/scene/run_reader.hpp"

#include <array>

#include "mariotte/core/error.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 8> keys{"until",   "accuracy", "max_time", "max_events",
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

}  // namespace

hybrid::Options read_run(Source& source, const Field& run, bool of_body) {
  expect_keys(source, run, keys);
  hybrid::Options options;
  if (const auto field = find(run, "accuracy")) options.accuracy = read_accuracy(source, *field);
  if (const auto field = find(run, "max_time"))
    options.max_time = number(source, *field, dimension::time, Domain::positive_or_infinite);
  if (const auto field = find(run, "until")) {
    if (find(run, "max_time"))
      reject(source, *field, fault::contradiction, "'max_time' is given, too; give one of them");
    options.max_time = number(source, *field, dimension::time, Domain::positive);
    options.flies_on = true;
  }
  if (const auto field = find(run, "max_events")) options.max_events = whole(source, *field, 1, no_limit);
  if (const auto field = find(run, "flow")) options.flow = read_flow(source, *field);
  if (of_body) return options;
  for (const auto* key : {"impacts", "after_capture"})
    if (const auto field = find(run, key)) warn(source, *field, "has no effect without a [body]");
  if (const auto field = find(run, "impacts")) whole(source, *field, 1, no_limit);
  return options;
}

}  // namespace mariotte::scene
