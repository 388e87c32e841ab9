#include "mariotte/study/fit/fit_curves.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::study {
namespace {

constexpr std::size_t most_curves = 8;
constexpr int points = 200;
constexpr double margin = 1.15;  // of a curve beyond its measurements
constexpr double wide = 5;       // ratio from which an axis is logarithmic

const double* number(const Measurement& row, std::size_t setting) {
  return std::get_if<double>(&row.values[setting].value);
}

std::optional<std::size_t> abscissa(const Measurements& measurements) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < measurements.settings.size(); ++i) {
    const auto is_number = [&](const auto& row) { return number(row, i) != nullptr; };
    if (!std::all_of(measurements.rows.begin(), measurements.rows.end(), is_number)) continue;
    if (measurements.settings[i].key == "incidence.normal_speed") return i;
    if (!found) found = i;
  }
  return found;
}

std::string name(const Measurements& measurements, const Measurement& row, std::size_t abscissa) {
  std::string text;
  for (std::size_t i = 0; i < row.written.size(); ++i)
    if (i != abscissa)
      text += (text.empty() ? "" : ", ") + measurements.settings[i].name + " " + row.written[i];
  return text;
}

/// Between the ends of the measurements, and a little further.
std::vector<double> places(double from, double to, bool logarithmic) {
  std::vector<double> all;
  const double beyond = (margin - 1) * (to - from);
  for (int i = 0; i < points; ++i) {
    const double share = i / (points - 1.0);
    all.push_back(logarithmic ? from / margin * std::pow(margin * margin * to / from, share)
                              : from + share * (to - from + beyond));
  }
  return all;
}

class Collection {
 public:
  Collection(FitModel& model, const Fit& fit, std::size_t setting)
      : model_(model), values_(fit.values()), made_{.setting = setting} {}

  bool group() {
    for (const auto& row : measurements().rows) {
      const auto label = name(measurements(), row, made_.setting);
      const auto same = [&](const FitCurve& curve) { return curve.name == label; };
      auto curve = std::find_if(made_.curves.begin(), made_.curves.end(), same);
      if (curve == made_.curves.end()) curve = made_.curves.insert(curve, {.name = label});
      curve->abscissa.push_back(*number(row, made_.setting));
      made_.curve_of_row.push_back(static_cast<std::size_t>(curve - made_.curves.begin()));
    }
    return made_.curves.size() <= most_curves;
  }

  FitCurves drawn() {
    const auto [least, most] = ends(measured());
    const bool is_angle = measurements().settings[made_.setting].unit == "rad";
    made_.logarithmic = !is_angle && least > 0 && most > wide * least;
    for (std::size_t k = 0; k < made_.curves.size(); ++k) draw(k);
    return made_;
  }

 private:
  const Measurements& measurements() const { return model_.measurements(); }

  static std::pair<double, double> ends(const std::vector<double>& numbers) {
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    return {*least, *most};
  }

  std::vector<double> measured() const {
    std::vector<double> all;
    for (const auto& row : measurements().rows) all.push_back(*number(row, made_.setting));
    return all;
  }

  void draw(std::size_t k) {
    auto& curve = made_.curves[k];
    const auto first = std::find(made_.curve_of_row.begin(), made_.curve_of_row.end(), k);
    auto settings = measurements().rows[static_cast<std::size_t>(first - made_.curve_of_row.begin())].values;
    const auto [from, to] = ends(curve.abscissa);
    curve.abscissa.clear();
    for (const double place : places(from, to, made_.logarithmic)) {
      settings[made_.setting].value = place;
      try {
        const auto predicted = model_.at(settings, values_);
        curve.ordinate.push_back(predicted.value);
        curve.captured.push_back(predicted.captured);
        curve.abscissa.push_back(place);
      } catch (const Error&) {
        // Beyond the measurements there may be no scene; the curve has a gap there.
      }
    }
  }

  FitModel& model_;
  std::vector<double> values_;
  FitCurves made_;
};

}  // namespace

std::optional<FitCurves> fit_curves(FitModel& model, const Fit& fit) {
  const auto setting = abscissa(model.measurements());
  if (!setting) return {};
  Collection collection(model, fit, *setting);
  if (!collection.group()) return {};
  return collection.drawn();
}

}  // namespace mariotte::study
