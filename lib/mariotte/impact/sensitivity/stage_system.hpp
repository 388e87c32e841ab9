// The linear equations between the values of a piece's components at its Gauss points,
//
//   Z_i = R_i + Σ_j a_ij h_j J_j Z_j.
//
// Components that do not depend on each other, such as gaps, which depend on velocities alone, are eliminated
// by hand: half of the unknowns, and seven eighths of a division. What nothing acts on in this piece, such as
// balls in flight, is known.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "mariotte/flow/flow.hpp"

namespace mariotte::impact {

class StageSystem {
 public:
  /// `position` of a component among those that rates depend on, or −1.
  StageSystem(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position);

  /// Unknowns of a division, at most.
  Index unknowns() const;
  /// R becomes Z: values by point and component. Entries of J by point, and h.
  void solve(const std::vector<double>* jacobian, const double* h, Eigen::MatrixXd& values);

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
  void divide(Eigen::MatrixXd& values);
  void add_direct(const Link& link);
  void add_through(const Link& link);
  void add(const Links& links, bool of_known, Eigen::MatrixXd& values) const;
  void add_to(const Link& link, Eigen::MatrixXd& values) const;
  double rise(const Link& link, int point) const { return h_[point] * jacobian_[point][link.entry]; }
  bool acts(const Link& link) const;
  bool is_known(Index component) const { return place_[component] < 0; }

  std::vector<Index> kept_;     ///< components that are not eliminated
  std::vector<Index> unknown_;  ///< those of them that something acts on
  std::vector<Index> place_;    ///< of a component among these, or −1
  Links among_kept_, to_kept_, to_eliminated_;
  Eigen::MatrixXd system_, right_;
  const std::vector<double>* jacobian_ = nullptr;
  const double* h_ = nullptr;
};

}  // namespace mariotte::impact
