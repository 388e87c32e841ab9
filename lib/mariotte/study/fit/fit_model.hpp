// What a scene predicts for the settings of each measurement and any values of the keys that are to be found.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/study/fit/fit_slopes.hpp"
#include "mariotte/study/fit/measurements.hpp"
#include "mariotte/study/sweep/evaluate.hpp"

namespace mariotte::study {

/// Of what was measured; 0 if a body or a pair is captured.
struct Prediction {
  double value = 0;
  bool captured = false;
};

/// Not to be shared between threads.
class FitModel {
 public:
  /// `free` names keys whose values the scene gives to start from, all positive. Resolves every row; throws
  /// scene::SceneError for the first that is no scene, or whose result has no such number, at its place in
  /// the table.
  FitModel(scene::Document document, const std::vector<std::string>& free, Measurements measurements);

  const Measurements& measurements() const { return measurements_; }  ///< numbers in SI
  const std::vector<double>& start() const { return start_; }         ///< of the free keys [SI]
  double accuracy() const { return accuracy_; }                       ///< of the simulations
  Index runs() const { return runs_; }                                ///< impacts simulated so far
  Index runs_with_slopes() const { return runs_with_slopes_; }        ///< of them, those that carried slopes
  /// Called before every impact from now on; what it throws ends the fit, unless it is an Error.
  void watch(std::function<void()> watch) { watch_ = std::move(watch); }

  /// The scene of row `row` with these values of the free keys.
  scene::Scene scene_of_row(std::size_t row, std::span<const double> values) {
    return scene_at(measurements_.rows[row].values, values);
  }
  /// What has to be said of the scene at the speeds of the measurements.
  std::vector<std::string> warnings_of_speeds();
  /// What row `row` would measure with these values of the free keys. Throws Error that names the row.
  Prediction of_row(std::size_t row, std::span<const double> values);

  /// Its exact slopes, all from one run; zero if a body or a pair is captured.
  Slopes slopes_of_row(std::size_t row, std::span<const double> values);
  /// Know no exact slopes from now on.
  void leave_out_slopes() { outcomes_.clear(); }
  /// Whether the search is to take them. A body is run sooner than its scene is read, which slopes ask for
  /// eight times per key.
  bool searches_by_slopes() const { return !is_body_; }

  /// The same for other settings, one value per key of the measurements.
  Prediction at(const std::vector<scene::Node>& settings, std::span<const double> values);

 private:
  void find_start(const std::vector<std::string>& free);
  void expect_start(std::size_t index);
  void resolve_row(Measurement& row);
  void expect_approach(const scene::Scene& scene) const;
  void set(const std::vector<scene::Node>& settings);
  void set_free(std::size_t i, double value);
  scene::Scene scene_at(const std::vector<scene::Node>& settings, std::span<const double> values);
  void name_settings(const scene::Scene& scene);
  void name_diameter(std::size_t i, const std::string& table);
  void expect_new(std::size_t i) const;
  void expect_quantity(const scene::Scene& scene);
  Prediction of_body(const model::Microbody& body, const hybrid::Options& options);
  Prediction of_result(const scene::Scene& scene);
  impact::Sensitivity sensitivity(const scene::Scene& scene, std::span<const double> values);
  template <class Model>
  std::vector<impact::Parameter<Model>> parameters(std::span<const double> values);
  Slopes of_pair(const impact::Sensitivity& found, const model::Chain& chain) const;

  scene::Document document_;
  Measurements measurements_;
  std::vector<std::string> free_;
  std::vector<scene::Place> free_places_;
  scene::Place cell_;  ///< where the settings come from, for messages
  std::vector<double> start_;
  double accuracy_ = 0;
  Index runs_ = 0, runs_with_slopes_ = 0;
  std::function<void()> watch_ = [] {};
  impact::MicrobodySolver solver_;
  Evaluate evaluate_;  ///< of all but the restitution of a body
  std::vector<double> columns_;
  bool is_body_ = false;
  std::vector<std::string> outcomes_;  ///< with the slopes of what was measured; none if they are not known
};

}  // namespace mariotte::study
