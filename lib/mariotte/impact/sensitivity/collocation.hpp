// Linear equations S' = A(t) S + B(t), along a trajectory that is known, by collocation in Gauss points.
//
// Forces are not smooth where a contact begins or ends, δ^{n−1} ~ t^{n−1}. So time is a polynomial of the
// clock u there. At a beginning, which is met exactly, t ~ u⁴, in which square and fourth roots are smooth.
// Towards an end the root of the time left falls evenly, so that no point is so near that rounding of the
// indentation matters; its fourth root where slopes need it. What the points do not resolve is halved.
#pragma once
#include <memory>
#include <vector>

#include "mariotte/flow/problem.hpp"
#include "mariotte/impact/sensitivity/slope_matrix.hpp"

namespace mariotte::impact {

/// A and B of a phase.
class LinearField {
 public:
  virtual ~LinearField() = default;
  /// A at the places of `pattern`, in its order, and B, where `left` is the time until the end. Returns by
  /// how much their errors exceed rounding of what they are.
  virtual double at(double time, double left, std::span<double> jacobian, SlopeMatrix& source) = 0;
};

/// Whether a phase begins with a step, and where it will end, in lengths of the step beyond its end: forces
/// may have roots there.
struct Edges {
  bool begins;
  double beyond = infinity;
  bool is_steep = false;  ///< slopes of the force grow there faster than the inverse of the root
};

/// Keeps its memory from piece to piece.
class Collocation {
 public:
  /// Components have natural `magnitudes`, and columns natural sizes relative to these: what is small beside
  /// both need not be resolved; `places` are components whose slopes tell nothing of that, as where bodies
  /// are that have flown along. Those that are `unneeded` change by B alone. A has entries at the places of
  /// `pattern` alone.
  Collocation(std::vector<flow::Entry> pattern, std::span<const double> magnitudes,
              std::span<const double> sizes, double accuracy, const std::vector<Index>& places = {},
              const std::vector<Index>& unneeded = {});
  ~Collocation();
  Collocation(const Collocation&) = delete;
  Collocation& operator=(const Collocation&) = delete;

  /// Carry slopes from `start` to `end`.
  void advance(LinearField& field, double start, double end, Edges edges, SlopeMatrix& slopes);
  /// Largest error of a piece that could not be halved any further, relative to the slopes.
  double unresolved() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
