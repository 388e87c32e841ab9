// Contacts side by side, one lane each, and their Taylor expansion.
#pragma once
#include <array>
#include <memory>

#include "mariotte/core/cubic_curve.hpp"
#include "mariotte/core/width_branch.hpp"
#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/taylor/lane_table.hpp"

namespace mariotte::flow::taylor {

inline constexpr int order_limit = 20;
/// Of one quantity, by order.
using Coefficients = std::array<double, order_limit + 1>;
/// An expansion of rows is compiled for each of these numbers of lanes.
inline constexpr std::array lane_sizes = {4, 8, 12, 16, 32};
/// Longer rows are expanded in blocks, as networks are.
inline constexpr int most_row_limit = lane_sizes.back();
/// Of x86 processors without AVX2, which are old: fewer sizes take less time to compile.
#ifdef __x86_64__
inline constexpr int baseline_row_limit = 8;
#else
inline constexpr int baseline_row_limit = most_row_limit;
#endif
consteval std::size_t sizes_up_to(int limit) {
  std::size_t count = 0;
  for (const int size : lane_sizes) count += size <= limit;
  return count;
}

/// The rows of a Coupling, by lane.
struct Links {
  const int* first = nullptr;
  const int* lane = nullptr;
  const double* weight = nullptr;
};

/// What a series starts from; lanes from `count` on are idle. In a row, lane j is the contact between bodies
/// j and j+1. Plain pointers: code compiled for different instruction sets shares nothing but this layout.
class Lanes {
  LaneTable table_;

 public:
  Lanes();
  Lanes(Lanes&&) = default;
  /// Lanes that are not among the first `lanes` become idle: all their numbers are zero.
  void resize(int lanes);

  int count = 0;
  bool damped = false;     ///< some damping is not zero
  bool mixed = false;      ///< some load is not k δ + c δ̇
  bool general = false;    ///< some power p is neither 0 nor 1/2
  bool branched = false;   ///< some yield or turn is watched
  bool linked = false;     ///< `links` says what lanes do to each other; else they are a row
  bool widened = false;    ///< the forces are those of `branch`, not powers
  bool segmented = false;  ///< the forces are those of `segment`, not powers
  Links links;
  const double* bend = nullptr;                ///< more of δ̈ than `drive`, if any: by order, of all lanes
  const WidthBranch* const* branch = nullptr;  ///< of each lane, if widened; null of one without force
  const CubicSegment* const* segment = nullptr;  ///< of each lane, if segmented; null of one without force
  double* indentation;                           ///< δ; negative where open
  double* rate;                                  ///< δ̇
  double* width;                                 ///< u of its branch
  double* active;                                ///< 1 where the contact carries force, else 0
  double* acts_above;   ///< δ from which it does; infinite for one that does not push
  double* late_above;   ///< δ to which it may sink before it is heard
  double* rooted;       ///< 1 where a closed contact has a branch point at δ = 0, else 0
  double* stiffness;    ///< k
  double* steepening;   ///< l
  double* damping;      ///< c
  double* stiffening;   ///< h; where a load is watched, there is no c beside it
  double* ring;         ///< a
  double* power;        ///< p of the force δᵖ ((k + l δᵖ) δ + (c + h δ) δ̇ − a)
  double* left;         ///< 1/m of body j; if linked, 1/m* of the contact
  double* right;        ///< 1/m of body j+1; if linked, 0
  double* drive;        ///< δ̈ from outside forces
  double* side;         ///< sign that δ is to keep, 0 where nobody watches
  double* level;        ///< depth to which an open contact may reach
  double* leeway;       ///< more of it within a step that leaves its force out
  double* load_side;    ///< sign that the load is to keep, or 0
  double* yield_side;   ///< 1 where δ is watched for a yield, else 0
  double* yield_level;  ///< there: δ where it yields
  double* turn_side;    ///< sign that δ̇ is to keep but for the level, or 0
  double* turn_level;
  double* fades_below;   ///< less deep, and slow, a closed contact has let go; or −infinite
  double* leaves_noise;  ///< deeper, or so far apart, one that touches is watched; or infinite
  double* weight;        ///< 1/natural length

  /// A contact with leeway does not count how far beyond its level it is within that, until a step ends
  /// there. Dampers and branches allow none.
  bool has_leeway() const { return !damped && !branched; }
};

/// What an expansion gives at one place of its clock.
class Values {
  LaneTable table_;

 public:
  Values();
  void resize(int lanes);

  double* indentation;
  double* impulse;  ///< ∫ f dt
  double* work;     ///< ∫ f δ̇ dt, if damped
  double* width;    ///< u, if widened
  /// Lower bounds, from the start to that place, of side × δ + level and of load_side × load, if damped;
  /// divided by the place for what starts at zero. Negative where a guard may have fired.
  double* margin;
  double* load_margin;
  double* branch_margin;  ///< likewise of yields and turns, if branched: the lower of the two
  double time;            ///< since the start of the series
  bool may_fall;          ///< some margin is negative, or a contact with leeway is beyond its level
  bool is_deep;           ///< some contact that is left out may be too deep for that
  bool may_change;        ///< some contact may have faded or left the noise
};

/// What is evaluated of a contact, δ, δ̇, what has the sign of its force, δᵖ and ∫ f dt, and of the clock.
enum class Quantity { indentation, rate, load, root, impulse, clock, time };

/// What contacts are about to do.
struct Outlook {
  bool may_land;   ///< one with a branch point is near it
  bool is_sudden;  ///< one has hardly begun
};

/// Series of all lanes in a clock σ. Plain: t = σ. Of a lane c: dt = √δ_c dσ, in which onset (δ_c = 0,
/// δ̇_c > 0) and separation of c are ordinary points; for windows without general exponents. If widened:
/// dt = (dδ/du) dσ, in which the end of c is one.
class Expansion {
 public:
  static constexpr int plain = -1;
  virtual ~Expansion() = default;
  /// Tell which contacts carry force. Near are those that are less than the time `near` before their end, at
  /// their onset, or, with `onsets`, less than that after it.
  virtual Outlook activate(Lanes& lanes, double near, bool onsets) const = 0;
  virtual void expand(const Lanes& lanes, int order, int clock) = 0;
  /// Largest coefficient k of δ/length, δ̇ and, if damped, work/m* and loads that are watched for their rise,
  /// as rates, for k from `first` to the order.
  virtual void sizes(int first, double* size) const = 0;
  virtual void evaluate(double place, Values& values) const = 0;
  /// Replace negative margins of indentations by those of a longer Bernstein form, where that is positive.
  virtual void sharpen(double place, Values& values) const = 0;
  /// Coefficients of one quantity of a lane, or of the clock √δ_c and the time.
  virtual void coefficients(Quantity quantity, int lane, double* c) const = 0;
};

/// Lanes that are linked, driven, or whose forces are no powers are expanded in blocks, as long rows are.
inline bool is_in_blocks(const Lanes& lanes) {
  return lanes.linked || lanes.bend || lanes.widened || lanes.segmented;
}

/// The number in lane_sizes that has room for a row of `lanes`; lane_sizes.size() for those in blocks and for
/// longer rows.
std::size_t size_for(const Lanes& lanes);

/// For lane_sizes[size] lanes of a row, up to the row limit, or for any number of linked lanes, with the
/// widest vectors that this machine has.
MARIOTTE_PER_WIDE_INSTRUCTION_SET(std::unique_ptr<Expansion>, make_expansion, (std::size_t size), (size))

}  // namespace mariotte::flow::taylor
