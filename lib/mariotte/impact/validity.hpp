// Whether the model of a run holds: how far it came towards the limits of what its laws describe. Formulas
// and sources: theory page, "Where the laws end".
#pragma once
#include <array>
#include <limits>
#include <optional>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {

/// What is known of two bodies that touch, beside their law; 0 for what is not.
struct Touching {
  double radius = 0;          ///< R [m], 1/R = 1/R₁ + 1/R₂
  double smaller_radius = 0;  ///< of the two [m]
  double yield_strength = 0;  ///< Y of the one that yields first [Pa]
  double wave_travel = 0;     ///< of a wave through the slower of the two and back [s]
  double mass = 0;            ///< reduced, of the two alone [kg]

  friend bool operator==(const Touching&, const Touching&) = default;
};

/// A number at its worst, and the contact or tip of which it is, from 0.
struct Extreme {
  double value;
  Index contact;
};

/// Empty where the scene does not say enough.
struct Validity {
  using Number = std::optional<Extreme>;

  Number indentation_ratio;     ///< largest δ over the smaller radius
  Number contact_radius_ratio;  ///< largest a/R = √(δ/R)
  Number peak_pressure;         ///< largest p₀ of a Hertz contact [Pa]
  Number yield_ratio;           ///< largest p₀ over that of first yield, 1.60 Y
  Number first_yield_speed;     ///< least speed at which two bodies alone begin to yield [m/s]
  Number contact_time_ratio;    ///< least contact time over that of a wave through a body and back
  Number table_ratio;           ///< largest δ over that of the last point of a tabulated law
  Number adhesion_ratio;        ///< largest 2πf₀/K over the radius of the tip
  Number hertz_damping;         ///< largest C_H |ṅ|
  Number adhesion_damping;      ///< largest C_A |ṅ|
  Number tabor_number;          ///< least
  Number well_damping;          ///< largest ζ in the well of adhesion
};

/// What a number of the validity is told of.
enum class ToldOf { all, contacts, tips };

/// Up to where a number of the validity is fine; NaN where there is no limit.
struct ValidityLimit {
  const char* key;  ///< in results
  const char* unit;
  const char* symbol;
  const char* meaning;
  Validity::Number Validity::*number;
  double limit = std::numeric_limits<double>::quiet_NaN();
  bool from_below = true;      ///< numbers above the limit are bad; else those below
  const char* otherwise = "";  ///< what a bad number means
  ToldOf of = ToldOf::all;     ///< tips are those of microbodies
};

inline constexpr std::array validity_limits = {
    ValidityLimit{.key = "validity.indentation_ratio",
                  .unit = "1",
                  .symbol = "max δ/R",
                  .meaning = "largest indentation over the smaller radius; above 1 the ending is `invalid`",
                  .number = &Validity::indentation_ratio},
    ValidityLimit{.key = "validity.contact_radius_ratio",
                  .unit = "1",
                  .symbol = "max a/R",
                  .meaning = "largest contact radius over radius of curvature; strains are small below 0.1",
                  .number = &Validity::contact_radius_ratio,
                  .limit = 0.1,
                  .otherwise = "strains are too large for laws of small strains, as Hertz's"},
    ValidityLimit{.key = "validity.peak_pressure",
                  .unit = "Pa",
                  .symbol = "max p₀",
                  .meaning = "largest pressure in the middle of a Hertz contact",
                  .number = &Validity::peak_pressure},
    ValidityLimit{.key = "validity.yield_ratio",
                  .unit = "1",
                  .symbol = "max p₀/1.6Y",
                  .meaning = "this pressure over that at which the material first yields",
                  .number = &Validity::yield_ratio,
                  .limit = 1,
                  .otherwise = "the material yields, which the law leaves out, so the rebound is too fast"},
    ValidityLimit{.key = "validity.first_yield_speed",
                  .unit = "m/s",
                  .symbol = "min v_Y",
                  .meaning = "least speed at which two of the bodies alone begin to yield",
                  .number = &Validity::first_yield_speed},
    ValidityLimit{
        .key = "validity.contact_time_ratio",
        .unit = "1",
        .symbol = "min t_c/t_w",
        .meaning = "least contact time over that of a wave through the body and back",
        .number = &Validity::contact_time_ratio,
        .limit = 5,
        .from_below = false,
        .otherwise = "waves have no time to cross the bodies often, so laws of slow contacts are not exact"},
    ValidityLimit{.key = "validity.table_ratio",
                  .unit = "1",
                  .symbol = "max δ/δ_last",
                  .meaning = "largest indentation over the last of a tabulated law",
                  .number = &Validity::table_ratio,
                  .limit = 1,
                  .otherwise = "the table has ended, and the force goes on straight",
                  .of = ToldOf::contacts},
    ValidityLimit{.key = "validity.adhesion_ratio",
                  .unit = "1",
                  .symbol = "2πf₀/Kr",
                  .meaning = "length of adhesion over the radius of the tip",
                  .number = &Validity::adhesion_ratio,
                  .limit = 0.01,
                  .otherwise = "adhesion alone strains the tip too much for the law",
                  .of = ToldOf::tips},
    ValidityLimit{.key = "validity.hertz_damping",
                  .unit = "1",
                  .symbol = "max C_H |ṅ|",
                  .meaning = "Hertz damping over the Hertz force, at the largest normal speed",
                  .number = &Validity::hertz_damping,
                  .limit = 1,
                  .otherwise = "damping exceeds the force that it corrects",
                  .of = ToldOf::tips},
    ValidityLimit{.key = "validity.adhesion_damping",
                  .unit = "1",
                  .symbol = "max C_A |ṅ|",
                  .meaning = "adhesion damping over adhesion, at the largest normal speed",
                  .number = &Validity::adhesion_damping,
                  .limit = 1,
                  .otherwise = "adhesion pushes while the tip approaches",
                  .of = ToldOf::tips},
    ValidityLimit{.key = "validity.tabor_number",
                  .unit = "1",
                  .symbol = "min μ",
                  .meaning = "how far adhesion deforms a contact over how far it reaches, 0.4 nm",
                  .number = &Validity::tabor_number,
                  .limit = 1,
                  .from_below = false,
                  .otherwise = "adhesion reaches beyond the edge of the contact, where the law puts it"},
    ValidityLimit{.key = "validity.well_damping",
                  .unit = "1",
                  .symbol = "ζ",
                  .meaning = "damping ratio of small oscillations in the well of adhesion",
                  .number = &Validity::well_damping,
                  .limit = 1,
                  .otherwise = "a captured tip creeps to rest instead of oscillating",
                  .of = ToldOf::tips},
};

/// Whether a number is beyond its limit.
inline bool is_beyond(const ValidityLimit& one, const Validity& validity) {
  const auto& number = validity.*one.number;
  return number && (one.from_below ? number->value > one.limit : number->value < one.limit);
}

}  // namespace mariotte::impact
