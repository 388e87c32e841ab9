// Slopes of velocities and displacements as power series in the clock of a step, up to sixteen parameters at
// a time. Compiled once per instruction set.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "mariotte/contact/power_law.hpp"
#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/push_series.hpp"
#include "mariotte/impact/sensitivity/contact_slope.hpp"
#include "mariotte/impact/sensitivity/slope_matrix.hpp"

namespace mariotte::impact {

/// Keeps its memory from step to step.
class PushExpansion {
 public:
  virtual ~PushExpansion() = default;

  /// What the push of a contact gives a velocity, or a velocity to the gap.
  struct Term {
    Index velocity;
    double coefficient;
  };
  /// A contact of the series, in its order. `depth` are the slopes of δ at the start.
  struct Contact {
    contact::PowerLaw law;
    std::span<const Term> push, direction;
    const ContactSlope* slope;
    std::span<const double> depth;
  };
  /// What a step starts from; `number` is that of a velocity by its place.
  struct Start {
    std::span<const Contact> contacts;
    const SlopeMatrix& velocity;
    const SlopeMatrix& acceleration;
    std::span<const Index> number;
  };
  /// Slopes at the end: by velocity its own and that of ∫ v dt, and by contact that of its impulse.
  struct End {
    SlopeMatrix &velocity, &displacement, &impulse;
  };

  /// Linear and Hertz contacts, damped or not, and slopes by all numbers but directions; by exponents only of
  /// damped Hertz contacts.
  static bool knows(const contact::PowerLaw& law, const ContactSlope& slope);
  /// What the last terms of a column may be: `tolerance` of its velocities or of its natural size.
  struct Bound {
    double tolerance;
    std::span<const double> natural;
  };
  /// How far along its clock the series reaches before last terms are too large; slopes are those there. 0 if
  /// that is nowhere.
  virtual double expand(const flow::PushSeries& series, const Start& start, const Bound& bound, End end) = 0;
};

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<PushExpansion>, make_push_expansion, (), ())

}  // namespace mariotte::impact
