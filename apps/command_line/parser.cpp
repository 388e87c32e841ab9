#include "command_line/parser.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/core/nearest.hpp"

namespace mariotte::command {
namespace {

CLI::Option* add(CLI::App& app, const Option& option) {
  return std::visit(
      [&](auto target) {
        using Type = decltype(target);
        if constexpr (std::is_same_v<Type, bool*>)
          return app.add_flag(option.name, *target, option.about);
        else if constexpr (std::is_pointer_v<Type>)
          return app.add_option(option.name, *target, option.about);
        else
          return app.add_option_function<std::string>(option.name, target, option.about);
      },
      option.target);
}

/// Why a number is refused; CLI11 writes 1e-15 as zero.
std::string outside(const Range& range, const std::string& text) {
  const auto value = number(text);
  const bool is_told_elsewhere = !value || !std::isfinite(*value);
  if (is_told_elsewhere || (*value >= range.least && *value <= range.most)) return "";
  return fmt::format("{} is not in the range {:g} to {:g}", text, range.least, range.most);
}

struct AddCheck {
  CLI::Option& made;
  const Target& target;

  void operator()(std::monostate) const {}
  void operator()(const Range& range) const {
    if (std::holds_alternative<int*>(target) || std::holds_alternative<std::int64_t*>(target))
      made.check(CLI::Range(static_cast<int>(range.least), static_cast<int>(range.most)));
    else
      made.check(CLI::Validator([range](const std::string& text) { return outside(range, text); },
                                fmt::format("FLOAT in [{:g} - {:g}]", range.least, range.most)));
  }
  void operator()(const OneOf& one) const { made.check(CLI::IsMember(one.words)); }
  void operator()(NotNegative) const { made.check(CLI::NonNegativeNumber); }
  void operator()(Positive) const { made.check(CLI::PositiveNumber); }
  void operator()(const std::function<std::string(const std::string&)>& wrong) const {
    made.check(wrong, "");
  }
};

std::string is_not_empty(const std::string& text) {
  return text.empty() ? "an empty value names nothing" : "";
}

bool takes_numbers(const Target& target) {
  return std::holds_alternative<double*>(target) || std::holds_alternative<std::vector<double>*>(target);
}

/// No range leaves out "nan", which compares with nothing.
std::string is_finite(const std::string& text) {
  const auto value = number(text);
  return !value || std::isfinite(*value) ? "" : "must be a finite number, not " + text;
}

/// Else "-1" would be the largest of all numbers.
std::string has_no_sign(const std::string& text) {
  return text.starts_with("-") ? "must not be negative, but is " + text : "";
}

bool takes_whole_numbers(const Target& target) {
  return std::holds_alternative<int*>(target) || std::holds_alternative<std::int64_t*>(target) ||
         std::holds_alternative<std::uint64_t*>(target);
}

/// CLI11 takes what begins with a zero as octal, and what is too large as the largest.
std::string as_decimal(std::string& text) {
  const bool has_sign = text.starts_with("-") || text.starts_with("+");
  const auto digits = text.substr(has_sign ? 1 : 0);
  if (digits.find_first_not_of("0123456789") != digits.npos)
    return digits.starts_with("0") ? "must be a whole number in decimal digits, not " + text : "";
  const auto first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  std::uint64_t value = 0;
  const auto end = digits.data() + digits.size();
  if (!digits.empty() && std::from_chars(digits.data(), end, value).ec != std::errc())
    return "is too large: " + text;
  if (!digits.empty()) text = (text.starts_with("-") ? "-" : "") + digits.substr(first);
  return "";
}

CLI::Option* declare(CLI::App& app, const Option& option) {
  auto& made = *add(app, option);
  const auto& usage = option.usage;
  if (!usage.value.empty()) made.type_name(usage.value);
  if (usage.takes_one) made.allow_extra_args(false);
  if (usage.between_commas) made.delimiter(',');
  if (usage.shows_default) made.capture_default_str();
  made.required(usage.required);
  std::visit(AddCheck{made, option.target}, usage.check);
  if (takes_numbers(option.target)) made.check(is_finite, "");
  if (std::holds_alternative<std::uint64_t*>(option.target)) made.check(has_no_sign, "");
  if (takes_whole_numbers(option.target)) made.transform(CLI::Validator(as_decimal, ""));
  // A shell variable that is not set makes `--out ""`, which is not the same as no --out.
  if (made.get_items_expected_max() > 0) made.check(is_not_empty, "");
  return &made;
}

void declare(CLI::App& app, const Command& command) {
  if (!command.footer.empty()) app.footer(command.footer);
  if (!command.version.empty()) app.set_version_flag("--version", command.version);
  if (!command.commands.empty()) app.require_subcommand(1);
  if (command.pass_on) app.prefix_command()->set_help_flag();
  std::vector<CLI::Option*> made;
  for (const auto& option : command.options) made.push_back(declare(app, option));
  for (std::size_t i = 0; i < made.size(); ++i) {
    for (const auto& other : command.options[i].usage.needs) made[i]->needs(app.get_option(other));
    for (const auto& other : command.options[i].usage.excludes) made[i]->excludes(app.get_option(other));
  }
  for (const auto& one : command.commands) declare(*app.add_subcommand(one.name, one.about), one);
}

const auto any = [](const CLI::App*) { return true; };

/// What the command line got to before it failed.
const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.back());
}

