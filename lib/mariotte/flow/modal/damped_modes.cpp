#include "mariotte/flow/modal/damped_modes.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

using Complex = std::complex<double>;

constexpr int most_root_sweeps = 100;  ///< ten are usual

/// Dynamic stiffness k + c λ of a contact.
Complex stiffness(const DampedRow& row, Index contact, const Root& root) {
  const double k = row.stiffness[contact], c = row.damping[contact];
  return c > 0 ? c * ((root.origin + k / c) + root.offset) : Complex(k);
}

/// Value and derivative by λ.
struct Jet {
  Complex value, slope;
  friend Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend Jet operator*(double a, const Jet& b) { return {a * b.value, a * b.slope}; }
};

/// p/p' of the characteristic polynomial: the stiffness seen from the right end, as a fraction, gains a
/// contact in series and a body in turn. A free left end carries a factor λ², left out.
Complex newton_step(const DampedRow& row, const Root& root) {
  const Complex value = root.value();
  const Jet one{1, 0}, square{value * value, 2.0 * value};
  const bool fixed = row.inverse_mass.front() == 0;
  const Jet &above = fixed ? one : square, &below = fixed ? square : one;
  Jet numerator = one, denominator{row.inverse_mass.front(), 0};
  for (Index j = 0; j < row.contacts(); ++j) {
    const Jet spring{stiffness(row, j, root), row.damping[j]};
    denominator = above * numerator + spring * denominator;
    const double w = row.inverse_mass[j + 1];
    if (w == 0) return denominator.value / denominator.slope;
    numerator = w * (numerator * spring) + below * denominator;
    denominator = w * denominator;
    const double scale = 1 / (std::abs(numerator.value) + std::abs(denominator.value));
    numerator = scale * numerator;
    denominator = scale * denominator;
  }
  return numerator.value / numerator.slope;
}

/// Both roots of λ² + (c λ + k)/m; the slow one of an overdamped contact relative to −k/c.
void add_guesses(std::vector<Root>& roots, double k, double c, double inverse_mass) {
  const double half = 0.5 * c * inverse_mass, square = k * inverse_mass;
  // Off the axis, and no two alike, else they could never part.
  const double count = static_cast<double>(roots.size());
  const Complex spread = std::polar(1 + 0.02 * count, 0.3 + 0.1 * count);
  if (half * half < square) {
    const double split = std::sqrt(square - half * half);
    roots.push_back({0, Complex(-half, split) * spread});
    roots.push_back({0, Complex(-half, -split) * std::conj(spread)});
    return;
  }
  const double fast = half + std::sqrt(half * half - square), slow = square / fast;
  roots.push_back({0, -fast * spread});
  if (slow < 0.1 * fast)
    roots.push_back({-k / c, -slow * slow / (c * inverse_mass) * std::conj(spread)});
  else
    roots.push_back({0, -slow * std::conj(spread)});
}

/// As if every contact, or between walls every body, moved alone.
void guess(std::vector<Root>& roots, const DampedRow& row) {
  roots.clear();
  const auto& w = row.inverse_mass;
  if (!row.between_walls()) {
    for (Index j = 0; j < row.contacts(); ++j)
      add_guesses(roots, row.stiffness[j], row.damping[j], w[j] + w[j + 1]);
    return;
  }
  for (Index j = 0; j + 1 < row.contacts(); ++j)
    add_guesses(roots, row.stiffness[j] + row.stiffness[j + 1], row.damping[j] + row.damping[j + 1],
                w[j + 1]);
}

Complex difference(const Root& a, const Root& b) {
  return (a.origin - b.origin) + (a.offset - b.offset);
}

/// True once the step is rounding noise: tiny, or small and no longer shrinking.
bool refine(std::vector<Root>& roots, const DampedRow& row, std::size_t i, Complex& last) {
  auto& root = roots[i];
  const Complex newton = newton_step(row, root);
  Complex push = 0;
  for (std::size_t k = 0; k < roots.size(); ++k)
    if (k != i) push += 1.0 / difference(root, roots[k]);
  const Complex step = newton / (1.0 - newton * push);
  const double size = std::abs(step), before = std::abs(last), scale = std::abs(root.offset);
  root.offset -= step;
  last = step;
  return size <= 4 * epsilon * scale || (size <= 1e-11 * scale && size >= 0.5 * before);
}

bool refine_all(std::vector<Root>& roots, const DampedRow& row, std::vector<Complex>& step) {
  step.assign(roots.size(), infinity);
  for (int sweep = 0; sweep < most_root_sweeps; ++sweep) {
    bool settled = true;
    for (std::size_t i = 0; i < roots.size(); ++i) settled = refine(roots, row, i, step[i]) && settled;
    if (settled) return true;
  }
  return false;
}

/// Each root relative to the place −k/c that it is close to, or to 0: which guess led where is chance.
void settle_origins(std::vector<Root>& roots, const DampedRow& row) {
  for (auto& root : roots) {
    const Complex value = root.value();
    Root nearest{0, value};
    for (Index j = 0; j < row.contacts(); ++j) {
      if (row.damping[j] == 0) continue;
      const double place = -row.stiffness[j] / row.damping[j];
      const Complex offset = (root.origin - place) + root.offset;
      if (std::abs(offset) < 0.1 * std::abs(nearest.offset)) nearest = {place, offset};
    }
    root = nearest;
  }
}

