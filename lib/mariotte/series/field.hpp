// What a field is: the right-hand side of a phase, written once, over any kind of number.
//
//   struct Fall {
//     enum { height, speed, states, energy = states, rows };
//     enum { gravity, drag, parameters };
//     template <class T>
//     static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
//       std::array<T, rows> row{};
//       row[height] = x[speed];
//       row[speed] = -p[gravity] - p[drag] * x[speed];
//       row[energy] = p[gravity] * x[height] + 0.5 * (x[speed] * x[speed]);
//       return row;
//     }
//   };
//
// The first `states` rows are the rates of the states; the others are values that somebody wants to see.
// A field has no branch on data: modes are flags of a template.
#pragma once
#include <array>

// What need not be fast compiles faster without inlining by force; sanitizers would crawl through it.
#ifdef MARIOTTE_SERIES_CALLS
#define MARIOTTE_SERIES_INLINE inline
#define MARIOTTE_SERIES_LAMBDA
#else
#define MARIOTTE_SERIES_INLINE inline __attribute__((always_inline))
#define MARIOTTE_SERIES_LAMBDA __attribute__((always_inline))
#endif

namespace mariotte::series {

/// How many states and rows a field has.
template <class Field>
inline constexpr int states_of = Field::states;
template <class Field>
inline constexpr int rows_of = Field::rows;

/// Whether all parts of a row are the same; a field that has such states says which.
template <class Field>
constexpr bool is_uniform(int row) {
  if constexpr (requires { Field::is_uniform(0); })
    return Field::is_uniform(row);
  else
    return false;
}

template <class Field, class T>
using States = std::array<T, Field::states>;
template <class Field, class T>
using Parameters = std::array<T, Field::parameters>;
template <class Field, class T>
using Values = std::array<T, Field::rows>;

}  // namespace mariotte::series
