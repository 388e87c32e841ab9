#include "mariotte/impact/watch/event_list.hpp"

#include <algorithm>

#include "mariotte/impact/flow_uses.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {
namespace {

/// The list of an event that a change belongs to; null if it leaves every force as it is.
std::vector<Index> Event::*kind_of(const model::ContactChange& change) {
  using contact::Branch;
  if (starts_force(change)) return &Event::close;
  if (ends_force(change)) return &Event::open;
  if (change.branch_before == change.branch_after) return nullptr;
  return change.branch_after == Branch::plastic ? &Event::yield : &Event::unload;
}

}  // namespace

std::vector<Event> event_list(const ContactChanges& changes, double unit) {
  std::vector<Event> list;
  for (const auto& [time, change] : changes) {
    const auto kind = kind_of(change);
    if (!kind) continue;
    if (list.empty() || list.back().time != time * unit) list.push_back({.time = time * unit});
    (list.back().*kind).push_back(change.contact);
  }
  for (auto& event : list)
    for (const auto kind : {&Event::open, &Event::close, &Event::yield, &Event::unload})
      std::sort((event.*kind).begin(), (event.*kind).end());
  return list;
}

void add_periods(std::vector<ContactHistory>& contacts, const ContactChanges& changes, const Scale& scale) {
  for (const auto& [time, change] : changes) {
    auto& periods = contacts[change.contact].periods;
    auto& meeting = contacts[change.contact].meeting;
    const double approach = change.approach * scale.velocity;
    if (starts_force(change)) {
      periods.push_back({.start = time * scale.time, .end = std::nullopt});
      if (periods.size() == 1 && approach >= 0) meeting.approach = approach;
    }
    if (!ends_force(change)) continue;
    periods.back().end = time * scale.time;
    if (periods.size() == 1) meeting.separation = -approach;
  }
}

ContactChanges beyond_noise(const ContactChanges& changes, const std::vector<bool>& felt) {
  ContactChanges kept;
  for (const auto& one : changes) {
    const auto same = [&](const auto& other) { return other.change.contact == one.change.contact; };
    const bool is_felt = felt[static_cast<std::size_t>(one.change.contact)];
    if (one.change.before == contact::ContactMode::touching && !is_felt)
      kept.erase(std::find_if(kept.rbegin(), kept.rend(), same).base() - 1);
    else
      kept.push_back(one);
  }
  return kept;
}

std::vector<Index> faded_contacts(const ContactChanges& changes, const std::vector<contact::Law>& laws) {
  using contact::ContactMode;
  std::vector<Index> list;
  for (const auto& [time, change] : changes)
    if (change.before == ContactMode::closed && change.after == ContactMode::hovering &&
        contact::pulls(laws[change.contact]))
      list.push_back(change.contact);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::vector<Skipped> skipped_by_flows(const ContactRun& run) {
  const auto used = [&](flow::Kind kind) { return run.flows[static_cast<std::size_t>(kind)].phases; };
  std::vector<Skipped> list;
  if (const Index flights = used(flow::Kind::ballistic))
    list.push_back({"free flight", phases(flights) + " in closed form, not integrated"});
  if (const Index pairs = used(flow::Kind::pair))
    list.push_back({"single contacts", phases(pairs) + " in closed form, not integrated"});
  if (const Index modal = used(flow::Kind::modal))
    list.push_back({"linear contacts", phases(modal) + " by natural modes, not integrated"});
  if (used(flow::Kind::cvode_bdf_dense) + used(flow::Kind::cvode_bdf_band) +
          used(flow::Kind::cvode_bdf_klu) ==
      0)
    list.push_back({"Newton iteration", "no phase was followed implicitly"});
  return list;
}

}  // namespace mariotte::impact
