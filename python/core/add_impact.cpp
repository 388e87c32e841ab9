// What Python sees of an impact.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "impact_arrays.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/report/csv/csv_metadata.hpp"
#include "mariotte/report/figure/energy_plot.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/json/json_stream.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/page/html.hpp"
#include "mariotte/report/reason.hpp"
#include "mariotte/report/text.hpp"
#include "mariotte/report/trace_file.hpp"
#include "mariotte/study/sweep/columns.hpp"
#include "samples.hpp"

namespace mariotte::python {
namespace {

using Contacts = impact::ContactImpact;
using Body = impact::MicrobodyImpact;

/// A number of seconds, or text with a unit.
using Time = std::variant<double, std::string>;

double seconds(const Time& time) {
  return std::visit(Overload{[](double number) { return number; },
                             [](const std::string& text) { return parse_quantity(text, dimension::time); }},
                    time);
}

std::unique_ptr<Impact> simulate_scene(const SharedScene& box, std::optional<double> accuracy,
                                       const std::optional<Time>& until, const std::optional<Time>& max_time,
                                       std::optional<Index> max_events,
                                       const std::optional<std::string>& flow, bool estimate) {
  auto options = box->scene.run;
  const auto put = [&](const char* key, const auto& value, const auto& act) {
    if (value) of_option(key, [&] { act(*value), validate(options); });
  };
  put("accuracy", accuracy, [&](double one) { options.accuracy = one; });
  if (until || max_time) options.flies_on = until.has_value();
  put("max_time", max_time, [&](const Time& one) { options.max_time = seconds(one); });
  put("until", until, [&](const Time& one) { options.max_time = seconds(one); });
  put("max_events", max_events, [&](Index one) { options.max_events = one; });
  put("flow", flow, [&](const std::string& one) { options.flow = flow::parse_kind(one); });
  return std::make_unique<Impact>(box, options, until || (box->scene.until && !max_time), estimate);
}

/// What every result has.
template <class Of>
auto of_any(const Impact& impact, Of of) {
  return impact.brief() ? of(*impact.brief()) : std::visit(of, impact.whole());
}

double time(const Impact& impact) {
  return of_any(impact, Overload{[](const Body& one) { return one.final.time; },
                                 [](const auto& one) { return one.time; }});
}

/// Refuses an index for which this result has nothing, and [*], which stands for several numbers.
template <class Model>
void expect_index(const std::string& text, impact::Entry<Model> entry, std::size_t level,
                  const Model& whole) {
  const auto& array = *entry.arrays[level];
  const bool is_one = entry.at[level] != impact::every_index;
  if (is_one && impact::find_place(entry, whole, level + 1)) return;
  const auto count = array.count(whole, entry.at).value_or(0);
  throw py::key_error(text + " is no number of this result: it has " + std::to_string(count) + " of " +
                      std::string(array.is.key) + ", counted from 0");
}

/// What a sweep says of a column that it does not know, with the nearest known one.
[[noreturn]] void refuse(const Impact& impact, const std::string& text) {
  try {
    study::expand_columns({text}, impact.scene(), study::Counting::without_run);
  } catch (const study::ColumnError& error) {
    throw py::key_error(error.what());
  }
  throw py::key_error(text + " is no number of this result");
}

/// `look` at the entry of a key in the result.
template <class Look>
auto at_entry(const Impact& impact, const std::string& text, Look look) {
  const auto key = impact::parse_key(text);
  const auto look_up = [&]<class Model>(const Model& whole) {
    const auto entry = key ? impact::find_entry<Model>(*key) : std::nullopt;
    if (!entry) refuse(impact, text);
    return look(*entry, whole);
  };
  return std::visit(look_up, impact.whole());
}

/// One number of the result by its key.
double number(const Impact& impact, const std::string& text) {
  return at_entry(impact, text, [&](const auto& entry, const auto& whole) {
    for (std::size_t level = 0; entry.has_index(level); ++level) expect_index(text, entry, level, whole);
    return impact::number(entry, whole);
  });
}

/// The keys of this result that the first [*] of one stands for.
std::vector<std::string> keys(const Impact& impact, const std::string& pattern) {
  return at_entry(impact, pattern, [&](auto entry, const auto& whole) {
    std::size_t level = 0;
    for (; entry.at[level] != impact::every_index; ++level) expect_index(pattern, entry, level, whole);
    impact::find_place(entry, whole, level);
    std::vector<std::string> all(entry.arrays[level]->count(whole, entry.at).value_or(0), pattern);
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].replace(pattern.find("[*]"), 3, "[" + std::to_string(i) + "]");
    return all;
  });
}

/// Time, velocity, gap, force: a row per sample.
py::tuple arrays(Samples made) {
  const auto rows = std::ssize(made.time);
  return py::make_tuple(
      owned(std::move(made.time), {rows}), owned(std::move(made.velocity), {rows, made.velocities}),
      owned(std::move(made.gap), {rows, made.contacts}), owned(std::move(made.force), {rows, made.contacts}));
}

/// `look` without the lock.
template <class Look>
py::tuple looked(const Impact& impact, Look look) {
  impact.whole();
  Samples made;
  {
    const py::gil_scoped_release unlocked;
    made = look();
  }
  return arrays(std::move(made));
}

py::tuple sample_at(const Impact& impact, const std::vector<double>& times) {
  return looked(impact, [&] { return sample(impact, times); });
}
py::tuple steps_of(const Impact& impact) {
  return looked(impact, [&] { return steps(impact); });
}

/// Where a file of the impact comes from.
report::Attributes origin(const Impact& impact) {
  auto attributes = origin(impact.box());
  attributes.emplace_back("run", report::options(impact.options()).dump());
  return attributes;
}

/// As the command prints it, with these members besides.
std::string text_of(const Impact& impact, report::Json more) {
  more["provenance"] = provenance(impact.box());
  more["provenance"]["run"] = report::options(impact.options());
  std::string all;
  report::JsonStream stream([&](std::string_view piece) { all += piece; });
  std::visit([&](const auto& one) { report::write(stream, one, impact.scene(), more); }, impact.whole());
  return all;
}

void save_json(const Impact& impact, const std::string& path) {
  report::write_file(path, text_of(impact, {{"scene_text", impact.box().text}}));
}

/// All samples of a step each, as the command writes them, and beside them what they are.
void save_csv(const Impact& impact, const std::string& path) {
  const auto trace = report::trace_text(simulate(impact.box(), impact.options(), {.trace = true}));
  report::write_file(path, trace);
  const bool of_balls = std::holds_alternative<model::Chain>(impact.box().scene.model);
  const std::span<const impact::Description> known(impact::sampled.data(),
                                                   of_balls ? impact::sampled.size() : 0);
  const auto name = std::filesystem::path(path).filename().string();
  report::write_file(report::metadata_name(path), report::trace_metadata(name, trace, origin(impact), known));
}

/// Of a chain the tables of the command; of others, whose columns are of many kinds, those of the CSV.
void save_hdf5(const Impact& impact, const std::string& path) {
  const auto traced = simulate(impact.box(), impact.options(), {.trace = true});
  const auto* row = std::get_if<impact::ChainImpact>(&traced);
  if (!row) return report::write_hdf5_columns(path, report::trace_text(traced), origin(impact));
  const auto& trace = row->trace;
  const auto places = [](const auto& rows) {
    std::vector<Index> all(rows.empty() ? 0 : rows.front().size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  };
  const auto file = report::new_hdf5_trace(path, places(trace.velocity), places(trace.gap), origin(impact));
  for (std::size_t i = 0; i < trace.time.size(); ++i)
    file->add(
        {.time = trace.time[i], .velocity = trace.velocity[i], .gap = trace.gap[i], .force = trace.force[i]});
  file->commit();
}

/// Time, kinetic, stored and lost energy of a chain; nothing is lost where the samples do not show it.
py::tuple energy_course(const Impact& impact) {
  const auto* const chain = std::get_if<model::Chain>(&impact.box().scene.model);
  if (!chain) throw InvalidParameter("energies over time are known of chains only");
  if (!report::knows_energies(*chain))
    throw InvalidParameter("energies over time are not known of contacts that yield or adhere");
  report::EnergyCourse course;
  {
    const py::gil_scoped_release unlocked;
    const auto traced = simulate(impact.box(), impact.options(), {.trace = true});
    course = report::energy_course(std::get<impact::ChainImpact>(traced), *chain);
  }
  const auto array = [](std::vector<double>& values) {
    const auto count = std::ssize(values);
    return owned(std::move(values), {count});
  };
  return py::make_tuple(array(course.time), array(course.kinetic), array(course.stored), array(course.lost));
}

std::string to_cite(const Impact& impact) {
  auto result =
      std::visit([&](const auto& one) { return report::json(one, impact.scene()); }, impact.whole());
  std::string laws;
  for (const auto& law : impact.box().own_laws) laws += (laws.empty() ? "with the law " : ", ") + law;
  if (!laws.empty()) result["provenance"]["scene_sha256"] = laws;
  return report::to_cite(result);
}

}  // namespace

void add_impact(py::module_& module) {
  py::class_<Impact> type(module, "Impact");
  add_arrays(type);
  type.def_property_readonly("ending",
                             [](const Impact& impact) {
                               return static_cast<int>(of_any(impact, [](auto& one) { return one.ending; }));
                             })
      .def_property_readonly("message",
                             [](const Impact& impact) {
                               return of_any(impact, [&](auto& one) {
                                 return report::reason(one.ending, one.message, impact.scene());
                               });
                             })
      .def_property_readonly("time", &time)
      .def_property_readonly("warnings", &Impact::warnings)
      .def("number", &number, py::arg("key"))
      .def("keys", &keys, py::arg("pattern"))
      .def("json", [](const Impact& impact) { return text_of(impact, report::Json::object()); })
      .def("sample", &sample_at, py::arg("times"))
      .def("steps", &steps_of)
      .def("energy_course", &energy_course)
      .def("save_json", &save_json, py::arg("path"))
      .def("save_csv", &save_csv, py::arg("path"), py::call_guard<py::gil_scoped_release>())
      .def("save_hdf5", &save_hdf5, py::arg("path"), py::call_guard<py::gil_scoped_release>())
      .def("to_cite", &to_cite)
      .def("table", [](const Impact& impact) { return report::table_text(impact.whole(), impact.scene()); });
  module.def("simulate", &simulate_scene, py::arg("scene"), py::arg("accuracy"), py::arg("until"),
             py::arg("max_time"), py::arg("max_events"), py::arg("flow"), py::arg("estimate"));
}

}  // namespace mariotte::python
