// Many scenes of one kind: those that lanes can follow side by side, the others alone.
#pragma once
#include <array>
#include <functional>
#include <utility>

#include "mariotte/core/natural_root.hpp"
#include "mariotte/hybrid/options.hpp"

namespace mariotte::impact {

/// `Runs` name their Model, its Solver and the Impact that comes out, say which scene a model is, if it is
/// one for them, and follow those that are added; `restore` puts the numbers of a scene back into
/// `any_model`.
template <class Runs>
class LaneBatch {
 public:
  using Model = typename Runs::Model;
  using Impact = typename Runs::Impact;
  using Take = std::function<void(Index which, const Model& model, const Impact& impact)>;

  explicit LaneBatch(Take take) : take_(std::move(take)) {}

  void put(Index which, const Model& model, const hybrid::Options& options) {
    validate(model);
    hybrid::validate(options);
    const auto scene = Runs::scene_of(model, options, natural_root_);
    if (!scene) return take_(which, model, solver_.solve(model, options));
    const auto count = waiting_.scenes().size();
    if (count == Runs::at_once || (count > 0 && options.accuracy != waiting_.accuracy())) finish();
    which_[waiting_.scenes().size()] = which;
    waiting_.add(*scene, options.accuracy);
  }

  void finish() {
    waiting_.follow();
    for (std::size_t i = 0; i < waiting_.scenes().size(); ++i) {
      restore(waiting_.scenes()[i], model_);
      const auto* impact = waiting_.result(i);
      take_(which_[i], model_, impact ? *impact : solver_.solve(model_, {.accuracy = waiting_.accuracy()}));
    }
    waiting_.clear();
  }

 private:
  Take take_;
  typename Runs::Solver solver_;
  Runs waiting_;
  std::array<Index, Runs::at_once> which_;
  NaturalRoot natural_root_;
  Model model_ = Runs::any_model();
};

}  // namespace mariotte::impact
