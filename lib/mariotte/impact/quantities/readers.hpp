// How quantities are read, for the lists alone: what several models have in common.
#pragma once
#include "mariotte/impact/quantities/quantity.hpp"

namespace mariotte::impact {

inline Value value(const std::optional<double>& number) {
  return number ? Value(*number) : Value();
}
template <class Plain>
Value value(const Plain& plain) {
  return plain;
}

/// Readers of a member of the result, of its energy, of an element of one of its arrays.
template <auto member>
inline constexpr auto own = [](const auto& r, Indices) -> Value { return value(r.*member); };
template <auto member>
inline constexpr auto energy = [](const auto& r, Indices) -> Value { return value(r.energy.*member); };
template <auto array>
inline constexpr auto element = [](const auto& r, Indices at) -> Value { return value((r.*array)[at[0]]); };
template <auto array, auto member>
inline constexpr auto of_element =
    [](const auto& r, Indices at) -> Value { return value((r.*array)[at[0]].*member); };

/// How fast the two of a contact met, or parted.
template <auto contacts, auto member>
inline constexpr auto meeting =
    [](const auto& r, Indices at) -> Value { return value((r.*contacts)[at[0]].meeting.*member); };

template <auto array>
inline constexpr auto size_of = [](const auto& r, Indices) -> Count { return std::ssize(r.*array); };
/// Of an array that every element has.
template <auto array, auto member>
inline constexpr auto size_in =
    [](const auto& r, Indices at) -> Count { return std::ssize((r.*array)[at[0]].*member); };
template <Index length>
inline constexpr auto fixed = [](const auto&, Indices) -> Count { return length; };

/// A position in a list of an event, told from 1.
template <auto member>
inline constexpr auto numbered =
    [](const auto& r, Indices at) -> Value { return (r.events[at[0]].*member)[at[1]] + 1; };

inline Value component(const Vector3& v, Index i) {
  return i == 0 ? v.e1 : i == 1 ? v.e2 : v.e3;
}

template <class Impact>
using List = std::vector<Quantity<Impact>>;

template <class Impact>
void append(List<Impact>& list, const List<Impact>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

template <std::size_t limit>
inline constexpr auto validity_at = [](const auto& r, Indices) -> Value {
  const auto& number = r.validity.*(validity_limits[limit].number);
  return number ? Value(number->value) : Value(Omitted());
};

/// How far a run came towards the limits of its laws.
template <class I>
List<I> validity() {
  List<I> list;
  const auto add = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
    const auto& [key, unit, symbol, meaning, number, limit, from_below, otherwise, of] = validity_limits[k];
    constexpr auto others = std::is_same_v<I, MicrobodyImpact> ? ToldOf::contacts : ToldOf::tips;
    if (of != others)
      list.push_back({.is = {key, unit, symbol, meaning}, .read = validity_at<k>, .needs_peaks = true});
  };
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (add(std::integral_constant<std::size_t, k>()), ...);
  }
  (std::make_index_sequence<validity_limits.size()>());
  return list;
}

/// How a run was computed, the same for every model: the end of each list.
template <class I>
List<I> cost_of_run() {
  return {
      {.is = {"accuracy.requested", "1", "", "accuracy asked for, relative to the largest incident speed"},
       .read = own<&I::requested_accuracy>},
      {.is = {"accuracy.estimated", "1", "", "upper bound on the error, where one was estimated"},
       .read = own<&I::estimated_accuracy>},
      {.is = {"flows[]", "", "", "flows that followed at least one phase"},
       .count = size_of<&I::flows>,
       .counted_by_run = true},
      {.is = {"flows[].name", "", "", "word for the flow, as --flow spells it"},
       .read = of_element<&I::flows, &FlowUse::name>},
      {.is = {"flows[].phases", "1", "", "phases it followed"},
       .read = of_element<&I::flows, &FlowUse::phases>},
      {.is = {"flows[].steps", "1", "", "steps it took"}, .read = of_element<&I::flows, &FlowUse::steps>},
      {.is = {"flows[].rhs", "1", "", "evaluations of the right-hand side"},
       .read = of_element<&I::flows, &FlowUse::rhs>},
  };
}

}  // namespace mariotte::impact
