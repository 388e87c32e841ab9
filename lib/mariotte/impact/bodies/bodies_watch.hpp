// Looks at every step of a run of bodies: peaks of contacts, and samples.
#pragma once
#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/watch/due_samplings.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"

namespace mariotte::impact {

/// Largest values of one contact.
struct ContactPeaks {
  double force = 0, friction = 0, indentation = 0;
};

/// State of all bodies.
template <int D>
std::vector<BodyEnd> bodies_at(const model::Bodies& bodies, const model::BodiesSetting<D>& setting,
                               ConstState x);

/// Bodies, system and observers must outlive it.
template <int D>
class BodiesObserver final : public hybrid::PhaseObserver {
 public:
  BodiesObserver(const model::Bodies& bodies, const model::BodiesSystem<D>& system,
                 const model::BodiesMode& mode, const RunObserver& observers);

  void begin_phase(double time, ConstState x) override;
  void observe(const flow::Step& step) override;
  void passed(double time, Index events) override { tell(observers_, time, events); }
  bool gives_up() const override { return impact::gives_up(observers_); }
  void finish(double time, ConstState x);

  const std::vector<ContactPeaks>& peaks() const { return peaks_; }
  BodiesTrace take_trace() { return std::move(trace_); }

 private:
  void raise(std::size_t closed, const ContactPeaks& now);
  void read(ConstState x, std::vector<ContactPeaks>& list) const;
  void search(const flow::Step& step);
  void sample_forces(const flow::Step& step);
  int pieces_of(double duration) const;
  void sample(double time, ConstState x);

  const model::Bodies& bodies_;
  const model::BodiesSystem<D>& system_;
  const model::BodiesMode& mode_;
  const RunObserver& observers_;
  DueSamplings due_;
  double start_ = 0;
  std::vector<double> inside_;
  std::vector<flow::ForceSeries> forces_;
  std::vector<ContactPeaks> before_, middle_, after_, within_;  ///< of closed contacts
  std::vector<ContactPeaks> peaks_;
  BodiesTrace trace_;
};

}  // namespace mariotte::impact
