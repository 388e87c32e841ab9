#include "mariotte/impact/sensitivity/collocation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "mariotte/impact/sensitivity/gauss.hpp"
#include "mariotte/impact/sensitivity/stage_system.hpp"

namespace mariotte::impact {
namespace {

constexpr int most_halvings = 10;
constexpr int most_halvings_at_root = 5;  ///< nearer to it the indentation is rounding
constexpr Index largest_division = 480;   ///< beyond it sweeps cost less than a division
constexpr Index cheapest_division = 120;  ///< up to it a division costs less than sweeps
constexpr int most_sweeps = 60;
constexpr double weak = 3;       ///< of what a piece does: a few sweeps cost less than a division
constexpr double stiff = 10;     ///< what has not died away is then left in all orders alike
constexpr double reserve = 100;  ///< of the accuracy: what such a piece may leave
constexpr double clearly = 4;    ///< too large, though slopes may grow within a piece

/// By rows, since what a component does, it does to all columns.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Time as a fraction of a step, and its rate, where the clock stands at u.
struct Moment {
  double past, left, rate;
};

/// Towards an end a root of the time until the force has its own falls evenly, from 1 + beyond.
Moment towards_end(double beyond, double u) {
  const double first = std::sqrt(1 + beyond), last = std::sqrt(beyond), fall = 1 / (first + last);
  const double root = first - fall * u;
  return {fall * u * (first + root), fall * (1 - u) * (root + last), 2 * root * fall};
}

/// (a⁴ − b⁴)/(a − b).
double fourth_powers(double a, double b) {
  return (a + b) * (a * a + b * b);
}
/// The same with the fourth root.
Moment towards_steep_end(double beyond, double u) {
  const double first = std::sqrt(std::sqrt(1 + beyond)), last = std::sqrt(std::sqrt(beyond));
  const double fall = 1 / fourth_powers(first, last), root = first - fall * u;
  return {fall * u * fourth_powers(first, root), fall * (1 - u) * fourth_powers(root, last),
          4 * root * root * root * fall};
}

Moment moment(Edges edges, double u) {
  Moment now{u, 1 - u, 1};
  if (edges.beyond < infinity) {
    const double beyond = edges.begins ? std::expm1(0.25 * std::log1p(edges.beyond)) : edges.beyond;
    now = edges.is_steep ? towards_steep_end(beyond, u) : towards_end(beyond, u);
  }
  if (!edges.begins) return now;
  const double x = now.past, square = x * x;
  return {square * square, now.left * (1 + x) * (1 + square), 4 * x * square * now.rate};
}

}  // namespace

struct Collocation::Memory {
  std::vector<flow::Entry> pattern;
  std::vector<std::size_t> entries;   ///< places in the pattern of rows that are needed
  Eigen::VectorXd magnitude, weight;  ///< weight: the inverse, of components that tell how large columns are
  Eigen::RowVectorXd natural;
  Rows given;                 ///< to a component, at all points
  Eigen::RowVectorXd extent;  ///< of columns in a piece
  double accuracy;
  Index size, columns;
  std::vector<Index> active;    ///< components that rates depend on
  std::vector<Index> position;  ///< of a component among them, or −1
  std::vector<double> jacobian[stages];
  SlopeMatrix source[stages];
  double rate[stages];
  double rounded = 0;  ///< relative error of A and B
  std::optional<StageSystem> equations;
  Rows right, value, now;
  Rows coefficient[tail_length];
  Rows slope[stages];
  double highest = 0;  ///< coefficients of the last piece
  double unresolved = 0;

  void find_entries(const std::vector<Index>& unneeded) {
    for (std::size_t e = 0; e < pattern.size(); ++e)
      if (std::find(unneeded.begin(), unneeded.end(), pattern[e].row) == unneeded.end()) entries.push_back(e);
  }

