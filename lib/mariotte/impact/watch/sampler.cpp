#include "mariotte/impact/watch/sampler.hpp"

#include <algorithm>
#include <numeric>

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

void expect_no_samplings(const RunObserver& observers) {
  if (!observers.samplings.empty())
    throw InvalidParameter("only chains can be sampled while they are simulated");
}

SamplingObserver::SamplingObserver(const model::DimensionlessChain& chain, const RunObserver& observers)
    : chain_(chain), observers_(observers), next_(observers.samplings.size()) {
  sample_.natural_time = *std::min_element(chain.time.begin(), chain.time.end()) * chain.scale.time;
  sample_.crossing_time = std::accumulate(chain.time.begin(), chain.time.end(), 0.0) * chain.scale.time;
  for (const auto& sampling : observers.samplings) {
    check(sampling.balls, std::ssize(chain.mass), "ball");
    check(sampling.contacts, std::ssize(chain.law), "contact");
  }
}

double SamplingObserver::next_look() const {
  double next = infinity;
  for (const auto& time : next_) next = std::min(next, time.value);
  return next;
}

void SamplingObserver::look(model::Snapshot& run) {
  for (std::size_t i = 0; i < next_.size(); ++i)
    if (next_[i].value <= run.time()) take(run, i);
}

void SamplingObserver::look_last(model::Snapshot& run) {
  for (std::size_t i = 0; i < next_.size(); ++i) take(run, i);
}

void SamplingObserver::take(model::Snapshot& run, std::size_t which) {
  const auto& sampling = observers_.samplings[which];
  const auto& scale = chain_.scale;
  sample_.time = run.time() * scale.time;
  sample_.velocity.clear();
  sample_.gap.clear();
  sample_.force.clear();
  for (const Index i : sampling.balls) sample_.velocity.push_back(run.velocity(i) * scale.velocity);
  for (const Index j : sampling.contacts) {
    sample_.gap.push_back(run.gap(j) * scale.length);
    sample_.force.push_back(run.force(j) * scale.force());
  }
  const double wait = sampling.take(sample_);
  if (!(wait > 0)) throw InvalidParameter("the interval of a trace must be positive");
  next_[which] = next_[which] + wait / scale.time;
}

void SamplingObserver::passed(double time, Index events) {
  tell(observers_, time * chain_.scale.time, events);
}

}  // namespace mariotte::impact
