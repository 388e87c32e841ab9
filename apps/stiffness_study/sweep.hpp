// One quantity varied, every flow that admits the impact.
#pragma once
#include <string>
#include <vector>

#include "measure.hpp"
#include "reference.hpp"

namespace mariotte::stiffness_study {

/// What the command line asks for.
struct Settings {
  bool quick = false;
  std::string flow;  ///< only this one; empty for all
  double accuracy = 1e-10;

  /// Time after which a flow is not tried on the rest of a sweep [s].
  double patience() const { return quick ? 0.03 : 0.5; }
  /// CPU time after which a run is ended [s].
  double limit() const { return 8 * patience(); }
  double batch() const { return quick ? 2e-4 : 3e-3; }
};

/// One line of a table and of the CSV file.
struct Row {
  std::string study;   ///< as on the command line
  std::string series;  ///< the impact, "Hertz triplet"
  std::string family;  ///< what is varied, "c ∝ k^{n/(n+1)}"
  double value;        ///< of the varied quantity
  std::string flow;
  double accuracy;
  ImpactCase impact_case;
  Run run;
  double error;  ///< largest error of the final velocities / incident speed; NaN if unknown
  std::string reference;
};

struct Point {
  double value;
  ImpactCase impact_case;
};

/// A line of a study: the same impact at several values.
struct Series {
  std::string study, name, family;
  std::vector<Point> points;
  double longest = infinity;  ///< each run ends at this multiple of the natural time
  bool brief = false;         ///< see Request
};

using Rows = std::vector<Row>;

/// "auto" and the flows that follow contacts, or the one asked for; in a hurry only "auto" for long chains.
std::vector<std::string> flows(const Settings& settings, Index balls);

/// Every flow of the list along the series, in the order of its points. A flow that does not admit the impact
/// is left out; one that took longer than patience allows is not tried on the points that follow.
Rows sweep(const Series& series, const std::vector<std::string>& flows, const Settings& settings,
           References& references);
Rows sweep(const Series& series, const Settings& settings, References& references);

/// `first`, `first`·`factor`, … up to `last`.
std::vector<double> powers(double first, double last, double factor);

/// Append one list to another.
void add(Rows& rows, Rows more);

/// Tell on stderr what is being done, but only if the program runs for longer than two seconds.
void progress(const std::string& what);

}  // namespace mariotte::stiffness_study
