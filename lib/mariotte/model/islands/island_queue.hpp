// What happens next in a chain of islands.
#pragma once
#include <algorithm>
#include <iterator>
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// Two free balls meet at a contact, or an island arrives.
struct Appointment {
  enum class Kind : unsigned char { meeting, arrival };
  Instant time;
  Index of;  ///< contact or island
  unsigned version;
  Kind kind;
};

/// Appointments by time. Each contact and each island has one at most: a new one replaces the old, which
/// stays in the heap until its time comes and is then passed over, or until such as these are the most of it.
class IslandQueue {
 public:
  explicit IslandQueue(Index contacts) : meeting_(contacts) {}

  void meet(Index contact, Instant time) {
    cancel_meeting(contact);
    ++meetings_;
    add({time, contact, ++meeting_[contact], Appointment::Kind::meeting});
  }
  void cancel_meeting(Index contact) {
    meetings_ -= has_meeting(contact);
    meeting_[contact] += has_meeting(contact);
  }
  bool has_meeting(Index contact) const { return meeting_[contact] % 2 == 1; }
  Index meetings() const { return meetings_; }

  void arrive(Index island, Instant time) {
    if (island >= std::ssize(arrival_)) arrival_.resize(island + 1);
    if (std::ssize(heap_) > 64 + 4 * (meetings_ + std::ssize(arrival_))) forget_replaced();
    add({time, island, ++arrival_[island], Appointment::Kind::arrival});
  }
  void cancel_arrival(Index island) { ++arrival_[island]; }

  /// What a copy takes.
  std::size_t bytes() const {
    return (meeting_.size() + arrival_.size()) * sizeof(unsigned) + heap_.size() * sizeof(Appointment);
  }

  /// The earliest, or null.
  const Appointment* next() {
    while (!heap_.empty() && !is_valid(heap_.front())) drop();
    return heap_.empty() ? nullptr : &heap_.front();
  }
  /// Take the earliest, of which there must be one.
  Appointment pop() {
    const auto first = heap_.front();
    drop();
    if (first.kind == Appointment::Kind::meeting) cancel_meeting(first.of);
    return first;
  }

 private:
  static bool later(const Appointment& a, const Appointment& b) { return a.time > b.time; }
  bool is_valid(const Appointment& a) const {
    return (a.kind == Appointment::Kind::meeting ? meeting_ : arrival_)[a.of] == a.version;
  }
  void add(const Appointment& appointment) {
    heap_.push_back(appointment);
    std::push_heap(heap_.begin(), heap_.end(), later);
  }
  void forget_replaced() {
    std::erase_if(heap_, [&](const Appointment& a) { return !is_valid(a); });
    std::make_heap(heap_.begin(), heap_.end(), later);
  }
  void drop() {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
  }

  std::vector<unsigned> meeting_, arrival_;  ///< the valid version; of a contact odd while it has one
  Index meetings_ = 0;
  std::vector<Appointment> heap_;
};

}  // namespace mariotte::model
