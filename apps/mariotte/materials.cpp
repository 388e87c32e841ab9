#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/scene/material_library.hpp"

namespace mariotte::command {
namespace {

using scene::NamedMaterial;
using scene::Sourced;

/// Calls visit(key, value) for each value a material has.
template <class Visit>
void each_value(const NamedMaterial& material, Visit visit) {
  visit("young", material.young);
  visit("poisson", material.poisson);
  visit("density", material.density);
  if (material.yield_strength) visit("yield_strength", *material.yield_strength);
}

std::string table() {
  const auto all = scene::named_materials();
  const auto row = [&](Index i) -> report::TableRow {
    const auto& one = all[static_cast<std::size_t>(i)];
    return {std::string(one.name), fmt::format("{:g}", one.young.value / 1e9),
            fmt::format("{:g}", one.poisson.value), fmt::format("{:g}", one.density.value),
            one.yield_strength ? fmt::format("{:g}", one.yield_strength->value / 1e6) : "–"};
  };
  return report::columns({"material", "young [GPa]", "poisson", "density [kg/m³]", "yield strength [MPa]"},
                         std::ssize(all), row) +
         "\n–: brittle, it breaks before it yields; runs are not checked against yield\n";
}

std::string sources() {
  std::string text;
  for (const auto& material : scene::named_materials()) {
    text += fmt::format("\n{}: {}\n", material.name, material.kind);
    each_value(material, [&](const char* key, const Sourced& value) {
      text += fmt::format("  {}: {}\n", key, value.source);
    });
    if (!material.yield_strength) text += "  yield_strength: none, it is brittle\n";
  }
  return text;
}

report::Json json() {
  auto list = report::Json::object();
  for (const auto& material : scene::named_materials()) {
    auto& entry = list[std::string(material.name)] = {{"kind", material.kind}};
    each_value(material, [&](const char* key, const Sourced& value) {
      entry[key] = {{"value", value.value}, {"source", value.source}};
    });
  }
  return list;
}

constexpr const char* footer = R"(In a scene: material = "steel", for balls, walls, a body and its surface.
The values are typical ones; a material of your own is { young = …, poisson = …, density = …,
yield_strength = … }; the last two are not needed for a stiffness.
)";

}  // namespace

Command materials_command() {
  auto as_json = std::make_shared<bool>(false);
  return {.name = "materials",
          .about = "List the materials that scenes can name, with the source of each value",
          .footer = footer,
          .options = {{"--json", as_json.get(), "One JSON object on stdout, in SI units"}},
          .act = [as_json] {
            print(*as_json ? report::text(json()) : table() + sources());
            return ExitCode::ok;
          }};
}

}  // namespace mariotte::command
