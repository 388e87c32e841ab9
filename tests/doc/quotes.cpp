// The documents against the program: files they quote, output they show, scenes, links.
//
//   <!-- file: PATH -->            the next block is that file, to the letter
//   ```console                     `$ COMMAND` and what it prints
//   <!-- magnitudes: COMMAND -->   the next table is what COMMAND prints, errors within a factor of 10
//   ```toml                        a scene, if it has a line `[chain]`
#define BOOST_TEST_MODULE quotations
#include "quotes.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <set>
#include <sstream>

using namespace doc;

namespace {

const fs::path root = MARIOTTE_ROOT;

std::vector<fs::path> documents() {
  std::vector<fs::path> paths = {"README.md"};
  for (const auto* folder : {"doc", "doc/examples"})
    for (const auto& entry : fs::directory_iterator(root / folder))
      if (entry.path().extension() == ".md") paths.push_back(fs::relative(entry.path(), root));
  return paths;
}

std::vector<Block> blocks() {
  std::vector<Block> all;
  for (const auto& path : documents())
    for (const auto& block : blocks_of(path.string(), lines_of(std::ifstream(root / path))))
      all.push_back(block);
  return all;
}

/// What follows `key` in the comment of a block; empty if it says something else.
std::string told(const Block& block, const std::string& key) {
  return block.comment.starts_with(key) ? block.comment.substr(key.size()) : "";
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

/// Name of the program a line of shell starts, without its folder: the build folder may be any.
std::string program(const std::string& command) {
  return fs::path(command.substr(0, command.find(' '))).filename().string();
}

/// Standard output of one of this project's programs, run in the source folder.
std::string output(const std::string& command) {
  const auto rest = command.find(' ') == std::string::npos ? "" : command.substr(command.find(' '));
  const std::string line =
      "cd '" MARIOTTE_ROOT "' && PATH='" MARIOTTE_PROGRAMS "':\"$PATH\" " + program(command) + rest;
  std::string text;
  auto* pipe = ::popen(line.c_str(), "r");
  BOOST_TEST_REQUIRE(pipe);
  for (char part[4096]; const auto size = std::fread(part, 1, sizeof part, pipe);) text.append(part, size);
  BOOST_TEST(::pclose(pipe) == 0);
  return text;
}

void check_output(const Lines& quoted, const std::string& command, Numbers numbers) {
  const auto printed = output(command);
  const bool same = same_text(quoted, lines_of(std::istringstream(printed)), numbers);
  BOOST_TEST(same, "`" << command << "` now prints\n" << printed);
}

bool is_scene(const Block& block) {
  return block.language == "toml" && std::count(block.text.begin(), block.text.end(), "[chain]") == 1;
}

}  // namespace

BOOST_AUTO_TEST_CASE(quoted_files_are_the_files) {
  for (const auto& block : blocks()) {
    const auto file = told(block, "file: ");
    if (file.empty()) continue;
    BOOST_TEST_CONTEXT(block.place) {
      BOOST_TEST(joined(block.text) == joined(lines_of(std::ifstream(root / file))));
    }
  }
}

BOOST_AUTO_TEST_CASE(console_blocks_show_what_is_printed) {
  for (const auto& block : blocks()) {
    if (block.language != "console") continue;
    BOOST_TEST_CONTEXT(block.place) {
      BOOST_TEST_REQUIRE((!block.text.empty() && block.text[0].starts_with("$ ")));
      check_output({block.text.begin() + 1, block.text.end()}, block.text[0].substr(2), Numbers::digits);
    }
  }
}

BOOST_AUTO_TEST_CASE(tables_of_errors_hold) {
  for (const auto& block : blocks()) {
    const auto command = told(block, "magnitudes: ");
    if (command.empty()) continue;
    BOOST_TEST_CONTEXT(block.place) {
      check_output(block.text, command, Numbers::magnitudes);
    }
  }
}

BOOST_AUTO_TEST_CASE(scenes_are_valid) {
  const auto file = fs::temp_directory_path() / ("mariotte-quoted-" + std::to_string(::getpid()) + ".toml");
  for (const auto& block : blocks()) {
    if (!is_scene(block)) continue;
    BOOST_TEST_CONTEXT(block.place) {
      std::ofstream(file) << joined(block.text);
      output("mariotte check '" + file.string() + "'");
    }
  }
  fs::remove(file);
}

BOOST_AUTO_TEST_CASE(every_example_is_quoted_with_its_output) {
  std::set<std::string> files, run;
  for (const auto& block : blocks()) {
    files.insert(told(block, "file: "));
    if (block.language == "console" && !block.text.empty()) run.insert(program(block.text[0].substr(2)));
  }
  for (const auto& entry : fs::directory_iterator(root / "doc/examples")) {
    if (entry.path().extension() != ".cpp") continue;
    BOOST_TEST_CONTEXT(entry.path().filename()) {
      BOOST_TEST(files.contains(fs::relative(entry.path(), root).string()));
      BOOST_TEST(run.contains("example_" + entry.path().stem().string()));
    }
  }
}

BOOST_AUTO_TEST_CASE(links_lead_to_files) {
  const std::regex link("\\]\\(([^)#: ]+)(#[^)]*)?\\)");
  for (const auto& path : documents()) {
    const auto text = joined(lines_of(std::ifstream(root / path)));
    for (auto hit = std::sregex_iterator(text.begin(), text.end(), link); hit != std::sregex_iterator();
         ++hit)
      BOOST_TEST(fs::exists(root / path.parent_path() / (*hit)[1].str()),
                 path.string() << " links to " << (*hit)[1].str());
  }
}

// The comparison itself: what it lets pass, and what it does not.
BOOST_AUTO_TEST_CASE(quotations_may_be_shortened_but_not_wrong) {
  const Lines printed = {"Title", "  1   0.5", "  2  -0.25", "residual 1.0e-17"};
  BOOST_TEST(same_text(printed, printed, Numbers::digits));
  BOOST_TEST(same_text({"Title", "…", "residual 3.0e-15"}, printed, Numbers::digits));
  BOOST_TEST(same_text({"…", " 2 -0.2500000001", "…"}, printed, Numbers::digits));
  BOOST_TEST(!same_text({"…", "  2  -0.251", "…"}, printed, Numbers::digits));
  BOOST_TEST(!same_text({"…", "  2  0.25", "…"}, printed, Numbers::digits));
  BOOST_TEST(!same_text({"Title", "…", "  3  1"}, printed, Numbers::digits));
  BOOST_TEST(!same_text({"Titel", "…"}, printed, Numbers::digits));
  BOOST_TEST(!same_text({"Title", "  1   0.5", "  2  -0.25"}, printed, Numbers::digits));
  BOOST_TEST(same_line("| 2e-12 |", "| 9e-12 |", Numbers::magnitudes));
  BOOST_TEST(!same_line("| 2e-12 |", "| 3e-11 |", Numbers::magnitudes));
  BOOST_TEST(!same_line("| 84 cases |", "| 85 cases |", Numbers::magnitudes));
}
