// The first moments of Hertz contacts that all start undeformed: one power series instead of many graded
// steps.
#pragma once
#include <span>
#include <vector>

#include "mariotte/flow/taylor/start_powers.hpp"

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

  /// The power of t in z.
  double power() const { return power_; }
  /// Of δ/t and √(δ/t) as series in z, of a lane that takes part.
  void coefficients(int lane, std::span<double> indentation, std::span<double> root) const;

 private:
  struct Lane : StartPowers<double> {
    Part part = Part::passive;
    Coefficients rate;
  };
  /// What the forces of the others have done to an indentation, and what that of its own has taken away.
  struct Travel {
    double given = 0, drawn = 0, own = 0;
  };
  double pushes(int lane, Part from, int k) const;
  double safe_place() const;
  void sweep(double time, Values& values) const;
  double margin(int lane, double time, const Travel& travel) const;

  const Lanes* lanes_ = nullptr;
  int order_ = 0;
  bool pressed_ = false;
  double power_ = 1.25;  ///< of z in t
  std::vector<Lane> lane_;
  mutable std::vector<double> swept_;  ///< ∫∫ f dt dt, while a place is evaluated
};

}  // namespace mariotte::flow::taylor
