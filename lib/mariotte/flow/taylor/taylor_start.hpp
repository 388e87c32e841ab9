// The first moments of Hertz contacts that all start undeformed: one power series instead of many graded
// steps.
#pragma once
#include "mariotte/flow/taylor/taylor_lanes.hpp"

namespace mariotte::flow::taylor {

/// Contacts struck with δ̇ > 0 and, beside them, contacts at rest that are pressed from then on. With
/// z = t^{5/4} (z = t^{5/2} if none is pressed)
///   struck:   δ = t Σ d_k zᵏ,        f = t^{3/2} Σ e_k zᵏ
///   pressed:  δ = t^{7/2} Σ d_k zᵏ,  f = t^{21/4} Σ e_k zᵏ
class Start {
 public:
  enum class Part : signed char { passive, struck, pressed };

  /// Series of the lanes that take part, to `order`; returns the time to which it holds within `tolerance`.
  double expand(const Lanes& lanes, const Part* part, int order, double tolerance);

  /// Indentations and impulses at `time`, and margins, negative where no bound rules out that a guard fires
  /// before.
  void evaluate(double time, Values& values) const;

 private:
  using Coefficients = double[order_limit + 1];
  double pushes(int lane, Part from, int k, const Coefficients* force) const;
  void next_force(int lane, int k);
  double margin(int lane, double time, double own, double given) const;

  const Lanes* lanes_ = nullptr;
  Part part_[lane_limit] = {};
  int order_ = 0;
  bool pressed_ = false;
  double power_ = 1.25;  ///< of z in t
  double half_inverse_[lane_limit];
  Coefficients rate_[lane_limit], indentation_[lane_limit], root_[lane_limit], force_[lane_limit];
};

}  // namespace mariotte::flow::taylor