  void find_active() {
    position.assign(size, -1);
    for (const auto& entry : pattern) position[entry.column] = 0;
    for (Index i = 0; i < size; ++i)
      if (position[i] == 0) {
        position[i] = std::ssize(active);
        active.push_back(i);
      }
  }

  /// A and B at the points of the piece from u to u + width.
  void read(LinearField& field, double start, double end, Edges edges, double u, double width) {
    for (int i = 0; i < stages; ++i) {
      const auto now_at = moment(edges, u + width * gauss.point[i]);
      const double time =
          now_at.past < 0.5 ? start + (end - start) * now_at.past : end - (end - start) * now_at.left;
      const double magnified = field.at(time, (end - start) * now_at.left, jacobian[i], source[i]);
      rounded = std::max(i > 0 ? rounded : 0, 4 * stages * epsilon * magnified);
      rate[i] = width * (end - start) * now_at.rate;
    }
  }
  auto source_at(int i) const {
    return Eigen::Map<const Eigen::MatrixXd>(source[i].values.data(), size, columns);
  }
  /// Rates at point i, times the width of the piece, where the active components are `state`.
  template <class State>
  void set_slope(int i, const State& state) {
    slope[i] = source_at(i);
    for (const std::size_t e : entries)
      if (jacobian[i][e] != 0)
        slope[i].row(pattern[e].row) += jacobian[i][e] * state.row(position[pattern[e].column]);
    slope[i] *= rate[i];
  }

  /// Z = S + a (A Z + B) for the active components at all points.
  bool divide() {
    const Index m = std::ssize(active);
    value.resize(m * stages, columns);
    for (int i = 0; i < stages; ++i) value.middleRows(i * m, m) = now;
    const std::span<double> values{value.data(), static_cast<std::size_t>(value.size())};
    given.resize(stages, columns);
    for (Index k = 0; k < m; ++k) {
      for (int j = 0; j < stages; ++j) given.row(j) = rate[j] * source_at(j).row(active[k]);
      if (!given.isZero(0))
        equations->add_integral(k, {given.data(), static_cast<std::size_t>(given.size())}, values);
    }
    equations->solve(jacobian, rate, values);
    for (int i = 0; i < stages; ++i) set_slope(i, value.middleRows(i * m, m));
    return true;
  }

  /// How much a piece moves a component by all others, at most: sweeps come closer by a few times that.
  double strength() const {
    double most = 0;
    for (int i = 0; i < stages; ++i) {
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(size);
      for (const std::size_t e : entries)
        sum[pattern[e].row] += std::abs(jacobian[i][e]) * magnitude[pattern[e].column];
      for (const Index k : active) most = std::max(most, std::abs(rate[i]) * sum[k] / magnitude[k]);
    }
    return most;
  }

  /// The same by sweeps Z ← S + a (A Z + B), for many components and where these act weakly.
  bool sweep() {
    const Index m = std::ssize(active);
    value.resize(m * stages, columns);
    for (int i = 0; i < stages; ++i) value.middleRows(i * m, m) = now;
    double last = infinity;
    for (int n = 0; n < most_sweeps; ++n) {
      for (int i = 0; i < stages; ++i) set_slope(i, value.middleRows(i * m, m));
      const double change = sweep_once();
      if (!std::isfinite(change)) return false;
      if (change <= 4 * epsilon || (n > 8 && change >= last && change <= 1e-14)) return true;
      if (n > 8 && change > last) return false;
      last = change;
    }
    return false;
  }

  /// By how much that changes a column, relative to what it is.
  double sweep_once() {
    const Index m = std::ssize(active);
    Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(columns), largest = change;
    for (int i = 0; i < stages; ++i) {
      right = now;
      for (int j = 0; j < stages; ++j)
        for (Index k = 0; k < m; ++k) right.row(k) += gauss.integral[i][j] * slope[j].row(active[k]);
      for (Index k = 0; k < m; ++k) {
        const double unit = magnitude[active[k]];
        change = change.cwiseMax((right.row(k) - value.row(i * m + k)).cwiseAbs() / unit);
        largest = largest.cwiseMax(right.row(k).cwiseAbs() / unit);
      }
      value.middleRows(i * m, m) = right;
    }
    double most = 0;
    for (Index c = 0; c < columns; ++c)
      if (change[c] != 0) most = std::max(most, change[c] / largest[c]);
    return most;
  }

