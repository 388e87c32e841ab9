// Every file of tests/data/malformed says in its first line where and why it is rejected:
//     # expect LINE:COLUMN TEXT
#define BOOST_TEST_MODULE scene_malformed
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "mariotte/scene/scene.hpp"

namespace {

namespace fs = std::filesystem;
using namespace mariotte;

struct Expectation {
  std::string place;
  std::string text;
};

Expectation expectation(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string hash, word;
  Expectation expected;
  file >> hash >> word >> expected.place >> std::ws;
  std::getline(file, expected.text);
  BOOST_REQUIRE_MESSAGE(hash == "#" && word == "expect", path << " has no '# expect' line");
  return expected;
}

std::string rejection(const std::string& path) {
  try {
    scene::read(path);
  } catch (const scene::SceneError& error) {
    return error.what();
  }
  return "accepted";
}

std::set<fs::path> files() {
  const fs::directory_iterator folder(fs::path(MARIOTTE_TEST_DATA) / "malformed");
  return {begin(folder), end(folder)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_malformed_scene_is_rejected_at_its_place_with_its_reason) {
  BOOST_TEST(files().size() >= 50);
  for (const auto& path : files()) {
    const auto [place, text] = expectation(path);
    const auto start = path.string() + ":" + place + ": ";
    const auto what = rejection(path.string());
    BOOST_TEST(what.starts_with(start), "expected " << start << " got " << what);
    BOOST_TEST(what.find(text) != std::string::npos, "expected '" << text << "' in " << what);
  }
}

BOOST_AUTO_TEST_CASE(a_rejection_is_one_line_of_readable_length) {
  for (const auto& path : files()) {
    const auto what = rejection(path.string());
    BOOST_TEST(what.find('\n') == std::string::npos);
    BOOST_TEST(what.size() < path.string().size() + 400);
  }
}
