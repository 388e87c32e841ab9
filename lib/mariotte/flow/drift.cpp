#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/free_motion.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {
namespace {

class Drift final : public Flow {
 public:
  bool fits(const Problem& problem) const override { return problem.free_motion() != nullptr; }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    const auto& motion = *problem.free_motion();
    start_.assign(x.begin(), x.end());
    const double meeting =
        motion.first_meeting(start_, request.limit, simultaneity_window(problem, request.accuracy), fired);
    if (!(meeting < infinity) && !(request.limit < infinity)) return {.outcome = Outcome::never};
    const bool ends = request.limit <= meeting;
    if (ends) fired.clear();
    StepOf step([&](double time, State there) { motion.fly(start_, time, there); });
    step.end = ends ? request.limit : meeting;
    step.at(step.end, x);
    step.before = start_;
    step.after = x;
    if (request.observer) request.observer->observe(step);
    return {.outcome = ends ? Outcome::limit : Outcome::guard, .duration = step.end, .steps = 1};
  }

 private:
  std::vector<double> start_;
};

}  // namespace

std::unique_ptr<Flow> make_drift_flow() {
  return std::make_unique<Drift>();
}

}  // namespace mariotte::flow
