#include "mariotte/impact/sensitivity/stage_system.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <functional>
#include <utility>

#include "mariotte/impact/sensitivity/gauss.hpp"

namespace mariotte::impact {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Values = Eigen::Map<Rows>;
using Square = Eigen::Matrix<double, stages, stages, Eigen::RowMajor>;
/// One component at all points.
using History = Eigen::Matrix<double, stages, Eigen::Dynamic, Eigen::RowMajor>;

/// Integrals up to the points, of what components are at them.
auto integral() {
  return Eigen::Map<const Square>(gauss.integral[0]);
}

/// One of so many components.
auto history(Index component, Index components, Values& values) {
  return Eigen::Map<History, 0, Eigen::OuterStride<>>(values.row(component).data(), stages, values.cols(),
                                                      Eigen::OuterStride<>(components * values.cols()));
}

}  // namespace

class StageSystem::Equations {
 public:
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
  template <class Counts>
  void add(const Links& links, Counts&& counts, Values& values);
  auto own_history(Index component, Values& values) const {
    return history(component, std::ssize(place_), values);
  }
  auto system_of(Index row, Index column) {
    const Index n = std::ssize(unknown_);
    using Strides = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
    return Eigen::Map<Eigen::Matrix<double, stages, stages>, 0, Strides>(&system_(row, column),
                                                                         Strides(n * system_.rows(), n));
  }
  auto rises(const Link& link) const {
    Eigen::Matrix<double, stages, 1> list;
    for (int j = 0; j < stages; ++j) list[j] = h_[j] * jacobian_[j][link.entry];
    return list;
  }
  bool acts(const Link& link) const;
  bool is_known(Index component) const { return place_[component] < 0; }

  std::vector<double> magnitude_;  ///< by component
  std::vector<Index> kept_;        ///< components that are not eliminated
  std::vector<Index> unknown_;     ///< those of them that something acts on
  std::vector<Index> place_;       ///< of a component among these, or −1
  Links among_kept_, to_kept_, to_eliminated_;
  Eigen::MatrixXd system_;
  Rows right_;
  History change_;
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
  std::stable_sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.row < b.row; });
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
  const auto comes_from_known = [&](const Link& link) { return is_known(link.column); };
  add(to_eliminated_, comes_from_known, values);
  add(among_kept_, comes_from_known, values);
  add(
      to_kept_, [](const Link&) { return true; }, values);
  if (!unknown_.empty()) divide(values);
  add(to_eliminated_, std::not_fn(comes_from_known), values);
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

/// What components do by those of these links that count. Links of a row follow each other.
template <class Counts>
void StageSystem::Equations::add(const Links& links, Counts&& counts, Values& values) {
  for (auto link = links.begin(); link != links.end();) {
    const Index row = link->row;
    bool changes = false;
    change_.setZero(stages, values.cols());
    for (; link != links.end() && link->row == row; ++link) {
      if (!counts(*link)) continue;
      change_ += rises(*link).asDiagonal() * own_history(link->column, values);
      changes = true;
    }
    if (changes) own_history(row, values) += integral().lazyProduct(change_);
  }
}

void StageSystem::Equations::add_direct(const Link& link) {
  system_of(place_[link.row], place_[link.column]) -= integral() * rises(link).asDiagonal();
}

/// What kept components do to one by way of an eliminated one.
void StageSystem::Equations::add_through(const Link& link) {
  const Square twice = integral() * rises(link).asDiagonal() * integral();
  for (const auto& next : to_eliminated_)
    if (next.row == link.column && !is_known(next.column))
      system_of(place_[link.row], place_[next.column]) -= twice * rises(next).asDiagonal();
}

StageSystem::StageSystem(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position,
                         std::vector<double> magnitude)
    : equations_(std::make_unique<Equations>(pattern, position, std::move(magnitude))) {}
StageSystem::~StageSystem() = default;

Index StageSystem::unknowns() const {
  return equations_->unknowns();
}

void StageSystem::add_integral(Index component, std::span<const double> source,
                               std::span<double> values) const {
  const Index rows = equations_->rows(), columns = std::ssize(source) / stages;
  Values all(values.data(), rows, columns);
  history(component, rows / stages, all) +=
      integral().lazyProduct(Eigen::Map<const History>(source.data(), stages, columns));
}

void StageSystem::solve(const std::vector<double>* jacobian, const double* h, std::span<double> values) {
  if (values.empty()) return;
  const Index rows = equations_->rows();
  Values all(values.data(), rows, std::ssize(values) / rows);
  equations_->solve(jacobian, h, all);
}

}  // namespace mariotte::impact