  bool solve() {
    const Index unknowns = equations->unknowns();
    if (unknowns > largest_division) return sweep();
    return (unknowns > cheapest_division && strength() <= weak && sweep()) || divide();
  }

  /// Highest coefficients of the interpolants of the rates, relative to the slopes of their column.
  Tail tail(const SlopeMatrix& slopes) {
    const Eigen::Map<const Eigen::MatrixXd> s(slopes.values.data(), size, columns);
    for (auto& part : coefficient) part.setZero(size, columns);
    const auto telling = weight.asDiagonal();
    extent = natural.cwiseMax((telling * s).cwiseAbs().colwise().maxCoeff());
    for (int i = 0; i < stages; ++i) {
      extent = extent.cwiseMax((telling * slope[i]).cwiseAbs().colwise().maxCoeff());
      for (int k = 0; k < tail_length; ++k) coefficient[k] += gauss.tail[k][i] * slope[i];
    }
    Tail most;
    const auto size_of = [&](int k, Index r, Index c) { return std::abs(coefficient[k](r, c)); };
    for (Index r = 0; r < size; ++r)
      for (Index c = 0; c < columns; ++c) {
        const double unit = magnitude[r] * extent[c];
        most.add((size_of(0, r, c) + size_of(1, r, c)) / unit, (size_of(2, r, c) + size_of(3, r, c)) / unit);
      }
    return most;
  }

  /// The highest coefficients as they would be if slopes stayed as they are: those of the Jacobian. A piece
  /// that is clearly too long by these need not be solved.
  double foreseen(const SlopeMatrix& slopes) {
    const Eigen::Map<const Eigen::MatrixXd> s(slopes.values.data(), size, columns);
    extent = (weight.asDiagonal() * s).cwiseAbs().colwise().maxCoeff().cwiseMax(natural);
    double most = 0;
    for (const std::size_t e : entries) {
      const double last = highest_of(e);
      if (last <= 0) continue;
      const double reach = s.row(pattern[e].column).cwiseAbs().cwiseQuotient(extent).maxCoeff();
      most = std::max(most, last * reach / magnitude[pattern[e].row]);
    }
    return most;
  }
  /// Of one entry, beyond what rounding leaves.
  double highest_of(std::size_t entry) const {
    double last = 0, largest = 0;
    for (int k = 2; k < tail_length; ++k) {
      double sum = 0;
      for (int i = 0; i < stages; ++i) sum += gauss.tail[k][i] * rate[i] * jacobian[i][entry];
      last += std::abs(sum);
    }
    for (int i = 0; i < stages; ++i) largest = std::max(largest, std::abs(rate[i] * jacobian[i][entry]));
    return last - rounded * largest;
  }

  /// What rounding leaves of the highest coefficients: rates are differences of large terms where dampers are
  /// strong.
  double rounding() const {
    const Index m = std::ssize(active);
    double most = 0;
    for (int i = 0; i < stages; ++i)
      for (const std::size_t e : entries) {
        const double factor = std::abs(rate[i] * jacobian[i][e]) / magnitude[pattern[e].row];
        const auto state = value.row(i * m + position[pattern[e].column]);
        if (factor != 0) most = std::max(most, factor * state.cwiseAbs().cwiseQuotient(extent).maxCoeff());
      }
    return rounded * most;
  }

