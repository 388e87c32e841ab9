// Sweeps of a scene in memory: a table of numbers, one row per point.
#include "mariotte/study/sweep/sweep.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interruption.hpp"
#include "mariotte/impact/doubt.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"
#include "mariotte/report/figure/value_axis.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/sweep_file.hpp"
#include "mariotte/report/sweep_warnings.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "scene_box.hpp"

namespace mariotte::python {
namespace {

using scene::Node;
using scene::Place;

/// One key, its values, and whether it moves along with the one before.
using Axis = std::tuple<std::string, py::list, bool>;

using Endings = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

constexpr auto last_ending = static_cast<std::uint8_t>(hybrid::Ending::failed);

/// As the numbers of mariotte.Ending; "rejected" is one more.
std::uint8_t number_of(const std::string& ending) {
  std::uint8_t number = 0;
  while (number <= last_ending && hybrid::name(static_cast<hybrid::Ending>(number)) != ending) ++number;
  return number;
}

class Sweep {
 public:
  Sweep(study::SweepPlan plan, report::Attributes origin)
      : plan_(std::move(plan)),
        origin_(std::move(origin)),
        table_(static_cast<std::size_t>(plan_.design.points()) * plan_.columns.size()),
        ending_(static_cast<std::size_t>(plan_.design.points())) {}

  const study::SweepPlan& plan() const { return plan_; }
  const report::Attributes& origin() const { return origin_; }
  const std::vector<double>& table() const { return table_; }
  const std::vector<std::uint8_t>& ending() const { return ending_; }
  const std::map<Index, std::string>& reasons() const { return reasons_; }

  /// Called without the lock.
  void compute(int threads) {
    const study::Dealer all({{.first = 0, .count = plan_.design.points()}}, {});
    run(
        plan_, all, threads, [&]() -> study::Keep { return [&](const auto& batch) { keep(batch); }; },
        [interruption = Interruption()](const study::Progress&) mutable { return interruption(), true; });
  }

  /// What another one has computed.
  void put(std::vector<double> table, std::vector<std::uint8_t> ending,
           std::map<Index, std::string> reasons) {
    if (table.size() != table_.size() || ending.size() != ending_.size())
      throw py::value_error("a sweep of another version of mariotte, which has other columns");
    table_ = std::move(table);
    ending_ = std::move(ending);
    reasons_ = std::move(reasons);
  }

  /// That of the scene, and that points are less exact than was asked.
  std::vector<std::string> warnings() const {
    auto list = plan_.warnings;
    const auto doubtful = std::ranges::count_if(
        reasons_, [](const auto& reason) { return impact::tells_doubt(reason.second); });
    if (doubtful > 0) list.push_back(report::less_exact(doubtful));
    return list;
  }

  /// The rows, as the command writes them, some thousand at a time.
  void write(const std::function<void(const std::string&)>& take) const {
    constexpr Index most = 4096;
    for (Index first = 0; first < plan_.design.points(); first += most) {
      std::string text;
      report::append_rows(plan_.design, batch(first, std::min(most, plan_.design.points() - first)), text);
      take(text);
    }
  }

 private:
  void keep(const study::Batch& batch) {
    const auto columns = std::ssize(plan_.columns);
    std::copy(batch.numbers.begin(), batch.numbers.end(), table_.begin() + batch.first * columns);
    for (Index k = 0; k < batch.count(); ++k) {
      const auto& verdict = batch.verdicts[static_cast<std::size_t>(k)];
      ending_[static_cast<std::size_t>(batch.first + k)] = number_of(verdict.ending);
      if (verdict.reason.empty()) continue;
      const std::lock_guard lock(mutex_);
      reasons_[batch.first + k] = verdict.reason;
    }
  }

  study::Batch batch(Index first, Index count) const {
    const auto columns = std::ssize(plan_.columns);
    const auto start = table_.begin() + first * columns;
    study::Batch made{.first = first, .numbers = {start, start + count * columns}, .verdicts = {}};
    for (Index point = first; point < first + count; ++point) {
      const auto reason = reasons_.find(point);
      made.verdicts.push_back({.ending = std::string(name(ending_[static_cast<std::size_t>(point)])),
                               .reason = reason == reasons_.end() ? "" : reason->second});
    }
    return made;
  }

  static const char* name(std::uint8_t ending) {
    return ending > last_ending ? "rejected" : hybrid::name(static_cast<hybrid::Ending>(ending));
  }

