// Vocabulary types shared by every module.
#pragma once
#include <cstddef>
#include <limits>
#include <span>

namespace mariotte {

using Index = std::ptrdiff_t;                ///< counts and positions, from 0
using ConstState = std::span<const double>;  ///< a state, read
using State = std::span<double>;             ///< a state, written

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace mariotte
