#define BOOST_TEST_MODULE report_sweep_file
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/report/page/files.hpp"
#include "mariotte/report/sweep_file.hpp"
#include "support/folder.hpp"
#ifdef MARIOTTE_HDF5
#include <H5Cpp.h>
#include <hdf5_hl.h>
#endif

using namespace mariotte;
using test::Folder;

namespace {

/// A number and a word vary; 3 × 2 points.
study::Design design() {
  const scene::Node soft{.value = std::string("soft"), .place = {}},
      hard{.value = std::string("hä, rd"), .place = {}};
  return {.parameters = {{.key = "chain.mass[1]", .axis = 0, .range = study::Range{.from = 1, .to = 3}},
                         {.key = "law", .axis = 1, .list = {soft, hard}}},
          .axes = {{.count = 3, .stride = 2}, {.count = 2, .stride = 1}}};
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(a_file_that_is_not_committed_leaves_nothing, Folder) {
  try {
    report::new_hdf5_sweep(path / "sweep.h5", design(), {{"icr[0]"}})->add("1,soft,2,separated,\n");
  } catch (const report::FileError&) {  // built without HDF5
  }
  BOOST_TEST(std::filesystem::is_empty(path));
}

#ifdef MARIOTTE_HDF5

namespace {

std::vector<double> numbers(const H5::H5File& file, const char* name) {
  const auto table = file.openDataSet(name);
  std::vector<double> values(table.getSpace().getSimpleExtentNpoints());
  table.read(values.data(), H5::PredType::NATIVE_DOUBLE);
  return values;
}

/// The pointer to an empty text is null.
std::vector<std::string> texts(const H5::H5File& file, const char* name) {
  const auto table = file.openDataSet(name);
  const auto type = table.getStrType();
  const auto space = table.getSpace();
  std::vector<char*> read(space.getSimpleExtentNpoints());
  table.read(read.data(), type);
  std::vector<std::string> values;
  for (const auto* one : read) values.emplace_back(one ? one : "");
  H5::DataSet::vlenReclaim(read.data(), type, space);
  return values;
}

std::string attribute(const H5::H5File& file, const char* dataset, const char* name) {
  const auto found = file.openDataSet(dataset).openAttribute(name);
  std::string text;
  found.read(found.getStrType(), text);
  return text.c_str();
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(every_column_is_a_dataset_of_its_name, Folder) {
  const auto table = report::new_hdf5_sweep(path / "sweep.h5", design(), {{"icr[0]", "1", "α_j", "a ratio"}});
  table->add("1,soft,0.1,separated,\n1,\"hä, rd\",,failed,\"stuck, at 2\"\n");
  table->add("2,soft,inf,max_time,\n");
  table->commit();
  BOOST_TEST(entries() == 1);

  const H5::H5File file((path / "sweep.h5").string(), H5F_ACC_RDONLY);
  const auto same = boost::test_tools::per_element();
  BOOST_TEST(numbers(file, "chain.mass[1]") == (std::vector<double>{1, 1, 2}), same);
  const auto icr = numbers(file, "icr[0]");
  BOOST_TEST_REQUIRE(icr.size() == 3);
  BOOST_TEST(icr[0] == 0.1);
  BOOST_TEST(std::isnan(icr[1]));
  BOOST_TEST(std::isinf(icr[2]));
  BOOST_TEST(attribute(file, "icr[0]", "units") == "1");
  BOOST_TEST(numbers(file, "point") == (std::vector<double>{0, 1, 2}), same);
  for (const auto* column : {"icr[0]", "law", "ending", "reason", "chain.mass[1]"})
    BOOST_TEST(H5DSis_attached(file.openDataSet(column).getId(), file.openDataSet("point").getId(), 0) > 0);
  BOOST_TEST(attribute(file, "icr[0]", "symbol") == "α_j");
  BOOST_TEST(attribute(file, "icr[0]", "long_name") == "a ratio");
  BOOST_TEST(!file.openDataSet("chain.mass[1]").attrExists("units"));
  using Texts = std::vector<std::string>;
  BOOST_TEST(texts(file, "law") == (Texts{"soft", "hä, rd", "soft"}), same);
  BOOST_TEST(texts(file, "ending") == (Texts{"separated", "failed", "max_time"}), same);
  BOOST_TEST(texts(file, "reason") == (Texts{"", "stuck, at 2", ""}), same);
  std::array<std::int64_t, 2> shape{};
  file.openAttribute("shape").read(H5::PredType::NATIVE_INT64, shape.data());
  BOOST_TEST(shape[0] == 3);
  BOOST_TEST(shape[1] == 2);
}

BOOST_FIXTURE_TEST_CASE(more_rows_than_fit_into_memory_at_once_keep_their_order, Folder) {
  const auto table = report::new_hdf5_sweep(path / "sweep.h5", design(), {{"icr[0]"}});
  for (int i = 0; i < 150000; ++i)
    table->add(std::to_string(i) + ",word" + std::to_string(i) + ",0.5,separated,\n");
  table->commit();
  const H5::H5File file((path / "sweep.h5").string(), H5F_ACC_RDONLY);
  const auto mass = numbers(file, "chain.mass[1]");
  const auto law = texts(file, "law");
  BOOST_TEST_REQUIRE(mass.size() == 150000);
  for (int i = 0; i < 150000; ++i) {
    BOOST_REQUIRE(mass[i] == i);
    BOOST_REQUIRE(law[i] == "word" + std::to_string(i));
  }
}

BOOST_FIXTURE_TEST_CASE(what_hdf5_takes_for_a_group_is_no_name_of_a_column, Folder) {
  for (const std::string name : {"v2/v1", "."})
    BOOST_CHECK_EXCEPTION(
        report::new_hdf5_sweep(path / "sweep.h5", design(), {{name}}), report::FileError,
        [&](const auto& error) { return std::string(error.what()).find("'" + name + "'") != name.npos; });
  BOOST_TEST(std::filesystem::is_empty(path));
}

BOOST_FIXTURE_TEST_CASE(a_file_that_cannot_be_written_is_named, Folder) {
  const auto nowhere = path / "no" / "sweep.h5";
  BOOST_CHECK_EXCEPTION(report::new_hdf5_sweep(nowhere, design(), {}), report::FileError,
                        [&](const auto& error) {
                          return std::string(error.what()).starts_with("cannot write " + nowhere.string());
                        });
}

#endif
