// Waves in a long chain at one glance: velocity over ball and time, as an image.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

/// Collects the samples for the image: of evenly spaced balls, at one interval, which doubles when there are
/// more than the image has rows, for about as long as a wave takes to cross the chain four times.
class Spacetime {
 public:
  explicit Spacetime(std::size_t balls);
  /// What to sample; lives as long as this.
  impact::Sampling sampling();
  /// Too few samples make no image.
  bool is_image() const { return rows_.size() > 2; }
  /// `spacetime.csv`: a matrix of velocities [m/s], one row per time, one column per chosen ball, with the
  /// numbers of the balls, from 1, as its head, and times in the unit of the picture before each row.
  std::string data() const;
  /// gnuplot commands that make `spacetime`.png and .svg from it, to follow `script_head`.
  std::string script(const std::string& title) const;

 private:
  double take(const impact::Sample& sample);
  double end() const;
  Display time_display() const;

  std::size_t balls_, stride_;
  double interval_ = 0;
  std::vector<std::vector<double>> rows_;
};

}  // namespace mariotte::report
