// Slopes along a step whose contacts are known as formulas: no step is divided, and nothing is solved.
//
// All that contacts do is their impulses. With the slopes of these,
//
//   V = S_v + Σ (push P)_p + a_p t,   X = ∫ V dt,   S_g = S_g(0) + G X,
//
// where X are the displacements. Free flight has no impulses. One undamped contact of any power law alone
// moves by δ̈ = −κ δⁿ, whose slopes are combinations of δ̇ (a shift in time), δ + (n−1)/2 t δ̇ (other units) and
// t δ̇/(2κ). Where the flow has expanded all contacts in power series, the slopes are such series, too: φ =
// f_δ S_δ + f_δ̇ S_δ̇ + f_p costs one convolution per contact.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "mariotte/contact/contact_set.hpp"
#include "mariotte/flow/flow.hpp"
#include "mariotte/impact/sensitivity/alone_step.hpp"
#include "mariotte/impact/sensitivity/contact_slope.hpp"
#include "mariotte/impact/sensitivity/push_expansion.hpp"
#include "mariotte/impact/sensitivity/slope_matrix.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::impact {

/// For the contacts of one model. Their slopes and those of accelerations must outlive it.
template <class Topology>
class PushSlopes {
 public:
  using Scaled = typename Topology::Model;

  /// `natural` are the sizes of columns of a component of size one; what is `accuracy` of it is small.
  PushSlopes(const Scaled& model, const model::ContactLayout& layout,
             const std::vector<ContactSlope>& contacts, const SlopeMatrix& acceleration,
             const std::vector<double>& natural, double accuracy);

  /// Carry slopes along the step, but for those of works, which nothing depends on. False, and nothing done,
  /// where no formula is known or it is not good enough.
  bool advance(const flow::Step& step, const contact::ContactSet& mode, SlopeMatrix& slopes);

 private:
  using Term = PushExpansion::Term;

  /// A contact as what moves and is moved by it; velocities by number.
  struct Reach {
    std::vector<Term> push, direction;
    double mobility = 0;  ///< 1/m*
  };

  bool gather(const contact::ContactSet& mode);
  std::optional<AloneStep> alone_step(const flow::Step& step, Index j) const;
  bool follow_alone(const flow::Step& step, Index j, const SlopeMatrix& slopes);
  bool follow_series(const flow::Step& step, SlopeMatrix& slopes);
  bool carry(flow::PushSeries& series, SlopeMatrix& slopes, int pieces);
  double expand(const flow::PushSeries& series, const SlopeMatrix& slopes);
  bool add_shallow(const flow::Step& step, const SlopeMatrix& before, SlopeMatrix& after);
  double largest_gain(const flow::Step& step, Index j) const;
  template <class Change>
  bool is_small(Change&& change) const;
  bool push_shallow(const flow::Step& step, Index j, const SlopeMatrix& before, SlopeMatrix& after);
  void fly(double duration, const SlopeMatrix& slopes);
  void give(Index j, Index column, double impulse, double travel);
  void finish(SlopeMatrix& slopes) const;
  double along(Index j, const SlopeMatrix& motion, Index column) const;
  double gap_rate(Index j, const SlopeMatrix& slopes, Index column) const;

  const Scaled& model_;
  const model::ContactLayout& layout_;
  const std::vector<ContactSlope>& contact_;
  const SlopeMatrix& acceleration_;
  const std::vector<double>& natural_;
  double accuracy_;
  std::vector<Reach> reach_;
  std::vector<Index> number_;      ///< of a velocity, by its place
  std::vector<Index> contact_at_;  ///< of a gap, by its place
  std::vector<Index> pushing_;
  SlopeMatrix velocity_, displacement_, impulse_;  ///< at the end of the step
  SlopeMatrix start_, depth_, impulse_given_, moved_;
  std::vector<PushExpansion::Contact> expanded_;
  flow::PushSeries series_;
  std::unique_ptr<PushExpansion> expansion_ = make_push_expansion();
};

}  // namespace mariotte::impact
