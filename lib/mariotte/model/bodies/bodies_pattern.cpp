#include "mariotte/model/bodies/bodies_pattern.hpp"

#include <algorithm>
#include <utility>

namespace mariotte::model {
namespace {

template <int D>
class Pattern {
 public:
  Pattern(const BodiesSetting<D>& setting, const BodiesLayout<D>& layout, const BodiesMode& mode)
      : setting_(setting),
        at_(layout),
        mode_(mode),
        pushed_(layout.bodies),
        part_(layout.bodies),
        rows_of_part_(layout.bodies) {
    for (Index body = 0; body < at_.bodies; ++body) {
      part_[body] = body;
      add_range(at_.velocity(body), D + turns(D), pushed_[body]);
    }
    for (const auto& one : mode.closed) {
      if (loses_by_load_rate(one))
        for_each_body(one, [&](Index body) { pushed_[body].push_back(at_.losses(one.slot)); });
      if (sticks(one)) join(one);
    }
    for (const auto& one : mode.closed)
      if (sticks(one)) add_rows(one, rows_of_part_[part_of(one)]);
  }

  std::vector<flow::Entry> entries() {
    for (Index body = 0; body < at_.bodies; ++body) add_body(body);
    add(at_.clock(), 1, {}, [&](const auto& one) { return !has_a(one); });
    for (const auto& one : mode_.closed)
      add(at_.spring(one.slot), at_.tangents, {}, [&](const auto& other) { return &other == &one; });
    return std::move(entries_);
  }

 private:
  using Rows = std::vector<Index>;

  const SettingContact<D>& contact(const ClosedContact& one) const { return setting_.contact[one.contact]; }
  bool has_a(const ClosedContact& one) const { return contact(one).plane < 0; }
  Index body_a(const ClosedContact& one) const { return setting_.sphere[contact(one).a].body; }
  Index body_b(const ClosedContact& one) const { return setting_.sphere[contact(one).b].body; }
  template <class Use>
  void for_each_body(const ClosedContact& one, Use&& use) const {
    use(body_b(one));
    if (has_a(one)) use(body_a(one));
  }
  bool touches(const ClosedContact& one, Index body) const {
    return body_b(one) == body || (has_a(one) && body_a(one) == body);
  }
  bool sticks(const ClosedContact& one) const {
    return contact(one).tangential.law == TangentialLaw::rigid && one.friction == Friction::stick;
  }

  /// Forces of contacts that stick rigidly are solved for together, where they share bodies.
  Index part_of(const ClosedContact& one) const { return part_[body_b(one)]; }
  void join(const ClosedContact& one) {
    if (!has_a(one)) return;
    const Index old = part_[body_a(one)], joined = part_of(one);
    std::replace(part_.begin(), part_.end(), old, joined);
  }

  /// A spring that slips loses what its load leaves of it, and the rate of a damped load depends on
  /// accelerations.
  bool loses_by_load_rate(const ClosedContact& one) const {
    return one.friction == Friction::slip && !one.slack && contact(one).tangential.has_spring() &&
           contact::is_damped(contact(one).law);
  }

  /// Contacts of a ball about its mass centre do not feel how it has turned.
  void add_body(Index body) {
    const auto& shape = setting_.body[body];
    const bool shows_turn = shape.has_arms || !shape.is_round;
    const auto touched = [&](const auto& one) { return touches(one, body); };
    Rows shift, turn;
    add_range(at_.shift(body), D, shift);
    add_range(at_.turn(body), at_.attitude, turn);
    add(at_.shift(body), D, {}, touched);
    add(at_.turn(body), at_.attitude, turn, [&](const auto& one) { return shows_turn && touched(one); });
    add(at_.velocity(body), D, shift, touched);
    add(at_.momentum(body), turns(D), turn, touched);
  }

  static void add_range(Index first, Index count, Rows& rows) {
    for (Index row = first; row < first + count; ++row) rows.push_back(row);
  }
  static void append(const Rows& more, Rows& rows) { rows.insert(rows.end(), more.begin(), more.end()); }
  /// What the force of a contact changes.
  void add_rows(const ClosedContact& one, Rows& rows) const {
    add_range(at_.spring(one.slot), at_.slot_size, rows);
    for_each_body(one, [&](Index body) { append(pushed_[body], rows); });
  }

  /// Columns alike: these rows, and those of contacts whose force changes.
  template <class Changes>
  void add(Index first, Index count, Rows rows, Changes&& changes) {
    for (const auto& one : mode_.closed) {
      if (!changes(one)) continue;
      add_rows(one, rows);
      for_each_body(one, [&](Index body) { append(rows_of_part_[part_[body]], rows); });
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    for (Index column = first; column < first + count; ++column)
      for (const Index row : rows) entries_.push_back({row, column});
  }

  const BodiesSetting<D>& setting_;
  const BodiesLayout<D>& at_;
  const BodiesMode& mode_;
  std::vector<Rows> pushed_;  ///< by body: its accelerations, and losses of slips, whose load they change
  std::vector<Index> part_;   ///< by body: the same where rigid sticks join them
  std::vector<Rows> rows_of_part_;  ///< of the sticks in it
  std::vector<flow::Entry> entries_;
};

}  // namespace

template <int D>
std::vector<flow::Entry> pattern_of(const BodiesSetting<D>& setting, const BodiesLayout<D>& layout,
                                    const BodiesMode& mode) {
  return Pattern<D>(setting, layout, mode).entries();
}

std::vector<Index> colours_of(const std::vector<flow::Entry>& pattern, Index columns) {
  std::vector<Index> colours(columns, -1);
  std::vector<std::vector<bool>> is_taken;  // by colour and row
  for (auto first = pattern.begin(); first != pattern.end();) {
    const auto last = std::find_if(first, pattern.end(), [&](auto e) { return e.column != first->column; });
    auto colour = std::find_if(is_taken.begin(), is_taken.end(), [&](const auto& rows) {
      return std::none_of(first, last, [&](auto e) { return rows[e.row]; });
    });
    if (colour == is_taken.end()) colour = is_taken.insert(colour, std::vector<bool>(columns, false));
    for (auto e = first; e != last; ++e) (*colour)[e->row] = true;
    colours[first->column] = colour - is_taken.begin();
    first = last;
  }
  return colours;
}

template std::vector<flow::Entry> pattern_of(const BodiesSetting<2>&, const BodiesLayout<2>&,
                                             const BodiesMode&);
template std::vector<flow::Entry> pattern_of(const BodiesSetting<3>&, const BodiesLayout<3>&,
                                             const BodiesMode&);

}  // namespace mariotte::model
