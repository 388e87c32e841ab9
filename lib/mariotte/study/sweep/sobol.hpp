// Points that fill a cube more evenly than chance.
#pragma once
#include <cstdint>

#include "mariotte/core/types.hpp"

namespace mariotte::study {

/// Coordinate of a point of the sequence of Sobol in [0, 1), from 0 both, with its digits shifted by a seed;
/// directions of Joe & Kuo 2008. Any 2^k neighbours from a multiple of 2^k on have one point in each of 2^k
/// equal intervals, in every coordinate.
double sobol(std::uint64_t seed, std::size_t coordinate, std::uint64_t point);

/// The most coordinates.
inline constexpr std::size_t most_sobol_coordinates = 3667;

}  // namespace mariotte::study
