#define BOOST_TEST_MODULE study_journal
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "mariotte/study/journal/crc32.hpp"
#include "mariotte/study/journal/journal.hpp"
#include "support/folder.hpp"

using namespace mariotte;
using study::Journal;
using study::PointRange;
namespace fs = std::filesystem;

namespace {

struct Folder : test::Folder {
  fs::path file() const { return path / "journal.jsonl"; }
  std::string content() const { return test::content(file()); }
  void replace(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
};

std::string all_of(Journal& journal) {
  std::string text;
  journal.read([&](Index, std::string_view rows) { text += rows; });
  return text;
}

void fill(Journal& journal) {
  journal.append({.first = 2, .count = 2, .failed = 1, .text = "2\n\"three\"\t\\,\n"});
  journal.append({.first = 0, .count = 2, .text = "0\n1\n"});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_checksum_is_the_one_everybody_has) {
  BOOST_TEST(study::crc32("123456789") == 0xcbf43926u);  // the check value of CRC-32
  BOOST_TEST(study::crc32("The quick brown fox jumps over the lazy dog") == 0x414fa339u);
  BOOST_TEST(study::crc32("") == 0u);
}

BOOST_AUTO_TEST_CASE(a_line_is_json_and_gives_back_its_rows) {
  std::string text = "a,\"b\"\n\\ µ";
  for (char c = 1; c < ' '; ++c) text += c;
  const auto line = study::rows_line({.first = 3, .count = 4, .failed = 2, .text = text});
  const auto json = nlohmann::json::parse(line);
  BOOST_TEST(json["first"] == 3);
  BOOST_TEST(json["rows"].get<std::string>() == text);
  const auto rows = study::read_rows(line.substr(0, line.size() - 1));
  BOOST_TEST_REQUIRE(rows.has_value());
  BOOST_TEST((rows->first == 3 && rows->count == 4 && rows->failed == 2 && rows->text == text));
}

BOOST_AUTO_TEST_CASE(no_altered_line_is_believed) {
  auto line = study::rows_line({.first = 3, .count = 4, .text = "1,2,3\n"});
  line.pop_back();
  for (std::size_t i = 0; i < line.size(); ++i) {
    auto altered = line;
    altered[i] = static_cast<char>(altered[i] ^ 1);
    BOOST_TEST(!study::read_rows(altered).has_value(), altered);
    BOOST_TEST(!study::read_rows(line.substr(0, i)).has_value());
  }
}

BOOST_FIXTURE_TEST_CASE(rows_come_back_in_order_whatever_the_order_they_were_written_in, Folder) {
  Journal journal(path, "x", 4);
  fill(journal);
  BOOST_TEST(all_of(journal) == "0\n1\n2\n\"three\"\t\\,\n");
  BOOST_TEST(journal.failed() == 1);
}

BOOST_FIXTURE_TEST_CASE(a_journal_cut_anywhere_goes_on_with_what_is_whole, Folder) {
  {
    Journal journal(path, "x", 4);
    fill(journal);
  }
  const auto whole = content();
  std::size_t found = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    replace(whole.substr(0, size));
    Journal journal(path, "x", 4);
    const auto left = total(journal.missing());
    BOOST_TEST_REQUIRE((left == 4 || left == 2 || left == 0));
    found += left < 4;
    for (const auto& [first, count] : journal.missing())
      journal.append({.first = first, .count = count, .text = first == 2 || count == 4 ? "" : "0\n1\n"});
    BOOST_TEST(journal.missing().empty());
    BOOST_CHECK_NO_THROW(all_of(journal));
  }
  BOOST_TEST(found > 0u);
}

BOOST_FIXTURE_TEST_CASE(a_line_altered_in_the_middle_is_computed_again, Folder) {
  {
    Journal journal(path, "x", 4);
    fill(journal);
  }
  auto text = content();
  text[text.find("three")] = 'T';
  replace(text);
  Journal journal(path, "x", 4);
  BOOST_TEST(journal.missing().size() == 1);
  BOOST_TEST(journal.missing()[0].first == 2);
}

BOOST_FIXTURE_TEST_CASE(rows_that_are_not_believed_are_computed_again, Folder) {
  {
    Journal journal(path, "x", 4);
    fill(journal);
  }
  const auto no_three = [](const study::Rows& rows) { return rows.text.find("three") == std::string::npos; };
  const Journal journal(path, "x", 4, 0, {}, no_three);
  BOOST_TEST_REQUIRE(journal.missing().size() == 1);
  BOOST_TEST((journal.missing()[0].first == 2 && journal.missing()[0].count == 2));
  BOOST_TEST(journal.failed() == 0);
}

BOOST_FIXTURE_TEST_CASE(rows_of_points_that_do_not_exist_do_not_count, Folder) {
  constexpr Index huge = std::numeric_limits<Index>::max();
  replace(study::heading_line("x", 4) + study::rows_line({.first = huge, .count = huge, .text = "0\n"}) +
          study::rows_line({.first = 1, .count = -1, .text = "0\n"}) +
          study::rows_line({.first = 3, .count = 2, .text = "0\n1\n"}));
  const Journal journal(path, "x", 4);
  BOOST_TEST(total(journal.missing()) == 4);
}

BOOST_FIXTURE_TEST_CASE(another_sweep_is_refused_and_its_journal_untouched, Folder) {
  {
    Journal journal(path, "x", 4);
    fill(journal);
  }
  const auto before = content();
  BOOST_CHECK_THROW(Journal(path, "y", 4), study::JournalError);
  BOOST_CHECK_THROW(Journal(path, "x", 5), study::JournalError);
  BOOST_TEST(content() == before);
  auto damaged = before;
  damaged[before.find("sweep")] = 'S';
  replace(damaged);
  BOOST_CHECK_EXCEPTION(Journal(path, "x", 4), study::JournalError, [](const auto& problem) {
    return std::string(problem.what()).find("the first line, which says what is swept, is damaged") !=
           std::string::npos;
  });
  replace("no journal at all");
  BOOST_CHECK_THROW(Journal(path, "x", 4), study::JournalError);
  BOOST_TEST(content() == "no journal at all");
}

BOOST_FIXTURE_TEST_CASE(two_sweeps_cannot_write_one_journal, Folder) {
  Journal journal(path, "x", 4);
  BOOST_CHECK_THROW(Journal(path, "x", 4), study::JournalError);
}

BOOST_FIXTURE_TEST_CASE(ranks_write_files_of_their_own_and_read_those_of_all, Folder) {
  Journal zero(path, "x", 4), one(path, "x", 4, 1);
  zero.append({.first = 2, .count = 2, .text = "2\n3\n"});
  one.append({.first = 0, .count = 2, .text = "0\n1\n"});
  BOOST_TEST(total(zero.missing()) == 2);
  zero.reload();
  BOOST_TEST(all_of(zero) == "0\n1\n2\n3\n");
}

BOOST_FIXTURE_TEST_CASE(points_that_two_ranks_computed_stand_there_once, Folder) {
  Journal zero(path, "x", 4), one(path, "x", 4, 1);
  zero.append({.first = 0, .count = 3, .text = "0\n1\n2\n"});
  one.append({.first = 1, .count = 1, .text = "1\n"});
  one.append({.first = 1, .count = 3, .text = "1\n2\n3\n"});
  zero.reload();
  BOOST_TEST(all_of(zero) == "0\n1\n2\n3\n");
}

BOOST_AUTO_TEST_CASE(missing_points_are_what_done_stretches_leave) {
  const auto rest = study::missing({{5, 2}, {0, 1}, {6, 3}}, 12);
  BOOST_TEST_REQUIRE(rest.size() == 2);
  BOOST_TEST((rest[0].first == 1 && rest[0].count == 4));
  BOOST_TEST((rest[1].first == 9 && rest[1].count == 3));
}

BOOST_AUTO_TEST_CASE(every_point_is_dealt_once_to_one_rank) {
  for (const Index ranks : {1, 2, 3, 5}) {
    std::vector<int> dealt(1000);
    for (Index rank = 0; rank < ranks; ++rank) {
      study::Dealer dealer({{0, 300}, {310, 690}}, {.rank = rank, .ranks = ranks});
      for (PointRange chunk; (chunk = dealer.take(7)).count > 0;)
        for (Index k = 0; k < chunk.count; ++k) ++dealt[static_cast<std::size_t>(chunk.first + k)];
    }
    for (int i = 0; i < 1000; ++i) BOOST_TEST(dealt[static_cast<std::size_t>(i)] == (i < 300 || i >= 310));
  }
}
