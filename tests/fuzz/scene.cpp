// Any bytes as a scene, and as a table of measurements: they are read, or rejected with a place and a reason,
// and nothing else happens.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "mariotte/study/fit/measurements.hpp"
#include "mariotte/study/sweep/design_reader.hpp"

namespace {

using namespace mariotte;

/// A rejection says "name:line:column: why" on one line.
void expect_readable(const std::string& what) {
  if (!what.starts_with("fuzz") || what.find('\n') != std::string::npos || what.size() > 4000) std::abort();
}

void understand(const scene::Document& document, scene::Purpose purpose) try {
  scene::resolve(document, purpose);
} catch (const scene::SceneError& error) {
  expect_readable(error.what());
}

void read(const std::string& text) try {
  auto document = scene::parse_document(text, "fuzz");
  for (const auto purpose : {scene::Purpose::simulation, scene::Purpose::law}) understand(document, purpose);
  const auto design = study::read_design(document);
  for (const Index point : {Index{0}, design.points() / 2, design.points() - 1}) study::values(design, point);
} catch (const scene::SceneError& error) {
  expect_readable(error.what());
}

/// The first line, if it is `--set KEY=VALUE`, is an override of the rest.
void read_with_override(const std::string& text) try {
  const auto end = text.find('\n');
  const std::string flag = "--set ";
  if (!text.starts_with(flag) || end == std::string::npos) return read(text);
  scene::parse(text.substr(end + 1), "fuzz", {text.substr(flag.size(), end - flag.size())});
} catch (const scene::SceneError& error) {
  const std::string what = error.what();
  if (!what.starts_with("--set ")) expect_readable(what);
}

void read_table(const std::string& text) try {
  study::parse_measurements(text, "fuzz");
} catch (const scene::SceneError& error) {
  expect_readable(error.what());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_with_override(text);
  read_table(text);
  return 0;
}