/// The words that may follow.
struct Known {
  Words commands, options;
};
Known known_to(const CLI::App& app) {
  Known known;
  for (const auto* command : app.get_subcommands(any)) known.commands.push_back(command->get_name());
  for (const auto* option : app.get_options())
    for (const auto& name : option->get_lnames()) known.options.push_back("--" + name);
  return known;
}

/// A word that is like none is told the nearest of its kind where a command is missing; of what a command
/// does not know CLI11 tells itself.
std::string hint(const std::string& word, const Known& known, bool is_option) {
  using Names = std::vector<std::string_view>;
  Names all(known.commands.begin(), known.commands.end());
  all.insert(all.end(), known.options.begin(), known.options.end());
  const auto similar = suggestion(word, all);
  if (!similar.empty() || known.commands.empty()) return similar;
  const auto& kind = is_option ? known.options : known.commands;
  return suggestion_or_few(word, Names(kind.begin(), kind.end()));
}

/// The first word that means nothing, and what it is like; empty if there is none.
std::string unknown_word(const CLI::App& app) {
  const auto& at = innermost(app);
  const auto known = known_to(at);
  for (const auto& word : at.remaining()) {
    const bool is_option = word.starts_with("-");
    if (const auto like = hint(word, known, is_option); !like.empty())
      return std::string("unknown ") + (is_option ? "option" : "command") + " '" + word + "'" + like;
  }
  return "";
}

void expect_known_words(const CLI::App& app) {
  const auto misspelt = unknown_word(app);
  if (!misspelt.empty()) throw UsageError(misspelt + " (see --help)", fault::unknown_argument);
}

Fault fault_of(const CLI::ParseError& problem) {
  if (dynamic_cast<const CLI::ExtrasError*>(&problem)) return fault::unknown_argument;
  return dynamic_cast<const CLI::RequiredError*>(&problem) ? fault::missing_argument : fault::bad_argument;
}

std::function<int()> printed(const std::string& text) {
  return [text] {
    print(text);
    return ExitCode::ok;
  };
}

std::function<int()> chosen(const Command& command, const CLI::App& app) {
  for (const auto& one : command.commands)
    if (app.got_subcommand(one.name)) return chosen(one, *app.get_subcommand(one.name));
  if (!command.pass_on) return command.act;
  return [rest = app.remaining(), pass_on = command.pass_on] { return pass_on(rest); };
}

Words choices(const Usage& usage) {
  const auto* one = std::get_if<OneOf>(&usage.check);
  return one ? one->words : usage.choices;
}

/// Of what the declaration of a command calls so; none of the options that every command has.
Usage usage_of(const Command& command, const std::string& name) {
  for (const auto& option : command.options)
    if (option.name == name) return option.usage;
  return {};
}

HelpPage::Option described(const CLI::Option& option, const Command& command) {
  const bool has_name = option.get_items_expected_max() > 0 && !option.get_positional();
  const auto usage = usage_of(command, option.get_name(false, true));
  return {.names = option.get_name(false, true),
          .long_names = option.get_lnames(),
          .value = has_name ? option.get_type_name() : "",
          .about = option.get_description(),
          .choices = choices(usage),
          .default_value = option.get_default_str(),
          .needs = usage.needs};
}

HelpPage described(const CLI::App& app, const Command& command) {
  HelpPage page{.name = app.get_name(),
                .about = app.get_description(),
                .footer = app.get_footer(),
                .options = {},
                .commands = {}};
  for (const auto* option : app.get_options()) page.options.push_back(described(*option, command));
  for (const auto& one : command.commands)
    page.commands.push_back(described(*app.get_subcommand(one.name), one));
  return page;
}

/// The command that CLI11 does not know.
HelpPage page_of_help(const HelpPage& program) {
  HelpPage::Option word{
      .names = "COMMAND", .long_names = {}, .value = "", .about = "Which one", .choices = {}};
  for (const auto& one : program.commands) word.choices.push_back(one.name);
  return {.name = "help",
          .about = "Print all about a command, as its --help",
          .footer = fmt::format("Example:\n  {} help {}\n", program.name, word.choices.front()),
          .options = {word},
          .commands = {}};
}

/// "help run" is "run --help".
std::vector<const char*> words(const Command& program, int argc, const char* const* argv) {
  std::vector<const char*> all(argv, argv + argc);
  if (program.commands.empty() || argc < 2 || std::string_view(argv[1]) != "help") return all;
  all.erase(all.begin() + 1);
  all.push_back("--help");
  return all;
}

}  // namespace

std::function<int()> parse(const Command& program, int argc, const char* const* argv) {
  CLI::App app(program.about, program.name);
  declare(app, program);
  try {
    const auto given = words(program, argc, argv);
    app.parse(static_cast<int>(given.size()), given.data());
    return chosen(program, app);
  } catch (const CLI::CallForHelp&) {
    expect_known_words(app);
    return printed(app.help());
  } catch (const CLI::CallForVersion& version) {
    return printed(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& problem) {
    expect_known_words(app);
    throw UsageError(std::string(problem.what()) + " (see --help)", fault_of(problem));
  }
}

HelpPage help_page(const Command& command) {
  CLI::App app(command.about, command.name);
  declare(app, command);
  auto page = described(app, command);
  if (!page.commands.empty()) page.commands.push_back(page_of_help(page));
  return page;
}

}  // namespace mariotte::command
