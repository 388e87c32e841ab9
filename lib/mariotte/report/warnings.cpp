#include "mariotte/report/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "mariotte/impact/doubt.hpp"
#include "mariotte/impact/passage.hpp"

namespace mariotte::report {
namespace {

using List = std::vector<std::string>;

constexpr const char* of_cvode =
    "CVODE, which followed some contacts, leaves as much at its tightest tolerance";
constexpr const char* close_often = "contacts close so often that errors grow";
constexpr const char* fly_long = "contacts push together after a flight so long that errors grow";
constexpr const char* let_go_slowly = "what adheres lets go so slowly that errors grow";
constexpr const char* add_up = "the errors of all steps, and rounding, add up";
constexpr const char* not_repeated =
    "contacts closed more than 100 000 times, and runs that long are not repeated";
constexpr const char* no_end = "the runs that were to tell came to no end";
constexpr const char* lose_digits =
    "indentations are so small beside the way to the first contact that digits are lost";

/// What has made errors grow. A contact that closes no more often than is `harmless` is not the cause.
template <class Contact>
const char* growth(const std::vector<Contact>& contacts, Index harmless, double slowing) {
  if (slowing >= impact::much_slower) return let_go_slowly;
  if (std::any_of(contacts.begin(), contacts.end(),
                  [&](const Contact& contact) { return std::ssize(contact.periods) > harmless; }))
    return close_often;
  return impact::longest_flight(contacts) > impact::long_flight ? fly_long : add_up;
}

const char* growth(const impact::ContactImpact& impact) {
  if (impact::passage(impact).floor >= impact.estimated_accuracy) return of_cvode;
  return growth(impact.contacts, impact::single_wave(1), impact.slowing);
}

const char* growth(const impact::BodiesImpact& impact) {
  const auto* why = growth(impact.contacts, impact::single_impact, impact.slowing);
  return why != close_often && why != let_go_slowly && impact.lost_digits > impact.requested_accuracy
             ? lose_digits
             : why;
}

const char* growth(const impact::MicrobodyImpact& impact) {
  if (impact.slowing >= impact::much_slower) return let_go_slowly;
  return std::ssize(impact.impacts) > impact::single_impact ? close_often : add_up;
}

/// Why nothing bounds the error.
const char* no_bound(const impact::MicrobodyImpact&) {
  return no_end;
}
const char* no_bound(const auto& impact) {
  Index periods = 0;
  for (const auto& contact : impact.contacts) periods += std::ssize(contact.periods);
  return periods > impact::most_periods_run_again ? not_repeated : no_end;
}

template <class Impact>
void warn_of_error(const Impact& impact, List& list) {
  const auto text = impact::doubt(impact.estimated_accuracy, impact.requested_accuracy);
  if (text.empty()) return;
  const bool is_bounded = std::isfinite(*impact.estimated_accuracy);
  list.push_back(fmt::format("{}: {}", text, is_bounded ? growth(impact) : no_bound(impact)));
}

template <class Impact>
void warn_of_nothing(const Impact& impact, List& list) {
  if (impact.events.empty() && impact.ending == hybrid::Ending::separated)
    list.push_back("nothing collides: no contact ever closes faster than a tenth of the accuracy");
}

/// The time at which noise ends is no result.
void warn_of_fading(const impact::ContactImpact& impact, List& list) {
  constexpr std::size_t most = 5;
  if (impact.faded.empty()) return;
  const auto count = impact.faded.size();
  std::vector<Index> numbers(impact.faded.begin(), impact.faded.begin() + std::min(most, count));
  for (Index& number : numbers) ++number;
  const auto others = count > most ? fmt::format(" and {} more", count - most) : "";
  list.push_back(fmt::format(
      "contact{} {}{} faded: force and speed sank to what cannot be told from rest before the contact "
      "opened, so the time of its opening depends on the accuracy (velocities do not)",
      count > 1 ? "s" : "", fmt::join(numbers, ", "), others));
}

/// Who asks for a flow to check a result by wants it to have followed some contact.
void warn_of_flow(const std::vector<impact::FlowUse>& flows, std::optional<flow::Kind> asked, List& list) {
  std::vector<std::string> used;
  for (const auto& one : flows)
    if (one.phases > 0 && one.name != flow::name(flow::Kind::ballistic)) used.push_back(one.name);
  if (!asked || used.empty() || std::ranges::find(used, flow::name(asked)) != used.end()) return;
  list.push_back(fmt::format("no contact phase of this scene admits flow = \"{}\": {} followed them",
                             flow::name(asked), fmt::join(used, ", ")));
}

void warn_of_limits(const impact::Validity& validity, const char* thing, List& list) {
  for (const auto& one : impact::validity_limits)
    if (is_beyond(one, validity)) {
      const auto& [value, contact] = *(validity.*one.number);
      list.push_back(fmt::format("{} {}: {} = {:.3g} is {} {:g}: {}", thing, contact + 1, one.symbol, value,
                                 one.from_below ? "above" : "below", one.limit, one.otherwise));
    }
}

}  // namespace

List warnings(const impact::ContactImpact& impact, std::optional<flow::Kind> asked) {
  List list;
  warn_of_error(impact, list);
  warn_of_nothing(impact, list);
  warn_of_fading(impact, list);
  warn_of_flow(impact.flows, asked, list);
  warn_of_limits(impact.validity, "contact", list);
  return list;
}

List warnings(const impact::NetworkImpact& impact, std::optional<flow::Kind> asked) {
  auto list = warnings(static_cast<const impact::ContactImpact&>(impact), asked);
  for (const auto& [i, j] : impact.missed)
    list.push_back(
        fmt::format("balls {} and {} fly towards each other after the run from beyond 'reach', and will pass "
                    "through each other",
                    i + 1, j + 1));
  return list;
}

List warnings(const impact::BodiesImpact& impact, std::optional<flow::Kind> asked) {
  List list;
  warn_of_error(impact, list);
  warn_of_nothing(impact, list);
  warn_of_flow(impact.flows, asked, list);
  warn_of_limits(impact.validity, "contact", list);
  return list;
}

List warnings(const impact::MicrobodyImpact& impact, std::optional<flow::Kind> asked) {
  List list;
  warn_of_error(impact, list);
  warn_of_flow(impact.flows, asked, list);
  warn_of_limits(impact.validity, "tip", list);
  return list;
}

}  // namespace mariotte::report
