// What a sweep asks of one scene: the numbers of its result that stand in the columns.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::study {

/// How one point ended.
struct Verdict {
  std::string ending = "separated";  ///< as in a result; "rejected" for a scene that makes no sense
  /// Why there are no numbers; which limit was reached, how wrong velocities may be, what to say of slopes.
  std::string reason = {};
  std::optional<double> estimated_accuracy = {};  ///< as of the run

  /// Whether the numbers mean something: the run ended by itself, or at a limit that the scene sets.
  bool has_numbers() const;
};

/// Fills in one number per column, nan where the result has none. Not to be shared between threads.
using Evaluate = std::function<Verdict(const scene::Scene&, std::span<double>)>;

/// Simulates scenes of any kind, by the quickest solver of their model if that has all the columns, and with
/// the same memory again and again.
Evaluate make_evaluate(const std::vector<Column>& columns);

/// The same for many scenes, of which those that are alike are solved side by side. What a scene gives does
/// not depend on the others. Not to be shared between threads, either.
class Evaluations {
 public:
  /// Takes what became of the scene that was put in by this number, and its numbers during the call.
  using Take = std::function<void(Index which, Verdict verdict, std::span<const double> numbers)>;

  Evaluations(const std::vector<Column>& columns, Take take);
  ~Evaluations();
  /// It is taken now, later, or by `finish`. Columns that are slopes need the `document` that the scene was
  /// read from. Throws what a scene that makes no sense throws.
  void put(Index which, const scene::Scene& scene, const scene::Document* document = nullptr);
  void finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mariotte::study
