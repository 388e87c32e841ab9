#include "mariotte/report/figure/spacetime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/ticks.hpp"
#include "mariotte/report/figure/title.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_columns = 500, most_rows_of_image = 1000;

}  // namespace

Spacetime::Spacetime(std::size_t balls) : balls_(balls), stride_((balls + most_columns - 1) / most_columns) {}

impact::Sampling Spacetime::sampling() {
  impact::Sampling sampling{.take = [this](const impact::Sample& sample) { return take(sample); },
                            .restart = [this] { rows_.clear(), interval_ = 0; }};
  for (std::size_t i = 0; i < balls_; i += stride_) sampling.velocities.push_back(static_cast<Index>(i));
  return sampling;
}

double Spacetime::take(const impact::Sample& sample) {
  if (interval_ == 0) interval_ = sample.natural_time / 4;
  const double due = static_cast<double>(rows_.size()) * interval_;  // only the ending comes before
  if (sample.time > 4 * sample.crossing_time || sample.time < due - 0.5 * interval_) return infinity;
  if (rows_.size() == most_rows_of_image) {
    for (std::size_t i = 1; 2 * i < rows_.size(); ++i) rows_[i] = std::move(rows_[2 * i]);
    rows_.resize(rows_.size() / 2);
    interval_ *= 2;
  }
  rows_.push_back(sample.velocity);
  return interval_;
}

std::string Spacetime::data() const {
  const auto time = time_display();
  std::string text = "time [" + time.unit + "]";
  for (std::size_t i = 0; i < balls_; i += stride_) text += fmt::format(",{}", i + 1);
  text += "\n";
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    append_rounded(time.factor * interval_ * static_cast<double>(k), 10, text);
    for (const double velocity : rows_[k]) append_rounded(velocity, 6, text += ',');
    text += '\n';
  }
  return text;
}

double Spacetime::end() const {
  return interval_ * static_cast<double>(rows_.size());
}

Display Spacetime::time_display() const {
  return display_for(std::vector{end()}, "s");
}

std::string Spacetime::script(const std::string& title) const {
  std::vector<double> velocities;
  for (const auto& row : rows_) velocities.insert(velocities.end(), row.begin(), row.end());
  const auto time = time_display();
  const auto [slowest, fastest] = std::minmax_element(velocities.begin(), velocities.end());
  const auto speed = display_for(velocities, "m/s");
  std::string text = set_title(title);
  text += fmt::format("set xlabel 'ball i'\nset ylabel 'time t [{}]'\nset cblabel 'velocity v [{}]'\n",
                      time.unit, speed.unit);
  constexpr double numbers = 5;  // of six digits have room below the image
  const auto balls = static_cast<double>(balls_);
  text += fmt::format("set xrange [0.5:{}]\nset xtics {:g}\nset yrange [0:{:.8g}]\nset tics out nomirror\n",
                      balls + 0.5, tick_step(balls, numbers), time.factor * end());
  text += fmt::format("set cbrange [{:.6g}:{:.6g}]\nunset grid\n", speed.factor * *slowest,
                      speed.factor * *fastest);
  // An expression costs gnuplot more for each pixel than the rest of the picture.
  const auto scaled = speed.factor == 1 ? "" : fmt::format("using 1:2:({:g}*$3) ", speed.factor);
  return text + on_all_terminals(
                    "spacetime",
                    fmt::format("plot 'spacetime.csv' nonuniform matrix {}with image notitle\n", scaled),
                    one_column);
}

}  // namespace mariotte::report
