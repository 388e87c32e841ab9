// Triplets of which one contact pushes alone until it lets go, side by side; included as the series are. The
// formulas are those of HertzMotion.
#pragma once
#include <span>

#include "mariotte/flow/pair/hertz_time.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/flow/triplet/triplet.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// a^{2/5}: each correction of a rough root by e = r⁵/a² − 1 leaves the third power of e.
MARIOTTE_SERIES_INLINE Vec fifth_root_of_square(Vec a) {
  Vec r = rough_root(a, 2.5);
  for (int i = 0; i < 3; ++i) {
    const Vec square = r * r, e = square * square * r / (a * a) - 1;
    r = r * (1 - 0.2 * e + 0.12 * (e * e));
  }
  return r;
}

/// Contact c, which is closed, and the other one, b; the end of c at w∞ and 0.
struct PairEnd {
  Vec own, cross, depth, rate, other_depth, other_rate;

  Vec time, last_rate, last_other_depth, last_other_rate;

  MARIOTTE_SERIES_INLINE void find() {
    const Vec stored = 0.8 * own * depth * depth * root(depth), energy = rate * rate + stored;
    const Vec speed = root(energy), share = cross / own;
    time = duration(energy, speed, stored / energy);
    last_rate = -speed;
    last_other_rate = other_rate + share * (rate + speed);
    last_other_depth = other_depth + (other_rate + share * rate) * time + share * depth;
  }

 private:
  /// τ (T(1) − T(y)), by whichever form holds; τ δ/δ_m = (4/5) δ/w∞.
  MARIOTTE_SERIES_INLINE Vec duration(Vec energy, Vec speed, Vec z) const {
    const Vec y = -rate / speed, late = depth / speed * from_end(least(z, splat(0.5)));
    const Mask is_late = (z <= 0.5) & (y > Vec{});
    if (all_of(is_late)) return late;
    const Vec tau = 0.8 * fifth_root_of_square(energy / (0.8 * own)) / speed;
    const Vec between = tau * (full_hertz_time - y * from_middle(least(y * y, splat(0.5)))),
              early = 2 * full_hertz_time * tau - late;
    return is_late ? late : z <= 0.5 ? early : between;
  }
};

/// Of at most `width` triplets.
inline void end_pairs(std::span<Triplet* const> triplets) {
  PairEnd end;
  for (int lane = 0; lane < width; ++lane) {
    const auto& t = *triplets[lane < std::ssize(triplets) ? lane : 0];
    const int c = t.closed[1], b = 1 - c;
    end.own[lane] = t.own[c];
    end.cross[lane] = t.cross[b];
    end.depth[lane] = t.indentation[c];
    end.rate[lane] = t.rate[c];
    end.other_depth[lane] = t.indentation[b];
    end.other_rate[lane] = t.rate[b];
  }
  end.find();
  for (int lane = 0; lane < std::ssize(triplets); ++lane)
    end_pair(*triplets[lane], end.time[lane], {0, end.last_rate[lane]},
             {end.last_other_depth[lane], end.last_other_rate[lane]});
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
