#define BOOST_TEST_MODULE report_files
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "mariotte/report/page/files.hpp"
#include "support/folder.hpp"

namespace report = mariotte::report;
namespace fs = std::filesystem;
using mariotte::test::content;
using mariotte::test::Folder;

BOOST_FIXTURE_TEST_CASE(a_written_file_holds_the_text_and_leaves_nothing_beside_it, Folder) {
  const std::string text(3000000, 'x');
  report::write_file(path / "a.txt", text);
  BOOST_TEST((content(path / "a.txt") == text));
  BOOST_TEST(entries() == 1);
}

BOOST_FIXTURE_TEST_CASE(writing_replaces_a_file_instead_of_changing_it, Folder) {
  report::write_file(path / "a.txt", "old");
  fs::create_hard_link(path / "a.txt", path / "kept.txt");
  report::write_file(path / "a.txt", "new");
  BOOST_TEST(content(path / "a.txt") == "new");
  BOOST_TEST(content(path / "kept.txt") == "old");
}

BOOST_FIXTURE_TEST_CASE(a_file_that_cannot_be_written_is_named_and_leaves_nothing, Folder) {
  fs::create_directory(path / "taken");
  const auto names_it = [](const report::FileError& e) {
    return std::string(e.what()).find("taken") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(report::write_file(path / "taken", "text"), report::FileError, names_it);
  BOOST_CHECK_THROW(report::write_file(path / "missing" / "a.txt", "text"), report::FileError);
  BOOST_TEST(entries() == 1);
}

BOOST_FIXTURE_TEST_CASE(a_pipe_or_a_device_is_not_replaced, Folder) {
  BOOST_REQUIRE(::mkfifo((path / "pipe").c_str(), 0600) == 0);
  BOOST_CHECK_THROW(report::write_file(path / "pipe", "text"), report::FileError);
  BOOST_TEST(fs::is_fifo(path / "pipe"));
  BOOST_TEST(entries() == 1);
}

BOOST_FIXTURE_TEST_CASE(a_folder_is_made_with_its_parents, Folder) {
  report::prepare_folder(path / "a" / "b", {"result.json"}, false);
  BOOST_TEST(fs::is_directory(path / "a" / "b"));
}

BOOST_FIXTURE_TEST_CASE(existing_files_are_not_overwritten_unless_asked, Folder) {
  report::write_file(path / "result.json", "old");
  BOOST_CHECK_THROW(report::prepare_folder(path, {"events.csv", "result.json"}, false), report::FileError);
  BOOST_CHECK_NO_THROW(report::prepare_folder(path, {"events.csv", "result.json"}, true));
  BOOST_CHECK_NO_THROW(report::prepare_folder(path, {"events.csv"}, false));
  BOOST_TEST(content(path / "result.json") == "old");
}

BOOST_FIXTURE_TEST_CASE(a_folder_cannot_be_made_of_a_file, Folder) {
  report::write_file(path / "file", "text");
  BOOST_CHECK_THROW(report::prepare_folder(path / "file", {}, true), report::FileError);
}

BOOST_FIXTURE_TEST_CASE(removing_files_leaves_the_others, Folder) {
  report::write_file(path / "a", "");
  report::write_file(path / "b", "");
  report::remove_files(path, {"a", "never there"});
  BOOST_TEST(!fs::exists(path / "a"));
  BOOST_TEST(fs::exists(path / "b"));
}

BOOST_FIXTURE_TEST_CASE(what_a_killed_process_left_of_a_file_goes_when_it_is_written_again, Folder) {
  const ::pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ::waitpid(dead, nullptr, 0);
  const auto left = [&](const std::string& file, ::pid_t process) {
    return path / ("." + file + "." + std::to_string(process) + ".tmp");
  };
  const std::vector<fs::path> kept = {left("a.csv", ::getppid()), left("b.csv", dead), path / ".a.csv.x.tmp"};
  for (const auto& one : kept) std::ofstream(one) << "beginning";
  std::ofstream(left("a.csv", dead)) << "beginning";
  report::write_file(path / "a.csv", "all");
  BOOST_TEST(!fs::exists(left("a.csv", dead)));
  for (const auto& one : kept)
    BOOST_TEST(fs::exists(one), one);  // another process, another file, another name
  BOOST_TEST(entries() == 4);
}
