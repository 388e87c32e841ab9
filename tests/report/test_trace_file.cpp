#define BOOST_TEST_MODULE report_trace_file
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "mariotte/report/page/files.hpp"
#include "mariotte/report/trace_file.hpp"
#include "support/folder.hpp"
#ifdef MARIOTTE_HDF5
#include <H5Cpp.h>
#include <hdf5_hl.h>
#endif

namespace report = mariotte::report;
namespace fs = std::filesystem;
using mariotte::Index;
using mariotte::test::content;
using mariotte::test::Folder;

namespace {

const std::vector<Index> balls = {0, 4, 9}, contacts = {2, 7};

/// Row i of a trace whose every number says where it belongs.
mariotte::impact::Sample sample(int i) {
  const double t = i;
  return {
      .time = t, .velocity = {t, t + 0.1, t + 0.2}, .gap = {t + 0.3, t + 0.4}, .force = {t + 0.5, t + 0.6}};
}

struct Killed : Folder {
  /// Rows into a file, in a process that is killed before it has committed it; what it leaves.
  fs::path killed(const std::string& name, int rows) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const auto trace = report::new_trace_file(path / name, balls, contacts);
      for (int i = 0; i < rows; ++i) trace->add(sample(i));
      ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    BOOST_TEST(!fs::exists(path / name));
    return fs::directory_iterator(path)->path();
  }
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(rows_of_csv_are_there_as_soon_as_they_are_added, Killed) {
  const auto text = content(killed("wave.csv", 1000));
  BOOST_TEST(
      text.starts_with("time [s],v1 [m/s],v5 [m/s],v10 [m/s],gap3 [m],gap8 [m],force3 [N],force8 [N]\n0,"));
  BOOST_TEST(std::count(text.begin(), text.end(), '\n') == 1001);
  BOOST_TEST(text.ends_with('\n'));
}

BOOST_FIXTURE_TEST_CASE(a_csv_trace_is_described_beside_it, Folder) {
  const auto trace = report::new_trace_file(path / "wave.csv", balls, contacts, {{"version", "0.1.0"}});
  trace->add(sample(0));
  trace->commit();
  const auto all = nlohmann::json::parse(content(path / "wave.csv-metadata.json"));
  BOOST_TEST(all["@context"] == "http://www.w3.org/ns/csvw");
  BOOST_TEST(all["url"] == "wave.csv");
  BOOST_TEST(all["notes"] == nlohmann::json::parse(R"([{"version": "0.1.0"}])"));
  const auto& columns = all["tableSchema"]["columns"];
  BOOST_TEST_REQUIRE(columns.size() == 8);
  BOOST_TEST(columns[0]["titles"] == "time [s]");
  BOOST_TEST(columns[3] == nlohmann::json::parse(R"({"titles": "v10 [m/s]", "name": "v10",
      "datatype": "number", "schema:unitText": "m/s", "dc:description": "velocity of the ball"})"));
  BOOST_TEST(columns[7]["name"] == "force8");
  BOOST_TEST(columns[7]["schema:unitText"] == "N");
}

BOOST_FIXTURE_TEST_CASE(a_csv_trace_that_is_left_is_described_as_well, Folder) {
  const auto left = report::new_trace_file(path / "wave.csv", balls, contacts)->leave();
  const auto all = nlohmann::json::parse(content(left.string() + "-metadata.json"));
  BOOST_TEST(all["url"] == left.filename().string());
}

BOOST_FIXTURE_TEST_CASE(a_trace_that_is_not_committed_leaves_nothing, Folder) {
  for (const char* name : {"wave.csv", "wave.h5"}) try {
      report::new_trace_file(path / name, balls, contacts)->add(sample(0));
    } catch (const report::FileError&) {  // built without HDF5
    }
  BOOST_TEST(fs::is_empty(path));
}

#ifdef MARIOTTE_HDF5

namespace {

std::vector<double> numbers(const H5::H5File& file, const char* name, std::vector<hsize_t> expected) {
  const auto table = file.openDataSet(name);
  const auto space = table.getSpace();
  std::vector<hsize_t> extent(space.getSimpleExtentNdims());
  space.getSimpleExtentDims(extent.data());
  BOOST_TEST(extent == expected, boost::test_tools::per_element());
  std::vector<double> values(space.getSimpleExtentNpoints());
  table.read(values.data(), H5::PredType::NATIVE_DOUBLE);
  return values;
}

std::string attribute(const H5::H5File& file, const char* dataset, const char* name) {
  const auto found = file.openDataSet(dataset).openAttribute(name);
  std::string text;
  found.read(found.getStrType(), text);
  return text;
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(hdf5_holds_the_tables_their_units_and_what_columns_are, Folder) {
  const hsize_t rows = 20000;  // more than one chunk
  const auto trace = report::new_trace_file(path / "wave.h5", balls, contacts, {{"scene", "a.toml"}});
  for (int i = 0; i < static_cast<int>(rows); ++i) trace->add(sample(i));
  trace->commit();
  BOOST_TEST(entries() == 1);

  const H5::H5File file((path / "wave.h5").string(), H5F_ACC_RDONLY);
  BOOST_TEST(numbers(file, "ball", {3}) == (std::vector<double>{1, 5, 10}), boost::test_tools::per_element());
  BOOST_TEST(numbers(file, "contact", {2}) == (std::vector<double>{3, 8}), boost::test_tools::per_element());
  const auto time = numbers(file, "time", {rows}), velocity = numbers(file, "velocity", {rows, 3}),
             gap = numbers(file, "gap", {rows, 2}), force = numbers(file, "force", {rows, 2});
  for (int i = 0; i < static_cast<int>(rows); ++i) {
    const auto row = sample(i);
    BOOST_REQUIRE(time[i] == row.time);
    BOOST_REQUIRE(std::equal(row.velocity.begin(), row.velocity.end(), &velocity[3 * i]));
    BOOST_REQUIRE(std::equal(row.gap.begin(), row.gap.end(), &gap[2 * i]));
    BOOST_REQUIRE(std::equal(row.force.begin(), row.force.end(), &force[2 * i]));
  }
  const auto is_axis = [&](const char* data, unsigned dimension, const char* axis) {
    return H5DSis_attached(file.openDataSet(data).getId(), file.openDataSet(axis).getId(), dimension) > 0;
  };
  for (const auto* data : {"velocity", "gap", "force"}) BOOST_TEST(is_axis(data, 0, "time"));
  BOOST_TEST(
      (is_axis("velocity", 1, "ball") && is_axis("gap", 1, "contact") && is_axis("force", 1, "contact")));
  std::string scene;
  file.openAttribute("scene").read(file.openAttribute("scene").getStrType(), scene);
  BOOST_TEST(std::string(scene.c_str()) == "a.toml");
  BOOST_TEST(attribute(file, "time", "units") == "s");
  BOOST_TEST(attribute(file, "velocity", "units") == "m/s");
  BOOST_TEST(attribute(file, "gap", "units") == "m");
  BOOST_TEST(attribute(file, "force", "units") == "N");
  BOOST_TEST(attribute(file, "force", "long_name") == "force of the contact");
}

BOOST_FIXTURE_TEST_CASE(a_killed_run_leaves_hdf5_that_can_be_read, Killed) {
  constexpr hsize_t added = 100000, pending = 262144 / 3 + 1;  // that many at most, and those of a second
  const H5::H5File file(killed("wave.h5", added).string(), H5F_ACC_RDONLY);
  const hsize_t rows = file.openDataSet("time").getSpace().getSimpleExtentNpoints();
  BOOST_TEST(rows >= added - pending);
  BOOST_TEST(numbers(file, "time", {rows}).back() == rows - 1);
}

BOOST_FIXTURE_TEST_CASE(hdf5_that_cannot_be_written_is_named, Folder) {
  const auto nowhere = path / "no" / "wave.h5";
  BOOST_CHECK_EXCEPTION(report::new_trace_file(nowhere, balls, contacts), report::FileError,
                        [&](const auto& error) {
                          return std::string(error.what()).starts_with("cannot write " + nowhere.string());
                        });
}

#endif
