#include "mariotte/model/islands/islands.hpp"

#include <algorithm>
#include <utility>

namespace mariotte::model {

using contact::ContactMode;
using flow::Outcome;
using hybrid::Ending;

Islands::Islands(const DimensionlessChain& chain, const ChainLayout& layout, FreeBalls balls,
                 const hybrid::Options& options, bool stay, IslandObserverMaker make_log)
    : chain_(chain),
      options_(options),
      requested_(options.flow),
      stay_(stay),
      margin_of_rows_(margin_of_rows(chain)),
      make_log_(std::move(make_log)),
      balls_(std::move(balls)),
      owner_(layout.velocities(), -1),
      queue_(layout.contacts()),
      snapshot_(balls_, owner_, islands_, options) {
  for (Index j = 0; j < layout.contacts(); ++j)
    if (chain.inverse_mass[j] == 0 || chain.inverse_mass[j + 1] == 0) walls_.push_back(j);
}

Islands::Islands(const DimensionlessChain& chain, const ChainLayout& layout, ConstState start,
                 const hybrid::Options& options, bool stay, IslandObserverMaker make_log)
    : Islands(chain, layout, FreeBalls(chain, layout, start), options, stay, std::move(make_log)) {
  contact_set_at(balls_.state(), balls_.modes(), changes_);
}

void Islands::run(SnapshotObserver* observer) {
  observer_ = observer;
  begin();
  for (record(); run_.message.empty(); record()) {
    const auto* next = queue_.next();
    if (!next || is_over()) return end(Ending::separated);
    if (run_.events >= options_.max_events) return end(Ending::event_limit);
    if (observer_ && observer_->gives_up()) return end(Ending::interrupted);
    if (observer_) show(std::min(next->time.value, options_.max_time));
    if (is_beyond_limit(*next)) {
      now_ = {options_.max_time};
      return end(Ending::time_limit);
    }
    keep(queue_.pop());
  }
  end(Ending::failed);
}

void Islands::begin() {
  if (islands_.empty()) {
    from_ = 0;
    to_ = balls_.contacts() - 1;
    return cut();
  }
  for (Index id = 0; id < std::ssize(islands_); ++id)
    if (std::find(unused_.begin(), unused_.end(), id) == unused_.end()) {
      prepare(*islands_[id]);
      go_on(id);
    }
}

bool Islands::is_beyond_limit(const Appointment& next) const {
  const bool arrives = next.kind == Appointment::Kind::arrival;
  return next.time.value > options_.max_time ||
         (arrives && islands_[next.of]->arrival.outcome == Outcome::limit);
}

/// Where gravity leads back to a wall: the end of the first impact, when all contacts are open and nothing
/// approaches.
bool Islands::is_over() {
  if (!chain_.falls_back || stay_ || run_.events == 0 || islands_.size() > unused_.size()) return false;
  const auto approaches = [&](Index j) {
    return comes_together(balls_.state().topology, j, balls_.approach(j, now_));
  };
  if (std::any_of(walls_.begin(), walls_.end(), approaches)) return false;
  const auto returns = [&](Index j) { return queue_.has_meeting(j); };
  return queue_.meetings() == std::count_if(walls_.begin(), walls_.end(), returns);
}

void Islands::keep(const Appointment& appointment) {
  if (appointment.kind == Appointment::Kind::meeting) {
    now_ = appointment.time;
    return meet(appointment.of);
  }
  now_ = islands_[appointment.of]->arrives();
  arrive(appointment.of);
}

void Islands::arrive(Index id) {
  auto& island = *islands_[id];
  commit(island);
  const auto repetition = find_repetition(island);
  if (!repetition && is_well_cut(island)) return go_on(id);
  from_ = balls_.contacts();
  to_ = -1;
  absorb(id);
  if (repetition) move_on(island, *repetition);
  cut();
}

void Islands::meet(Index j) {
  from_ = to_ = j;
  absorb_owners(j);
  balls_.move_contact(j, now_);
  balls_.move_ball(j, now_);
  balls_.move_ball(j + 1, now_);
  balls_.touch(j);
  auto& mode = balls_.modes();
  if (mode[j] != ContactMode::touching) pass(j);
  cut();
}

void Islands::record() {
  hybrid::record(run_, now_.value, changes_);
}

void Islands::show(double until) {
  for (double time = observer_->next_look(); time < until; time = observer_->next_look()) {
    snapshot_.move_to({time});
    observer_->look(snapshot_);
  }
  observer_->passed(now_.value, run_.events);
}

void Islands::end(Ending ending) {
  if (observer_) {
    snapshot_.move_to(now_);
    observer_->look_last(snapshot_);
  }
  for (std::size_t id = 0; id < islands_.size(); ++id)
    if (std::find(unused_.begin(), unused_.end(), static_cast<Index>(id)) == unused_.end())
      dissolve(static_cast<Index>(id));
  if (ending == Ending::separated) open_touching(balls_.modes(), chain_.law, changes_);
  record();
  run_.ending = ending;
  run_.time = now_.value;
  run_.state = balls_.take(now_);
}

flow::Request Islands::request_of(Island& island, double limit) {
  constexpr double accuracy_of_steady = 1e-13;  // less would not let a wave repeat itself within rounding
  auto* log = island.log.get();
  if (log) log->begin(island.system, island.first, island.clock);
  if (!island.may_be_steady) return {.limit = limit, .accuracy = options_.accuracy, .observer = log};
  island.crest_from = island.clock;
  island.crest.begin(island.system, island.start, log);
  return {
      .limit = limit, .accuracy = std::min(options_.accuracy, accuracy_of_steady), .observer = &island.crest};
}

void Islands::follow(Island& island, double limit, bool patient) {
  island.mode = island.held;
  auto& problem = island.system.problem(island.mode);
  const bool stiff = island.arrival.outcome == Outcome::stiff;
  auto choice = stiff ? flows_.instead_of(flow::Kind::taylor, true, problem, requested_)
                      : std::optional(flows_.choose(problem, requested_));
  while (choice) {
    island.x = island.start;
    island.fired.clear();
    auto request = request_of(island, limit);
    request.most_steps = most_steps_;
    request.patient = patient;
    island.arrival = choice->flow.follow(problem, island.x, request, island.fired);
    hybrid::count(run_.flows[static_cast<std::size_t>(choice->kind)], island.arrival);
    const bool ends = island.arrival.outcome != Outcome::stiff && island.arrival.outcome != Outcome::failed;
    if (stiff && ends) most_steps_ = flow::worth_while(island.arrival);
    if (island.arrival.outcome != Outcome::failed) return;
    const auto next = flows_.instead_of(choice->kind, false, problem, requested_);
    choice.reset();
    if (next) choice.emplace(*next);
  }
}

/// What was uncertain is certain now.
void Islands::commit(Island& island) {
  const auto known = changes_.size();
  island.system.transition(island.mode, island.fired, island.x, changes_);
  for (auto change = changes_.begin() + known; change != changes_.end(); ++change)
    change->contact += island.first;
  island.clock = island.arrives();
  island.start.swap(island.x);
  std::swap(island.held, island.mode);
  if (island.log) island.log->keep();
  if (island.arrival.outcome == Outcome::failed) run_.message = island.arrival.message;
  if (island.arrival.outcome == Outcome::never) run_.message = "an island waits for a guard that never fires";
}

/// Bring an island to the present, and free its balls.
void Islands::dissolve(Index id) {
  auto& island = *islands_[id];
  if (island.clock < now_ && island.arrives() > now_) {
    follow(island, now_ - island.clock, true);
    ++count_.redone;
  }
  while (island.clock < now_) {
    commit(island);
    if (island.arrival.outcome == Outcome::limit) island.clock = now_;
    if (island.arrival.outcome != Outcome::guard) break;
    if (island.clock < now_) follow(island, now_ - island.clock, true);
  }
  for (const Index j : {island.first - 1, island.last})
    if (j >= 0 && j < balls_.contacts()) balls_.move_contact(j, now_);
  std::copy(island.start.begin(), island.start.end(), balls_.slice(island.first, island.last).begin());
  put_slice(island.held, island.first, balls_.modes());
  balls_.stamp(island.first, island.last, now_);
  std::fill(owner_.begin() + island.first, owner_.begin() + island.last + 1, -1);
  queue_.cancel_arrival(id);
  unused_.push_back(id);
}

Island& Islands::add_island() {
  islands_.push_back(std::make_unique<Island>());
  if (make_log_) islands_.back()->log = make_log_();
  return *islands_.back();
}

void Islands::form(Index first, Index last) {
  if (unused_.empty()) {
    unused_.push_back(std::ssize(islands_));
    add_island();
  }
  const Index id = unused_.back();
  unused_.pop_back();
  for (Index j = first; j < last; ++j) balls_.move_contact(j, now_), queue_.cancel_meeting(j);
  for (Index i = first; i <= last; ++i) balls_.move_ball(i, now_);
  std::fill(owner_.begin() + first, owner_.begin() + last + 1, static_cast<int>(id));

  auto& island = *islands_[id];
  island.first = first;
  island.last = last;
  island.clock = now_;
  const auto state = balls_.slice(first, last);
  island.start.assign(state.begin(), state.end());
  copy_slice(balls_.modes(), first, last, island.held);
  prepare(island);
  go_on(id);
  ++count_.formed;
  count_.widest = std::max(count_.widest, last - first);
  count_.at_once = std::max(count_.at_once, std::ssize(islands_) - std::ssize(unused_));
}

void Islands::prepare(Island& island) const {
  island.system.reset(chain_, island.first, island.last, margin_of_rows_);
  island.may_be_steady = may_become_steady(island);
}

/// Follow an island to its next guard: uncertain until its turn comes.
void Islands::go_on(Index id) {
  auto& island = *islands_[id];
  follow(island, options_.max_time - island.clock.value);
  queue_.arrive(id, island.arrives());
}

}  // namespace mariotte::model
