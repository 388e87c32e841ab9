// Neighbouring contacts of a chain side by side, one lane each, and their Taylor expansion.
#pragma once
#include <array>
#include <memory>

namespace mariotte::flow::taylor {

inline constexpr int order_limit = 20;
/// An expansion is compiled for each of these numbers of lanes.
inline constexpr std::array lane_sizes = {4, 8, 12, 16, 32, 64};
inline constexpr int lane_limit = lane_sizes.back();

/// What a series starts from. Lane j is the contact between bodies j and j+1; lanes from `count` on are idle.
/// Plain arrays: code compiled for different instruction sets shares nothing but this layout.
struct Lanes {
  int count = 0;
  bool damped = false;                              ///< some damping is not zero
  bool general = false;                             ///< some exponent is neither 1 nor 3/2
  alignas(64) double indentation[lane_limit] = {};  ///< δ; negative where open
  alignas(64) double rate[lane_limit] = {};         ///< δ̇
  alignas(64) double active[lane_limit] = {};       ///< 1 where the contact carries force, else 0
  alignas(64) double stiffness[lane_limit] = {};    ///< k
  alignas(64) double damping[lane_limit] = {};      ///< c
  alignas(64) double power[lane_limit] = {};        ///< p = n − 1 of the force δᵖ (k δ + c δ̇)
  alignas(64) double left[lane_limit] = {};         ///< 1/m of body j
  alignas(64) double right[lane_limit] = {};        ///< 1/m of body j+1
  alignas(64) double drive[lane_limit] = {};        ///< δ̈ from outside forces
  alignas(64) double side[lane_limit] = {};         ///< sign that δ is to keep, 0 where nobody watches
  alignas(64) double level[lane_limit] = {};        ///< depth to which an open contact may reach
  alignas(64) double load_side[lane_limit] = {};    ///< sign that the load k δ + c δ̇ is to keep, or 0
  alignas(64) double weight[lane_limit] = {};       ///< 1/natural length
};

/// What an expansion gives at one place of its clock.
struct Values {
  alignas(64) double indentation[lane_limit];
  alignas(64) double impulse[lane_limit];  ///< ∫ f dt
  alignas(64) double work[lane_limit];     ///< ∫ f δ̇ dt, if damped
  /// Lower bounds, from the start to that place, of side × δ + level and of load_side × load, if damped;
  /// divided by the place for what starts at zero. Negative where a guard may have fired.
  alignas(64) double margin[lane_limit];
  alignas(64) double load_margin[lane_limit];
  double time;  ///< since the start of the series
};

/// What is evaluated of a contact, δ, δ̇, k δ + c δ̇ and δᵖ, and of the clock.
enum class Quantity { indentation, rate, load, root, clock, time };

/// Series of all lanes in a clock σ. Plain: t = σ. Of a lane c: dt = √δ_c dσ, in which onset (δ_c = 0,
/// δ̇_c > 0) and separation of c are ordinary points; for windows without general exponents.
class Expansion {
 public:
  static constexpr int plain = -1;
  virtual ~Expansion() = default;
  virtual void expand(const Lanes& lanes, int order, int clock) = 0;
  /// Largest coefficient k of δ/length, δ̇ and, if damped, work/m*, for k from `first` to the order.
  virtual void sizes(int first, double* size) const = 0;
  virtual void evaluate(double place, Values& values) const = 0;
  /// Replace margins of indentations by those of a longer Bernstein form, where that is positive.
  virtual void sharpen(double place, Values& values) const = 0;
  /// Coefficients of one quantity of a lane, or of the clock √δ_c and the time.
  virtual void coefficients(Quantity quantity, int lane, double* c) const = 0;
};

/// For lane_sizes[size] lanes, with the widest vectors that this machine has.
std::unique_ptr<Expansion> make_expansion(std::size_t size);

/// For processors with AVX2 and FMA.
std::unique_ptr<Expansion> make_avx2_expansion(std::size_t size);
/// For any processor.
std::unique_ptr<Expansion> make_baseline_expansion(std::size_t size);

}  // namespace mariotte::flow::taylor
