#include "mariotte/impact/sensitivity/stage_system.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "mariotte/impact/sensitivity/gauss.hpp"

namespace mariotte::impact {

class StageSystem::Equations {
 public:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Values = Eigen::Map<Rows>;

  Equations(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position,
            std::vector<double> magnitude);
  Index unknowns() const;
  Index rows() const { return stages * std::ssize(place_); }
  void solve(const std::vector<double>* jacobian, const double* h, Values& values);

 private:
  /// Entry of the Jacobian between two components.
  struct Link {
    Index row, column;
    std::size_t entry;
  };
  using Links = std::vector<Link>;

  void eliminate(const Links& links);
  void find_unknown();
  void set_system();
  void divide(Values& values);
  void scale();
  void add_direct(const Link& link);
  void add_through(const Link& link);
  void add(const Links& links, bool of_known, Values& values) const;
  void add_to(const Link& link, Values& values) const;
  double rise(const Link& link, int point) const { return h_[point] * jacobian_[point][link.entry]; }
  bool acts(const Link& link) const;
  bool is_known(Index component) const { return place_[component] < 0; }

  std::vector<double> magnitude_;  ///< by component
  std::vector<Index> kept_;        ///< components that are not eliminated
  std::vector<Index> unknown_;     ///< those of them that something acts on
  std::vector<Index> place_;       ///< of a component among these, or −1
  Links among_kept_, to_kept_, to_eliminated_;
  Eigen::MatrixXd system_;
  Rows right_;
  const std::vector<double>* jacobian_ = nullptr;
  const double* h_ = nullptr;
};

StageSystem::Equations::Equations(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position,
                                  std::vector<double> magnitude)
    : magnitude_(std::move(magnitude)) {
  Links links;
  for (std::size_t e = 0; e < pattern.size(); ++e)
    if (const Index row = position[pattern[e].row]; row >= 0)
      links.push_back({row, position[pattern[e].column], e});
  Index components = 0;
  for (const Index k : position) components = std::max(components, k + 1);
  place_.resize(components);
  eliminate(links);
}

/// Components in turn, unless they depend on themselves or are linked with one that is eliminated.
void StageSystem::Equations::eliminate(const Links& links) {
  std::vector<char> is_eliminated(place_.size(), 0);
  for (Index k = std::ssize(place_); k-- > 0;)
    is_eliminated[k] = std::none_of(links.begin(), links.end(), [&](const Link& link) {
      return (link.row == k && (link.column == k || is_eliminated[link.column])) ||
             (link.column == k && is_eliminated[link.row]);
    });
  for (Index k = 0; k < std::ssize(place_); ++k)
    if (!is_eliminated[k]) kept_.push_back(k);
  for (const auto& link : links)
    (is_eliminated[link.row]      ? to_eliminated_
     : is_eliminated[link.column] ? to_kept_
                                  : among_kept_)
        .push_back(link);
}

Index StageSystem::Equations::unknowns() const {
  return stages * std::ssize(kept_);
}

void StageSystem::Equations::find_unknown() {
  std::fill(place_.begin(), place_.end(), -1);
  for (const auto* links : {&among_kept_, &to_kept_})
    for (const auto& link : *links)
      if (acts(link)) place_[link.row] = 0;
  unknown_.clear();
  for (const Index k : kept_) {
    if (is_known(k)) continue;
    place_[k] = std::ssize(unknown_);
    unknown_.push_back(k);
  }
}

bool StageSystem::Equations::acts(const Link& link) const {
  for (int j = 0; j < stages; ++j)
    if (jacobian_[j][link.entry] != 0) return true;
  return false;
}

void StageSystem::Equations::solve(const std::vector<double>* jacobian, const double* h, Values& values) {
  jacobian_ = jacobian;
  h_ = h;
  find_unknown();
  set_system();
  add(to_eliminated_, true, values);
  add(among_kept_, true, values);
  for (const auto& link : to_kept_) add_to(link, values);
  if (!unknown_.empty()) divide(values);
  add(to_eliminated_, false, values);
}

void StageSystem::Equations::divide(Values& values) {
  const Index all = std::ssize(place_), n = std::ssize(unknown_);
  right_.resize(n * stages, values.cols());
  for (int i = 0; i < stages; ++i)
    for (Index k = 0; k < n; ++k) right_.row(i * n + k) = values.row(i * all + unknown_[k]);
  scale();
  right_ = system_.partialPivLu().solve(right_);
  for (int i = 0; i < stages; ++i)
    for (Index k = 0; k < n; ++k)
      values.row(i * all + unknown_[k]) = magnitude_[unknown_[k]] * right_.row(i * n + k);
}

/// Unknowns in their natural sizes: pivots that are large by their units alone lose digits.
void StageSystem::Equations::scale() {
  const Index n = std::ssize(unknown_);
  Eigen::VectorXd size(n * stages);
  for (Index row = 0; row < size.size(); ++row) size[row] = magnitude_[unknown_[row % n]];
  const Eigen::VectorXd inverse = size.cwiseInverse();
  right_ = inverse.asDiagonal() * right_;
  system_ = inverse.asDiagonal() * system_ * size.asDiagonal();
}

void StageSystem::Equations::set_system() {
  const Index n = stages * std::ssize(unknown_);
  system_.setIdentity(n, n);
  for (const auto& link : among_kept_)
    if (!is_known(link.row) && !is_known(link.column)) add_direct(link);
  for (const auto& link : to_kept_)
    if (acts(link)) add_through(link);
}

/// What known components, or the others, do by these links.
void StageSystem::Equations::add(const Links& links, bool of_known, Values& values) const {
  for (const auto& link : links)
    if (is_known(link.column) == of_known) add_to(link, values);
}

void StageSystem::Equations::add_direct(const Link& link) {
  const Index n = std::ssize(unknown_), row = place_[link.row], column = place_[link.column];
  for (int j = 0; j < stages; ++j) {
    const double factor = rise(link, j);
    if (factor == 0) continue;
    for (int i = 0; i < stages; ++i) system_(i * n + row, j * n + column) -= gauss.integral[i][j] * factor;
  }
}

/// What kept components do to one by way of an eliminated one.
void StageSystem::Equations::add_through(const Link& link) {
  const Index n = std::ssize(unknown_), row = place_[link.row];
  double twice[stages][stages] = {};
  for (int j = 0; j < stages; ++j)
    for (int i = 0; i < stages; ++i)
      for (int k = 0; k < stages; ++k)
        twice[k][i] += gauss.integral[i][j] * rise(link, j) * gauss.integral[j][k];
  for (const auto& next : to_eliminated_) {
    if (next.row != link.column || is_known(next.column)) continue;
    for (int k = 0; k < stages; ++k)
      for (int i = 0; i < stages; ++i)
        system_(i * n + row, k * n + place_[next.column]) -= twice[k][i] * rise(next, k);
  }
}

void StageSystem::Equations::add_to(const Link& link, Values& values) const {
  const Index all = std::ssize(place_);
  for (int j = 0; j < stages; ++j) {
    const double factor = rise(link, j);
    if (factor == 0) continue;
    for (int i = 0; i < stages; ++i)
      values.row(i * all + link.row) += gauss.integral[i][j] * factor * values.row(j * all + link.column);
  }
}

StageSystem::StageSystem(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position,
                         std::vector<double> magnitude)
    : equations_(std::make_unique<Equations>(pattern, position, std::move(magnitude))) {}
StageSystem::~StageSystem() = default;

Index StageSystem::unknowns() const {
  return equations_->unknowns();
}

void StageSystem::solve(const std::vector<double>* jacobian, const double* h, std::span<double> values) {
  if (values.empty()) return;
  const Index rows = equations_->rows();
  Equations::Values all(values.data(), rows, std::ssize(values) / rows);
  equations_->solve(jacobian, h, all);
}

}  // namespace mariotte::impact
