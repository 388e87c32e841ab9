// The documents against the program: files they quote, output they show, scenes, links.
//
//   <!-- file: PATH -->            the next block is that file, to the letter
//   <!-- save: NAME -->            the next block is written to that file, for the commands after it
//   <!-- run -->                   the next block of sh is run and must succeed
//   ```console                     `$ COMMAND` and what it prints
//   <!-- magnitudes: COMMAND -->   the next table is what COMMAND prints, errors within a factor of 10
//   ```toml                        a scene, if it has a line `[chain]`, `[network]` or `[body]`; one after
//                                  <!-- refused --> must not be accepted, as command_explain checks
//
// Commands run in a folder that looks like the source folder; those of one document share it.
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

/// A folder in which the source folder's entries are found, and whatever commands write beside them.
class Workshop {
 public:
  Workshop() {
    std::string name = (fs::temp_directory_path() / "mariotte-doc-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    for (const auto& entry : fs::directory_iterator(root))
      fs::create_symlink(entry.path(), folder_ / entry.path().filename());
  }
  ~Workshop() { fs::remove_all(folder_); }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const fs::path& folder() const { return folder_; }

  /// Standard output of lines of shell that start programs of this project by name.
  std::string output(const std::string& lines) const {
    const std::string line =
        "cd '" + folder_.string() + "' && export PATH='" MARIOTTE_PROGRAMS "':\"$PATH\" && " + lines;
    std::string text;
    auto* pipe = ::popen(line.c_str(), "r");
    BOOST_TEST_REQUIRE(pipe);
    for (char part[4096]; const auto size = std::fread(part, 1, sizeof part, pipe);) text.append(part, size);
    BOOST_TEST(::pclose(pipe) == 0);
    return text;
  }

 private:
  fs::path folder_;
};

/// The command without its program's folder: the build folder may be any.
std::string by_name(const std::string& command) {
  const auto blank = command.find(' ');
  return program(command) + (blank == std::string::npos ? "" : command.substr(blank));
}

void check_output(const Workshop& workshop, const Lines& quoted, const std::string& command,
                  Numbers numbers) {
  const auto printed = workshop.output(by_name(command));
  const bool same = same_text(quoted, lines_of(std::istringstream(printed)), numbers);
  BOOST_TEST(same, "`" << command << "` now prints\n" << printed);
}

bool is_scene(const Block& block) {
  const auto lines = [&](const char* line) { return std::count(block.text.begin(), block.text.end(), line); };
  return block.language == "toml" && block.comment != "refused" &&
         lines("[chain]") + lines("[network]") + lines("[body]") == 1;
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

void try_out(const Block& block, const Workshop& workshop) {
  if (const auto name = told(block, "save: "); !name.empty())
    std::ofstream(workshop.folder() / name) << joined(block.text);
  if (block.comment == "run")
    for (const auto& command : block.text) workshop.output("set -e; " + by_name(command));
  if (const auto command = told(block, "magnitudes: "); !command.empty())
    check_output(workshop, block.text, command, Numbers::magnitudes);
  if (block.language != "console") return;
  BOOST_TEST_REQUIRE((!block.text.empty() && block.text[0].starts_with("$ ")));
  check_output(workshop, {block.text.begin() + 1, block.text.end()}, block.text[0].substr(2),
               Numbers::digits);
}

BOOST_AUTO_TEST_CASE(commands_print_what_is_shown) {
  for (const auto& path : documents()) {
    const Workshop workshop;
    for (const auto& block : blocks_of(path.string(), lines_of(std::ifstream(root / path))))
      BOOST_TEST_CONTEXT(block.place) {
        try_out(block, workshop);
      }
  }
}

BOOST_AUTO_TEST_CASE(scenes_are_valid) {
  const Workshop workshop;
  for (const auto& block : blocks()) {
    if (!is_scene(block)) continue;
    BOOST_TEST_CONTEXT(block.place) {
      std::ofstream(workshop.folder() / "quoted.toml") << joined(block.text);
      workshop.output("mariotte check quoted.toml");
    }
  }
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
