// The cheapest flow that a phase admits.
#pragma once
#include <array>
#include <memory>
#include <optional>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/kind.hpp"

namespace mariotte::flow {

/// A flow for the present phase, and its kind.
struct Choice {
  Kind kind;
  Flow& flow;
};

/// The flows of one run after the other, each made when first needed and kept as long as it fits.
class Flows {
 public:
  /// Free flight is followed in closed form whatever was asked; contact phases by the flow asked for if they
  /// admit it or, left to itself, by the cheapest that does: the closed form of a pair, natural modes where
  /// they cost less than series, series unless damping makes the phase too stiff for them, then CVODE.
  Choice choose(const Problem& problem, std::optional<Kind> requested);
  /// What follows the rest of a phase that `kind` has given up, if that was its own choice: BDF what was too
  /// stiff for it, and else another general flow. Empty if none is left.
  std::optional<Choice> instead_of(Kind kind, bool stiff, const Problem& problem,
                                   std::optional<Kind> requested);
  Flow& get(Kind kind, const Problem& problem);

 private:
  std::array<std::unique_ptr<Flow>, kinds.size()> flows_;
};

}  // namespace mariotte::flow
