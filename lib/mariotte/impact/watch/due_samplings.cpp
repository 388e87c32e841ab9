#include "mariotte/impact/watch/due_samplings.hpp"

#include <numeric>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {
namespace {

void check(const std::vector<Index>& places, Index count, const char* what) {
  for (const Index place : places)
    if (place < 0 || place >= count)
      throw InvalidParameter(std::string(what) + " " + std::to_string(place + 1) +
                             " of a trace is not one of the " + std::to_string(count));
}

}  // namespace

DueSamplings::DueSamplings(const RunObserver& observers, const Scale& scale, Index velocities,
                           std::span<const double> contact_times)
    : observers_(observers), scale_(scale), next_(observers.samplings.size()) {
  sample_.natural_time = std::accumulate(contact_times.begin(), contact_times.end(), infinity,
                                         [](double a, double b) { return std::min(a, b); }) *
                         scale.time;
  sample_.crossing_time = std::accumulate(contact_times.begin(), contact_times.end(), 0.0) * scale.time;
  for (const auto& sampling : observers.samplings) {
    check(sampling.velocities, velocities, "velocity");
    check(sampling.contacts, std::ssize(contact_times), "contact");
  }
}

double DueSamplings::next() const {
  double next = infinity;
  for (const auto& time : next_) next = std::min(next, time.value);
  return next;
}

void DueSamplings::give(std::size_t which) {
  const double wait = observers_.samplings[which].take(sample_);
  if (!(wait > 0)) throw InvalidParameter("the interval of a trace must be positive");
  next_[which] = next_[which] + wait / scale_.time;
}

}  // namespace mariotte::impact
