// The state of linear contacts at any time of a phase.
#pragma once
#include <vector>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/modal/vibration.hpp"

namespace mariotte::flow {

/// The state between two instants of natural modes.
class ModalStep final : public Step {
 public:
  /// One of each per mode.
  struct Workspace {
    std::vector<Swing> swing;
    std::vector<Progress> progress;
  };

  /// All must outlive the step; `origin` is the state at time 0.
  ModalStep(const Vibration& vibration, ConstState origin, Workspace& workspace)
      : vibration_(vibration), origin_(origin), workspace_(workspace) {}

  void at(double time, State x) const override;

 private:
  double value(const Wave& wave, double time) const;
  void add_work(const VibrationGroup& group, double time, State x) const;
  void add_product(const VibrationGroup& group, Index left, Index right, double time, State x) const;
  double straight_work(const VibrationGroup& group, const ContactMotion& motion, double time) const;

  const Vibration& vibration_;
  ConstState origin_;
  Workspace& workspace_;
};

}  // namespace mariotte::flow
