// Scenes side by side, each until it ends; included as the series are.
#pragma once
#include <span>

#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// What a look into a step has found.
enum class Look { goes_on, changed, ended };

/// A lane whose scene has ended takes the next one. A `Step` knows the `Scene` that it loads, one that is
/// `idle` for lanes that have none, `most_steps` that a scene of the common course takes, and whether the
/// step of a lane `is_clear`: nothing ends in it.
template <class Step>
class SideBySide {
  using Scene = typename Step::Scene;

 public:
  /// `look(lane, scene, steps)` looks into a step that is not clear, or one of too many. If the scene has
  /// changed or ended, it has taken its state.
  template <class Into>
  void follow(std::span<Scene* const> scenes, const Precision& precision, Into&& look) {
    waiting_ = scenes;
    busy_ = 0;
    for (int lane = 0; lane < Step::scenes; ++lane) take(lane);
    while (busy_ > 0) {
      step_.advance(precision);
      for (int lane = 0; lane < Step::scenes; ++lane) {
        ++steps_[lane];
        if (is_over(steps_[lane]) || !step_.is_clear(lane)) look_into(lane, look);
      }
    }
  }

  const Step& step() const { return step_; }
  static bool is_over(int steps) { return steps > Step::most_steps; }

 private:
  void take(int lane) {
    scene_[lane] = waiting_.empty() ? nullptr : waiting_.front();
    if (scene_[lane]) waiting_ = waiting_.subspan(1), ++busy_;
    step_.load(lane, scene_[lane] ? *scene_[lane] : Step::idle);
    steps_[lane] = 0;
  }

  template <class Into>
  void look_into(int lane, Into& look) {
    if (!scene_[lane]) return;
    const Look found = look(lane, *scene_[lane], steps_[lane]);
    if (found == Look::changed) step_.load(lane, *scene_[lane]);
    if (found != Look::ended) return;
    --busy_;
    take(lane);
  }

  std::span<Scene* const> waiting_;
  int busy_ = 0;
  Scene* scene_[Step::scenes];  ///< null where there is none
  int steps_[Step::scenes];
  Step step_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
