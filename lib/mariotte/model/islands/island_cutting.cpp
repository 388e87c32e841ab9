// Cutting a range of contacts, none of them inside an island, into islands and free balls.
#include <algorithm>

#include "mariotte/model/islands/islands.hpp"

namespace mariotte::model {

using contact::ContactMode;

namespace {

/// Contacts beyond its margin that an island takes along: where a row waits for its wave, where a ball comes
/// next, and where none does.
constexpr Index along_row = 8, ahead = 2, behind = 1;

}  // namespace

/// Dissolve an island into the range to be cut.
void Islands::absorb(Index id) {
  const auto& island = *islands_[id];
  from_ = std::min(from_, island.first);
  to_ = std::max(to_, island.last - 1);
  dissolve(id);
}

/// The islands whose end balls meet at contact j.
void Islands::absorb_owners(Index j) {
  for (const Index ball : {j, j + 1})
    if (owner_[ball] >= 0) absorb(owner_[ball]);
}

void Islands::cut() {
  const Index last = balls_.contacts() - 1;
  for (Index known = -1; known < to_ - from_;) {  // until nothing more is absorbed
    known = to_ - from_;
    close_due();
    find_groups(balls_.state(), balls_.modes(), std::max<Index>(0, from_ - 1), std::min(last, to_ + 1),
                margin_of_rows_, groups_);
    if (const Index owner = find_owner_in_the_way(); owner >= 0) absorb(owner);
  }
  form_groups();
}

/// Contacts that close within what cannot be told from now, and the rows that all new contacts press.
void Islands::close_due() {
  const Index first = std::max<Index>(0, from_ - 1), last = std::min(balls_.contacts() - 1, to_ + 1);
  for (Index j = first; j <= last; ++j) {
    if (is_inside(j)) continue;
    balls_.move_contact(j, now_);
    if (owner_[j] < 0) balls_.move_ball(j, now_);
    if (owner_[j + 1] < 0) balls_.move_ball(j + 1, now_);
  }
  auto& mode = balls_.modes();
  for (Index j = first; j <= last; ++j) {
    if (is_inside(j)) continue;
    if (balls_.is_due(j, now_, options_.accuracy)) {
      absorb_owners(j);
      pass(j);
    }
    if (!contact::carries_force(mode[j])) continue;
    press(j, 1);
    press(j, -1);
  }
}

void Islands::pass(Index j) {
  auto& mode = balls_.modes();
  const auto known = changes_.size();
  change(mode, j, after(balls_.state(), j, mode[j], false), chain_.law[j], changes_);
  tell_approach(balls_.state(), known, changes_);
}

void Islands::press(Index from, Index direction) {
  for (Index j = from + direction; j >= 0 && j < balls_.contacts(); j += direction) {
    if (is_inside(j)) absorb(owner_[j]);
    if (!balls_.rests(j, now_)) return;
    change(balls_.modes(), j, ContactMode::touching, chain_.law[j], changes_);
  }
}

/// An island that holds a ball which one of the groups needs.
Index Islands::find_owner_in_the_way() const {
  for (const auto& group : groups_)
    for (Index i = std::max<Index>(0, group.first - group.left_margin);
         i <= std::min(balls_.contacts(), group.last + 1 + group.right_margin); ++i)
      if (owner_[i] >= 0) return owner_[i];
  return -1;
}

/// How many contacts beyond the margin of an active `contact` its island takes along in that direction.
Index Islands::spare(Index contact, Index direction) const {
  const Index next = contact + direction;
  if (next < 0 || next >= balls_.contacts()) return 0;
  if (balls_.modes()[next] == ContactMode::touching) return along_row;
  return balls_.approach(next, now_) > chain_.noise_speed ? ahead : behind;
}

/// The ball that stands `most` balls from `ball` in a direction, or the last on the way there that is free.
Index Islands::walk(Index ball, Index direction, Index most) const {
  for (; most > 0; --most) {
    const Index next = ball + direction;
    if (next < 0 || next > balls_.contacts() || owner_[next] >= 0) break;
    ball = next;
  }
  return ball;
}

void Islands::form_groups() {
  Index first_touched = from_, last_touched = to_;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const auto& group = groups_[g];
    Index room = balls_.contacts();
    if (g + 1 < groups_.size()) {  // of the balls between, half, unless either group needs more
      const Index between = groups_[g + 1].first - group.last - 2;
      room = std::clamp(between / 2, group.right_margin, between - groups_[g + 1].left_margin);
    }
    const Index first = walk(group.first, -1, group.left_margin + spare(group.first, -1));
    const Index last = walk(group.last + 1, 1, std::min(room, group.right_margin + spare(group.last, 1)));
    form(first, last);
    first_touched = std::min(first_touched, first);
    last_touched = std::max(last_touched, last - 1);
  }
  const Index last = std::min(balls_.contacts() - 1, last_touched + 1);
  for (Index j = std::max<Index>(0, first_touched - 1); j <= last; ++j)
    if (!is_inside(j)) schedule(j);
}

void Islands::schedule(Index j) {
  balls_.move_contact(j, now_);
  const auto time = balls_.meeting(j, now_);
  if (std::isfinite(time.value))
    queue_.meet(j, time);
  else
    queue_.cancel_meeting(j);
}

}  // namespace mariotte::model
