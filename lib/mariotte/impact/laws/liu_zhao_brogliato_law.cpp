#include "mariotte/impact/laws/liu_zhao_brogliato_law.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {
namespace {

using Vector = Eigen::VectorXd;

enum class Stage : unsigned char { open, loading, unloading };

/// Impulses p and indentations δ.
struct State {
  Vector p, depth;
};

State sum(const State& a, double factor, const State& b) {
  return {a.p + factor * b.p, a.depth + factor * b.depth};
}

/// The impact as seen by its contacts alone.
struct Contacts {
  const DistributionLaw& law;
  Eigen::MatrixXd compliance;
  Vector rates;  ///< at the start
  Vector depth;  ///< natural depth of each contact
  double speed, time, slow;

  Contacts(const Configuration& c, const DistributionLaw& distribution);
  Vector rate(const State& x) const { return rates + compliance * x.p; }
  State derivative(const State& x, const std::vector<Stage>& stage) const;
  double error(const State& x) const;
  Stage next(Stage stage, double depth, double rate) const;
  bool is_over(const State& x) const;
};

Contacts::Contacts(const Configuration& c, const DistributionLaw& distribution) : law(distribution) {
  const auto w = gap_rates(c, c.velocity);
  const Index m = std::ssize(w);
  const auto products = impact::compliance(c);
  compliance = Eigen::Map<const Eigen::MatrixXd>(products.data(), m, m);
  rates = Eigen::Map<const Vector>(w.data(), m);
  speed = rates.cwiseAbs().maxCoeff();
  slow = rounding * speed;
  time = infinity;
  depth = Vector(m);
  for (Index j = 0; j < m; ++j) {
    depth[j] = std::pow(speed * speed / (compliance(j, j) * law.stiffness[j]), 1 / (law.exponent[j] + 1));
    time = std::min(time, depth[j] / speed);
  }
}

State Contacts::derivative(const State& x, const std::vector<Stage>& stage) const {
  const Vector w = rate(x);
  State dx{Vector::Zero(w.size()), Vector::Zero(w.size())};
  for (Index j = 0; j < w.size(); ++j) {
    if (stage[j] == Stage::open) continue;
    const double e = stage[j] == Stage::unloading ? law.restitution[j] : 1;
    dx.p[j] = law.stiffness[j] * std::pow(std::max(0.0, x.depth[j]), law.exponent[j]);
    dx.depth[j] = -w[j] / (e * e);
  }
  return dx;
}

/// Of a difference of states, in units of the natural ones.
double Contacts::error(const State& x) const {
  const Vector p = x.p.cwiseProduct(compliance.diagonal()) / speed;
  return std::max(p.cwiseAbs().maxCoeff(), x.depth.cwiseQuotient(depth).cwiseAbs().maxCoeff());
}

Stage Contacts::next(Stage stage, double x, double w) const {
  switch (stage) {
    case Stage::open:
      return w < -slow ? Stage::loading : Stage::open;
    case Stage::loading:
      return w > 0 ? Stage::unloading : Stage::loading;
    case Stage::unloading:
      return x <= 0 ? Stage::open : w < 0 ? Stage::loading : Stage::unloading;
  }
  return stage;
}

bool Contacts::is_over(const State& x) const {
  return (x.depth.array() <= 0).all() && (rate(x).array() >= -slow).all();
}

/// One step of order 5, and its difference to the embedded one of order 4 [Dormand & Prince 1980].
struct Step {
  State after, difference;
};

Step step(const Contacts& contacts, const std::vector<Stage>& stage, const State& x, double h) {
  constexpr std::array<std::array<double, 6>, 6> a = {
      {{1.0 / 5},
       {3.0 / 40, 9.0 / 40},
       {44.0 / 45, -56.0 / 15, 32.0 / 9},
       {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
       {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
       {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}};
  constexpr std::array<double, 7> d = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                       -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  std::array<State, 7> k;
  State at = x;
  for (std::size_t i = 0; i < k.size(); ++i) {
    k[i] = contacts.derivative(at, stage);
    if (i == a.size()) break;
    at = x;
    for (std::size_t j = 0; j <= i; ++j) at = sum(at, h * a[i][j], k[j]);
  }
  State difference{Vector::Zero(x.p.size()), Vector::Zero(x.p.size())};
  for (std::size_t i = 0; i < k.size(); ++i) difference = sum(difference, h * d[i], k[i]);
  return {at, difference};
}

/// A run of the law through loading, unloading and open contacts.
class Run {
 public:
  Run(const Configuration& c, const DistributionLaw& law)
      : contacts_(c, law), x_{Vector::Zero(contacts_.rates.size()), Vector::Zero(contacts_.rates.size())} {
    // What touches at rest is loaded as soon as a neighbour pushes it.
    for (const double w : contacts_.rates) stage_.push_back(w <= 0 ? Stage::loading : Stage::open);
    if (contacts_.speed > 0) h_ = 1e-3 * contacts_.time;
  }
  Index steps() const { return steps_; }
  bool is_over() const { return !(contacts_.speed > 0) || contacts_.is_over(x_); }

  void advance() {
    auto [after, difference] = step(contacts_, stage_, x_, h_);
    ++steps_;
    const double share = contacts_.error(difference) / (contacts_.law.accuracy * h_ / contacts_.time);
    const double factor = std::clamp(0.9 * std::pow(share, -0.25), 0.2, 4.0);
    if (share > 1) {
      h_ *= factor;
      return;
    }
    if (changes(after)) after = first_change();
    x_ = after;
    switch_stages();
    h_ *= factor;
  }
  std::vector<double> impulse() const { return {x_.p.begin(), x_.p.end()}; }

 private:
  bool changes(const State& x) const {
    const Vector w = contacts_.rate(x);
    for (Index j = 0; j < w.size(); ++j)
      if (contacts_.next(stage_[j], x.depth[j], w[j]) != stage_[j]) return true;
    return false;
  }
  /// The shortest step that changes a stage, to the last bits.
  State first_change() const {
    double low = 0, high = h_;
    for (int i = 0; i < 52; ++i) {
      const double middle = (low + high) / 2;
      (changes(step(contacts_, stage_, x_, middle).after) ? high : low) = middle;
    }
    return step(contacts_, stage_, x_, high).after;
  }
  void switch_stages() {
    const Vector w = contacts_.rate(x_);
    for (Index j = 0; j < w.size(); ++j) {
      stage_[j] = contacts_.next(stage_[j], x_.depth[j], w[j]);
      if (stage_[j] == Stage::open) x_.depth[j] = 0;
    }
  }

  Contacts contacts_;
  State x_;
  std::vector<Stage> stage_;
  double h_ = 0;
  Index steps_ = 0;
};

void validate(const Configuration& c, const DistributionLaw& law) {
  validate(c, law.restitution);
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!std::all_of(law.restitution.begin(), law.restitution.end(), positive))
    throw InvalidParameter("an energetic coefficient of restitution must be positive");
  if (law.stiffness.size() != c.contact.size() ||
      !std::all_of(law.stiffness.begin(), law.stiffness.end(), positive))
    throw InvalidParameter("the distribution law needs one positive stiffness per contact");
  const auto may_be_exponent = [](double value) { return value >= 1 && std::isfinite(value); };
  if (law.exponent.size() != c.contact.size() ||
      !std::all_of(law.exponent.begin(), law.exponent.end(), may_be_exponent))
    throw InvalidParameter("exponents of the distribution law, one per contact, are finite and at least 1");
  if (!(law.accuracy > 0 && law.accuracy < 1)) throw InvalidParameter("accuracy must lie between 0 and 1");
}

}  // namespace

LawOutcome liu_zhao_brogliato(const Configuration& c, const DistributionLaw& law) {
  validate(c, law);
  Run run(c, law);
  while (!run.is_over() && run.steps() < law.most_steps) run.advance();
  auto outcome = outcome_of(c, run.impulse(), law.accuracy);
  if (!run.is_over()) outcome.status = LawStatus::unfinished;
  outcome.steps = run.steps();
  return outcome;
}

}  // namespace mariotte::impact
