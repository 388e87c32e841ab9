#include "mariotte/impact/sensitivity/stage_system.hpp"

#include <algorithm>

#include "mariotte/impact/sensitivity/gauss.hpp"

namespace mariotte::impact {

StageSystem::StageSystem(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position) {
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
void StageSystem::eliminate(const Links& links) {
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

Index StageSystem::unknowns() const {
  return stages * std::ssize(kept_);
}

void StageSystem::find_unknown() {
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

bool StageSystem::acts(const Link& link) const {
  for (int j = 0; j < stages; ++j)
    if (jacobian_[j][link.entry] != 0) return true;
  return false;
}

void StageSystem::solve(const std::vector<double>* jacobian, const double* h, Eigen::MatrixXd& values) {
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

void StageSystem::divide(Eigen::MatrixXd& values) {
  const Index all = std::ssize(place_), n = std::ssize(unknown_);
  right_.resize(n * stages, values.cols());
  for (int i = 0; i < stages; ++i)
    for (Index k = 0; k < n; ++k) right_.row(i * n + k) = values.row(i * all + unknown_[k]);
  right_ = system_.partialPivLu().solve(right_);
  for (int i = 0; i < stages; ++i)
    for (Index k = 0; k < n; ++k) values.row(i * all + unknown_[k]) = right_.row(i * n + k);
}

void StageSystem::set_system() {
  const Index n = stages * std::ssize(unknown_);
  system_.setIdentity(n, n);
  for (const auto& link : among_kept_)
    if (!is_known(link.row) && !is_known(link.column)) add_direct(link);
  for (const auto& link : to_kept_)
    if (acts(link)) add_through(link);
}

/// What known components, or the others, do by these links.
void StageSystem::add(const Links& links, bool of_known, Eigen::MatrixXd& values) const {
  for (const auto& link : links)
    if (is_known(link.column) == of_known) add_to(link, values);
}

void StageSystem::add_direct(const Link& link) {
  const Index n = std::ssize(unknown_), row = place_[link.row], column = place_[link.column];
  for (int j = 0; j < stages; ++j) {
    const double factor = rise(link, j);
    if (factor == 0) continue;
    for (int i = 0; i < stages; ++i) system_(i * n + row, j * n + column) -= gauss.integral[i][j] * factor;
  }
}

/// What kept components do to one by way of an eliminated one.
void StageSystem::add_through(const Link& link) {
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

void StageSystem::add_to(const Link& link, Eigen::MatrixXd& values) const {
  const Index all = std::ssize(place_);
  for (int j = 0; j < stages; ++j) {
    const double factor = rise(link, j);
    if (factor == 0) continue;
    for (int i = 0; i < stages; ++i)
      values.row(i * all + link.row) += gauss.integral[i][j] * factor * values.row(j * all + link.column);
  }
}

}  // namespace mariotte::impact
