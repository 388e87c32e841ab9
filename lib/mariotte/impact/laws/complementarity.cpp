#include "mariotte/impact/laws/complementarity.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "mariotte/core/error.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::impact {
namespace {

using Vector = Eigen::VectorXd;
using Compliance = Eigen::Map<const Eigen::MatrixXd>;
using ContactSet = std::vector<Index>;

/// Rates smaller than this are rounding of their sums of products, whose errors a solution with W may grow.
double noise(const Compliance& w, const Vector& p, const Vector& q) {
  const Vector terms = w.cwiseAbs() * p.cwiseAbs() + q.cwiseAbs();
  return 1e-14 * static_cast<double>(q.size()) * terms.maxCoeff();
}

/// The impulses of pushing contacts whose gap rates they bring to zero; the others give none.
Vector pushed(const Compliance& w, const Vector& q, const ContactSet& pushing) {
  Vector p = Vector::Zero(q.size());
  const Vector solution = Eigen::MatrixXd(w(pushing, pushing)).ldlt().solve(Vector(-q(pushing)));
  p(pushing) = solution;
  return p;
}

/// Towards `target` until the first impulse would turn negative; that contact stops pushing.
void approach(Vector& p, const Vector& target, ContactSet& pushing) {
  double share = 1;
  Index first = pushing.back();
  for (const Index j : pushing) {
    if (target[j] > 0) continue;
    const double reach = p[j] > 0 ? p[j] / (p[j] - target[j]) : 0;
    if (reach < share) share = reach, first = j;
  }
  p += share * (target - p);
  p[first] = 0;
  std::erase(pushing, first);
}

}  // namespace

std::vector<double> solve_complementarity(const std::vector<double>& compliance,
                                          const std::vector<double>& rates) {
  const Index m = std::ssize(rates);
  const Compliance w(compliance.data(), m, m);
  const Vector q = Eigen::Map<const Vector>(rates.data(), m);
  Vector p = Vector::Zero(m);
  ContactSet pushing;
  for (Index tries = 0; tries < 30 * (m + 1); ++tries) {
    Vector rate = w * p + q;
    for (const Index j : pushing) rate[j] = 0;
    Index closing = 0;
    if (rate.minCoeff(&closing) >= -noise(w, p, q)) return {p.begin(), p.end()};
    pushing.push_back(closing);
    Vector target = pushed(w, q, pushing);
    const auto pulls = [&](Index j) { return target[j] <= 0; };
    while (std::any_of(pushing.begin(), pushing.end(), pulls)) {
      approach(p, target, pushing);
      target = pushed(w, q, pushing);
    }
    p = target;
  }
  throw Error("the complementarity problem of this impact cannot be solved in double precision");
}

}  // namespace mariotte::impact