  /// Of the last halving the error is kept, and where halving does not help: of what is rounding. `whole` is
  /// what the coefficients of a piece that ends at a root were before it was halved: where they have not
  /// become smaller though no swing is left to be resolved, the indentation is rounding, and nothing says
  /// that higher ones fall.
  bool resolves(const SlopeMatrix& slopes, bool is_last, double whole) {
    const auto found = tail(slopes);
    const double last = found.last;
    highest = last;
    const auto swings = [&] { return strength() > stiff; };
    const bool is_stiff = last > reserve * accuracy && swings();
    if (is_resolved(found, accuracy) && !is_stiff) return true;
    const bool is_noise = last >= whole && !swings();
    is_last |= is_noise || last <= rounding();
    if (is_last) unresolved = std::max(unresolved, is_noise || is_stiff ? last : found.rest);
    return is_last;
  }

  static bool ends_at_root(Edges edges, double u, double width) {
    return edges.beyond == 0 && u + width == 1;
  }

  bool solve_piece(LinearField& field, double start, double end, Edges edges, double u, double width,
                   SlopeMatrix& slopes, bool last, double whole) {
    read(field, start, end, edges, u, width);
    if (!last && !ends_at_root(edges, u, width) && foreseen(slopes) > clearly * largest_tail(accuracy))
      return false;
    Eigen::Map<Eigen::MatrixXd> s(slopes.values.data(), size, columns);
    now.resize(std::ssize(active), columns);
    for (std::size_t k = 0; k < active.size(); ++k) now.row(k) = s.row(active[k]);
    const bool solved = solve();
    if (!solved) highest = infinity;
    if (!solved && last) unresolved = 1;
    if (!(solved ? resolves(slopes, last, whole) : last)) return false;
    for (int i = 0; i < stages; ++i) s += gauss.weight[i] * slope[i];
    return true;
  }

  void carry(LinearField& field, double start, double end, Edges edges, double u, double width,
             SlopeMatrix& slopes, int depth, double whole = infinity) {
    const int most = ends_at_root(edges, u, width) ? most_halvings_at_root : most_halvings;
    if (solve_piece(field, start, end, edges, u, width, slopes, depth == most, whole)) return;
    const double own = ends_at_root(edges, u, width) ? highest : infinity;
    carry(field, start, end, edges, u, width / 2, slopes, depth + 1);
    carry(field, start, end, edges, u + width / 2, width / 2, slopes, depth + 1, own);
  }
};

Collocation::Collocation(std::vector<flow::Entry> pattern, std::span<const double> magnitudes,
                         std::span<const double> sizes, double accuracy, const std::vector<Index>& places,
                         const std::vector<Index>& unneeded)
    : memory_(std::make_unique<Memory>()) {
  auto& m = *memory_;
  m.pattern = std::move(pattern);
  m.size = std::ssize(magnitudes);
  m.columns = std::ssize(sizes);
  m.natural = Eigen::Map<const Eigen::RowVectorXd>(sizes.data(), m.columns);
  m.magnitude = Eigen::Map<const Eigen::VectorXd>(magnitudes.data(), m.size);
  m.weight = m.magnitude.cwiseInverse();
  for (const Index i : places) m.weight[i] = 0;
  m.accuracy = accuracy;
  m.find_entries(unneeded);
  m.find_active();
  std::vector<double> natural;
  for (const Index i : m.active) natural.push_back(magnitudes[i]);
  m.equations.emplace(m.pattern, m.position, std::move(natural));
  for (int i = 0; i < stages; ++i) {
    m.jacobian[i].resize(m.pattern.size());
    m.source[i] = SlopeMatrix(m.size, m.columns);
  }
}

Collocation::~Collocation() = default;

double Collocation::unresolved() const {
  return memory_->unresolved;
}

void Collocation::advance(LinearField& field, double start, double end, Edges edges, SlopeMatrix& slopes) {
  if (end > start && slopes.columns > 0) memory_->carry(field, start, end, edges, 0, 1, slopes, 0);
}

}  // namespace mariotte::impact
