#include "mariotte/impact/sensitivity/adjoint/motion_record.hpp"

namespace mariotte::impact {
namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, Index begin, Index count) {
  to.insert(to.end(), from.begin() + begin, from.begin() + begin + count);
}

template <class T>
std::size_t size_of(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

/// What some stretches hold.
struct Sums {
  Index pieces = 0, contacts = 0, rates = 0, closings = 0;

  void add(const MotionRecord::Stretch& one) {
    pieces += one.pieces;
    contacts += one.contacts;
    rates += one.rates;
    closings += one.closings;
  }
};

}  // namespace

std::size_t MotionRecord::bytes() const {
  return size_of(stretch) + size_of(piece) + size_of(contact) + size_of(rate) + size_of(closing);
}

MotionRecord part_of(const MotionRecord& motion, Index from, Index to) {
  Sums before, within;
  for (Index i = 0; i < to; ++i) (i < from ? before : within).add(motion.stretch[i]);
  MotionRecord part;
  append(part.stretch, motion.stretch, from, to - from);
  append(part.piece, motion.piece, before.pieces, within.pieces);
  append(part.contact, motion.contact, before.contacts, within.contacts);
  append(part.rate, motion.rate, before.rates, within.rates);
  append(part.closing, motion.closing, before.closings, within.closings);
  return part;
}

void append(MotionRecord& motion, const MotionRecord& more) {
  const auto add = [](auto& to, const auto& from) { append(to, from, 0, std::ssize(from)); };
  add(motion.stretch, more.stretch);
  add(motion.piece, more.piece);
  add(motion.contact, more.contact);
  add(motion.rate, more.rate);
  add(motion.closing, more.closing);
}

}  // namespace mariotte::impact