  study::SweepPlan plan_;
  report::Attributes origin_;
  std::vector<double> table_;
  std::vector<std::uint8_t> ending_;
  std::map<Index, std::string> reasons_;
  std::mutex mutex_;
};

Node node(const py::handle& value, const Place& place) {
  if (py::isinstance<py::bool_>(value)) return {value.cast<bool>(), place};
  if (py::isinstance<py::int_>(value)) return {value.cast<std::int64_t>(), place};
  if (py::isinstance<py::float_>(value)) return {value.cast<double>(), place};
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>(), place};
  throw py::type_error("the values of a sweep are numbers, text, True or False");
}

Node axis_node(const Axis& axis, const Place& place) {
  const auto& [key, values, zipped] = axis;
  scene::Array list;
  for (const auto& value : values) list.push_back(node(value, place));
  scene::Table table{{"key", place, {key, place}}, {"values", place, {std::move(list), place}}};
  if (zipped) table.push_back({"zip", place, {true, place}});
  return {std::move(table), place};
}

/// The axes in place of the scene's own.
void put_axes(scene::Document& document, const std::vector<Axis>& axes) {
  if (axes.empty()) return;
  scene::Array tables;
  for (const auto& axis : axes)
    tables.push_back(axis_node(axis, add_origin(document.source, "sweep of " + std::get<0>(axis))));
  auto& root = *document.tree.table();
  std::erase_if(root, [](const scene::Entry& entry) { return entry.key == "sweep"; });
  const auto place = tables.front().place;
  root.push_back({"sweep", place, {std::move(tables), place}});
}

/// Without numbers; called with the lock.
std::unique_ptr<Sweep> planned(const SceneBox& box, const std::vector<Axis>& axes,
                               const std::vector<std::string>& columns) {
  auto document = box.document;
  put_axes(document, axes);
  if (!axes.empty() && !columns.empty())  // the scene's own may be of its own variables
    std::erase_if(*document.tree.table(), [](const scene::Entry& entry) { return entry.key == "columns"; });
  const py::gil_scoped_release unlocked;
  return std::make_unique<Sweep>(study::read_sweep(std::move(document), columns), origin(box));
}

std::unique_ptr<Sweep> sweep(const SceneBox& box, const std::vector<Axis>& axes,
                             const std::vector<std::string>& columns, int threads) {
  auto made = planned(box, axes, columns);
  const py::gil_scoped_release unlocked;
  made->compute(threads);
  return made;
}

/// One that was computed elsewhere.
std::unique_ptr<Sweep> restored_sweep(const SceneBox& box, const std::vector<Axis>& axes,
                                      const std::vector<std::string>& columns, const Numbers& table,
                                      const Endings& ending, std::map<Index, std::string> reasons) {
  auto made = planned(box, axes, columns);
  made->put({table.data(), table.data() + table.size()}, {ending.data(), ending.data() + ending.size()},
            std::move(reasons));
  return made;
}

py::list columns(const Sweep& sweep) {
  py::list all;
  for (const auto& one : sweep.plan().columns)
    all.append(
        py::make_tuple(one.key, std::string(one.unit), std::string(one.symbol), std::string(one.meaning)));
  return all;
}

const study::Column& column_of(const Sweep& sweep, const std::string& key) {
  for (const auto& one : sweep.plan().columns)
    if (one.key == key) return one;
  throw py::key_error(key);
}

std::vector<Index> shape(const Sweep& sweep) {
  std::vector<Index> counts;
  for (const auto& axis : sweep.plan().design.axes) counts.push_back(axis.count);
  return counts;
}

/// Values in SI along an axis, or words.
py::object values_of(const study::Design& design, std::size_t i) {
  const auto& one = design.parameters[i];
  const auto& axis = design.axes[static_cast<std::size_t>(one.axis)];
  if (!is_numeric(one)) return py::cast(report::value_names(one));
  std::vector<double> values;
  for (Index k = 0; k < axis.count; ++k) values.push_back(number(design, i, k * axis.stride));
  const auto count = std::ssize(values);
  return owned(std::move(values), {count});
}

/// Of every key that is varied: its axis, its values, and their unit.
py::list parameters(const Sweep& sweep) {
  const auto& design = sweep.plan().design;
  py::list all;
  for (std::size_t i = 0; i < design.parameters.size(); ++i) {
    const auto& one = design.parameters[i];
    all.append(py::make_tuple(one.key, one.axis, values_of(design, i), one.unit));
  }
  return all;
}

/// What stands beside an axis and in a legend, in gnuplot's enhanced text; `shown` is the key without the
/// indices of several columns.
std::string long_label(const Sweep& sweep, const std::string& key, const std::string& shown) {
  for (const auto& one : sweep.plan().design.parameters)
    if (one.key == key) return report::parameter_name(one);
  return report::long_label(shown, column_of(sweep, key));
}

std::string short_label(const Sweep& sweep, const std::string& key) {
  return report::short_label(column_of(sweep, key));
}

void save_sweep_csv(const Sweep& sweep, const std::string& path) {
  report::NewFile file(path);
  file.append(report::sweep_header(sweep.plan().design, sweep.plan().columns));
  sweep.write([&](const std::string& rows) { file.append(rows); });
  file.commit();
}

void save_sweep_hdf5(const Sweep& sweep, const std::string& path) {
  const auto file = report::new_hdf5_sweep(path, sweep.plan().design, sweep.plan().columns, sweep.origin());
  sweep.write([&](const std::string& rows) { file->add(rows); });
  file->commit();
}

}  // namespace

void add_sweep(py::module_& module) {
  py::class_<Sweep>(module, "Sweep")
      .def_property_readonly("shape", &shape)
      .def_property_readonly("columns", &columns)
      .def_property_readonly("parameters", &parameters)
      .def_property_readonly("warnings", &Sweep::warnings)
      .def_property_readonly("reasons", &Sweep::reasons)
      .def_property_readonly("table",
                             [](const py::object& self) {
                               const auto& one = self.cast<const Sweep&>();
                               const auto columns = std::ssize(one.plan().columns);
                               const py::ssize_t size = sizeof(double);
                               return view(one.table().data(), {one.plan().design.points(), columns},
                                           {columns * size, size}, self);
                             })
      .def_property_readonly(
          "ending", [](const py::object& self) { return view(self.cast<const Sweep&>().ending(), self); })
      .def("long_label", &long_label, py::arg("key"), py::arg("shown"))
      .def("short_label", &short_label, py::arg("key"))
      .def("save_csv", &save_sweep_csv, py::arg("path"), py::call_guard<py::gil_scoped_release>())
      .def("save_hdf5", &save_sweep_hdf5, py::arg("path"), py::call_guard<py::gil_scoped_release>());
  module.def("sweep", &sweep, py::arg("scene"), py::arg("axes"), py::arg("columns"), py::arg("threads"));
  module.def("restored_sweep", &restored_sweep, py::arg("scene"), py::arg("axes"), py::arg("columns"),
             py::arg("table"), py::arg("ending"), py::arg("reasons"));
}

}  // namespace mariotte::python
