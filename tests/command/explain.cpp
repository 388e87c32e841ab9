// The catalogue of errors against the program: every kind the sources declare has a section in doc/errors.md,
// whose first example is refused with its code and whose second one is accepted.
#define BOOST_TEST_MODULE command_explain
#include <boost/test/unit_test.hpp>
#include <regex>
#include <set>

#include "doc/quotes.hpp"
#include "session.hpp"

using support::has;
using support::Outcome;
using support::Session;
namespace fs = std::filesystem;

namespace {

const fs::path root = MARIOTTE_ROOT;

struct Section {
  std::string code, title;
  std::vector<doc::Block> examples;
};

std::vector<Section> sections() {
  std::vector<Section> all;
  doc::Lines lines;
  const auto close = [&] {
    if (!all.empty()) all.back().examples = doc::blocks_of(all.back().code, lines);
    lines.clear();
  };
  for (const auto& line : doc::lines_of(std::ifstream(root / "doc/errors.md"))) {
    if (line.starts_with("### ")) {
      close();
      all.push_back({line.substr(4, 4), line.substr(9), {}});
    }
    lines.push_back(line);
  }
  close();
  return all;
}

/// Codes of the Fault constants in the headers called fault.hpp.
std::set<std::string> declared() {
  const std::regex fault("\\w\\{\"([A-Z][0-9]{3})\"\\}");
  std::set<std::string> codes;
  for (const auto* folder : {"lib/mariotte", "apps"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().filename() != "fault.hpp") continue;
      const auto text = support::content(entry.path());
      for (auto hit = std::sregex_iterator(text.begin(), text.end(), fault); hit != std::sregex_iterator();
           ++hit)
        BOOST_TEST(codes.insert((*hit)[1]).second, (*hit)[1] << " is declared twice");
    }
  return codes;
}

/// What happens to an example in a folder of its own, which looks like the source folder.
struct Trial : Session {
  Trial() { fs::create_symlink(root / "apps", folder / "apps"); }

  Outcome of(const doc::Block& example) const {
    std::string text;
    for (const auto& line : example.text) text += line + "\n";
    if (example.language == "sh") return shell("PATH=\"${mariotte%/*}:$PATH\"; set -e; " + text + ":");
    write("example.toml", text);
    return mariotte("check example.toml");
  }
};

std::string last_line(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_kind_of_error_has_one_section) {
  std::set<std::string> explained;
  for (const auto& section : sections())
    BOOST_TEST(explained.insert(section.code).second, section.code << " has two sections");
  BOOST_TEST(explained == declared(), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_first_example_is_refused_with_the_code_and_the_second_accepted) {
  for (const auto& section : sections()) BOOST_TEST_CONTEXT(section.code << " " << section.title) {
      BOOST_TEST_REQUIRE(section.examples.size() == 2u);
      BOOST_TEST(section.examples[0].comment == "refused");
      BOOST_TEST(section.examples[1].comment == "accepted");
      const auto refused = Trial().of(section.examples[0]), accepted = Trial().of(section.examples[1]);
      BOOST_TEST(refused.code != 0);
      BOOST_TEST(last_line(refused.err).starts_with("mariotte: error: "), refused.err);
      BOOST_TEST(last_line(refused.err).ends_with(" [" + section.code + "]"), refused.err);
      BOOST_TEST(accepted.code == 0, accepted.err);
      BOOST_TEST(!has(accepted.err, "error: "), accepted.err);
    }
}

BOOST_FIXTURE_TEST_CASE(explain_prints_the_section_of_a_code, Session) {
  for (const auto& section : sections()) {
    const auto page = mariotte("explain " + section.code);
    BOOST_TEST(page.code == 0);
    BOOST_TEST(page.out.starts_with(section.code + " " + section.title + "\n"));
    for (const auto& example : section.examples)
      for (const auto& line : example.text) BOOST_TEST(has(page.out, "\n  " + line + "\n"));
    BOOST_TEST(!has(page.out, "```"));
    BOOST_TEST(!has(page.out, "<!--"));
    BOOST_TEST(!has(page.out, "#"));
  }
  BOOST_TEST(mariotte("explain s010").out == mariotte("explain S010").out);
}

BOOST_FIXTURE_TEST_CASE(explain_alone_lists_all_codes_with_their_titles, Session) {
  const auto list = mariotte("explain");
  BOOST_TEST(list.code == 0);
  for (const auto& section : sections())
    BOOST_TEST(has(list.out, "\n  " + section.code + "  " + section.title + "\n"));
}

BOOST_FIXTURE_TEST_CASE(a_code_that_does_not_exist_is_told_what_it_is_like, Session) {
  const auto page = mariotte("explain S0100");
  BOOST_TEST(page.code == 2);
  BOOST_TEST(page.out == "");
  BOOST_TEST(has(page.err, "unknown code 'S0100' (did you mean 'S010'?)"), page.err);
  BOOST_TEST(page.err.ends_with(" [U001]\n"));
}
