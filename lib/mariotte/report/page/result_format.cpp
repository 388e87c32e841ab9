#include "mariotte/report/page/result_format.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/impact/quantities/quantity.hpp"
#include "mariotte/report/json/command_keys.hpp"
#include "mariotte/report/json/labels.hpp"

namespace mariotte::report {
namespace {

using impact::Cost;

constexpr const char* introduction = R"(# What a result says

<!-- This page is generated: build/tests/doc/doc_result_format > doc/result_format.md -->

`mariotte run --json` prints one object with these keys, and `--out` writes it as `result.json`; those of other
commands [come last](#mariotte-law). Numbers are in SI units and have 17 significant digits. A number that is
undefined is `null`; numbers of `validity` that the scene does not say enough for are left out.

`[]` stands for an index. Indices count from 0; balls, contacts and tips that are named in a value count from 1.
Each key of a run with a unit is also a [column of a sweep](sweeps.md#columns): `contacts[1].impulse`. A column may have
`[*]` for all indices, `[-1]` for the last one. `.count` after an array is its length: `events.count`.

Columns of `sweep.csv` are named by key and unit, `final.velocity[0] [m/s]`, as those of `trace.csv` are by symbol
and unit; pure numbers and words have no brackets. `sweep.h5` has the bare keys, with `units`, `symbol` and
`long_name` as attributes, and figures show symbol and unit.

CSV files begin with their header: comments before it would be taken for it by spreadsheets, by pandas and by
`csv.DictReader`. What made them – version, scene with its digest, overrides – is `provenance` in
`result.json` or `sweep.json` of the same folder; HDF5 files have it as attributes of the file.

`energy.csv` has a row per sample of a chain: `kinetic` of the balls of finite mass, `stored` in the contacts that
carry force, and `dissipated`, which is what both have lost since the start. This is a difference and so holds the
residual of the balance, where `energy.dissipated` is integrated. It is empty where gravity, drives or moving walls do
work, which samples do not show. Chains with a contact that yields or adheres have no such file, since gaps alone do not
tell what it stores; neither have networks, microbodies, bodies and chains of more than 1000 balls.

The last column of a table says what a number costs at each point of a sweep. Where there is no unit, it is the
cost of `.count`:

| Cost | What has to be done |
|---|---|
| brief | the quickest solver has it: no list of events, no peaks, no energy balance |
| whole | the whole run |
| peaks | the whole run, which searches every step for the largest value |

## Words

| Key | Meaning |
|---|---|
)";

const char* name(Cost cost) {
  return cost == Cost::brief ? "brief" : cost == Cost::whole ? "whole" : "peaks";
}

std::string cell(std::string text) {
  for (auto bar = text.find('|'); bar != text.npos; bar = text.find('|', bar + 2)) text.insert(bar, "\\");
  return text;
}

template <class Quantity>
std::string row(const Quantity& quantity) {
  const auto& [key, unit, symbol, meaning] = quantity.is;
  const bool is_number = !unit.empty();
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", key, cell(std::string(symbol)), is_number ? unit : "–",
                     cell(std::string(meaning)), is_number || quantity.count ? name(cost(quantity)) : "");
}

template <class Quantity, class Choose>
std::string table(const std::vector<Quantity>& list, const Choose& choose) {
  std::string text = "| Key | Symbol | Unit | Meaning | Cost |\n|---|---|---|---|---|\n";
  for (const auto& one : list)
    if (choose(one)) text += row(one);
  return text;
}

/// Whether a list has an entry that is described and costs the same.
template <class Quantity, class Other>
bool has_same(const std::vector<Quantity>& list, const Other& other) {
  return std::any_of(list.begin(), list.end(), [&](const Quantity& one) { return row(one) == row(other); });
}

std::string section(const CommandResult& result) {
  auto text = fmt::format("\n## {}\n\n", result.command);
  if (!result.about.empty()) text += fmt::format("{}\n\n", result.about);
  text += "| Key | Unit | Meaning |\n|---|---|---|\n";
  for (const auto& [key, unit, meaning] : result.keys)
    text += fmt::format("| `{}` | {} | {} |\n", key, unit.empty() ? "–" : unit, cell(std::string(meaning)));
  return text;
}

}  // namespace

std::string result_format() {
  const auto all = [](const auto&) { return true; };
  const auto& chain = impact::quantities<impact::ChainImpact>();
  std::string text = introduction;
  for (const auto& [key, meaning] : labels) text += fmt::format("| `{}` | {} |\n", key, meaning);
  text += "\n## Chains\n\n" + table(chain, all);
  text +=
      "\n## Contact networks\n\nAs of a chain, but for these keys; there is no `icr`, since contacts have no "
      "order, and of the momentum only the residual is told.\n";
  text += "Velocities of balls are in m/s, those of other degrees of freedom in the units of the scene.\n\n";
  text += table(impact::quantities<impact::NetworkImpact>(),
                [&](const auto& one) { return !has_same(chain, one); });
  text += "\n## Microbodies\n\nThe axis e1 is normal to the plane, e2 and e3 lie in it.\n\n";
  text += table(impact::quantities<impact::MicrobodyImpact>(), all);
  text += "\n## Bodies with friction\n\nVectors have two components in the plane and three in space.\n\n";
  text += table(impact::quantities<impact::BodiesImpact>(), all);
  for (const auto& one : command_results) text += section(one);
  return text;
}

}  // namespace mariotte::report