/// Within n |p/p'| of any place there is a root; so if these discs are apart, each holds one, and none is
/// missed.
bool are_apart(const std::vector<Root>& roots, const DampedRow& row, std::vector<Complex>& radius) {
  for (std::size_t i = 0; i < roots.size(); ++i)
    radius[i] = static_cast<double>(roots.size()) * std::abs(newton_step(row, roots[i]));
  for (std::size_t i = 0; i < roots.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!(std::abs(difference(roots[i], roots[k])) > radius[i].real() + radius[k].real())) return false;
  return true;
}

/// Keeps one root of each conjugate pair, and puts real ones on the axis; false if they do not match up.
bool sort_out(std::vector<Root>& roots) {
  const auto is_real = [](const Root& r) { return std::abs(r.offset.imag()) <= 1e-6 * std::abs(r.offset); };
  std::size_t above = 0, below = 0;
  for (auto& root : roots) {
    if (is_real(root))
      root.offset.imag(0);
    else
      ++(root.offset.imag() > 0 ? above : below);
  }
  if (above != below || (roots.size() - above - below) % 2 != 0) return false;
  std::erase_if(roots, [](const Root& root) { return root.offset.imag() < 0; });
  const auto rank = [](const Root& r) { return std::pair(r.offset.imag() == 0, -r.value().real()); };
  std::sort(roots.begin(), roots.end(), [&](const Root& a, const Root& b) { return rank(a) < rank(b); });
  return true;
}

/// Compliances of all that is left of contact j, its left body included, and of all that is right of it.
void find_compliances(DampedModes& modes, const DampedRow& row, const Root& root) {
  const Index n = row.contacts();
  const Complex square = root.value() * root.value();
  const auto behind = [&](Index contact, Complex compliance, double w) {
    const Complex spring = stiffness(row, contact, root);
    return w / (square + w * spring / (1.0 + spring * compliance));
  };
  modes.left.resize(n);
  modes.right.resize(n);
  modes.left[0] = row.inverse_mass[0] / square;
  modes.right[n - 1] = row.inverse_mass[n] / square;
  for (Index j = 0; j + 1 < n; ++j) modes.left[j + 1] = behind(j, modes.left[j], row.inverse_mass[j + 1]);
  for (Index j = n - 1; j > 0; --j) modes.right[j - 1] = behind(j, modes.right[j], row.inverse_mass[j]);
}

/// Spreads from the contact that determines the others best: force 1 there, then outwards.
void find_shape(DampedModes& modes, const DampedRow& row, Index mode) {
  const Index n = row.contacts();
  const auto& root = modes.root[mode];
  find_compliances(modes, row, root);
  const auto misfit = [&](Index j) {
    return std::abs(1.0 / stiffness(row, j, root) + modes.left[j] + modes.right[j]);
  };
  Index pivot = 0;
  for (Index j = 1; j < n; ++j)
    if (misfit(j) < misfit(pivot)) pivot = j;
  Complex* depth = &modes.depth[mode * n];
  Complex* force = &modes.force[mode * n];
  force[pivot] = 1;
  depth[pivot] = -(modes.left[pivot] + modes.right[pivot]);
  const auto spread = [&](Index from, Index j, const std::vector<Complex>& side) {
    const Complex spring = stiffness(row, j, root);
    depth[j] = side[from] * force[from] / (1.0 + spring * side[j]);
    force[j] = spring * depth[j];
  };
  for (Index j = pivot; j-- > 0;) spread(j + 1, j, modes.left);
  for (Index j = pivot + 1; j < n; ++j) spread(j - 1, j, modes.right);
}

/// |y|²/|y·y| in energies, stored and kinetic; infinite if numbers have overflowed.
double measure(DampedModes& modes, const DampedRow& row, Index mode) {
  const Index n = row.contacts();
  const Complex value = modes.root[mode].value();
  const Complex* depth = &modes.depth[mode * n];
  const Complex* force = &modes.force[mode * n];
  Complex product = 0;
  double stored = 0, kinetic = 0;
  for (Index j = 0; j < n; ++j) {
    product += (2 * row.stiffness[j] + value * row.damping[j]) * depth[j] * depth[j];
    stored += row.stiffness[j] * std::norm(depth[j]);
  }
  for (Index i = 0; i <= n; ++i) {
    const Complex push = (i > 0 ? force[i - 1] : 0) - (i < n ? force[i] : 0);
    kinetic += row.inverse_mass[i] * std::norm(push / value);
  }
  modes.size[mode] = value * product;
  const double ratio = (stored + kinetic) / std::abs(product);
  return std::isfinite(ratio) ? ratio : infinity;
}

}  // namespace

Complex DampedModes::amplitude(const DampedRow& row, Index mode, std::span<const double> start,
                               std::span<const double> rate) const {
  const Index n = row.contacts();
  const Complex value = root[mode].value();
  Complex sum = 0;
  for (Index j = 0; j < n; ++j)
    sum += value * row.stiffness[j] * start[j] * depth[mode * n + j] + rate[j] * force[mode * n + j];
  return sum / size[mode];
}

bool find(DampedModes& modes, const DampedRow& row) {
  guess(modes.root, row);
  modes.condition = 1;
  if (!refine_all(modes.root, row, modes.step)) return false;
  settle_origins(modes.root, row);
  if (!refine_all(modes.root, row, modes.step)) return false;
  if (!are_apart(modes.root, row, modes.step) || !sort_out(modes.root)) return false;
  const auto count = modes.root.size(), entries = count * row.stiffness.size();
  modes.depth.resize(entries);
  modes.force.resize(entries);
  modes.size.resize(count);
  for (Index i = 0; i < static_cast<Index>(count); ++i) {
    find_shape(modes, row, i);
    modes.condition = std::max(modes.condition, measure(modes, row, i));
  }
  return true;
}

}  // namespace mariotte::flow
