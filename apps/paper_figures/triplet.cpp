#include "triplet.hpp"

namespace mariotte::paper_figures {

model::Chain chain(const Triplet& triplet) {
  model::Chain chain = {
      .mass = {1, 1, 1}, .law = {}, .gap = {0, 0}, .velocity = {1, 0, triplet.third_velocity}};
  for (const double stiffness : {1.0, triplet.ratio})
    chain.law.push_back(triplet.law == "linear" ? contact::Law(contact::Linear{stiffness})
                                                : contact::Law(contact::Hertz{stiffness}));
  return chain;
}

}  // namespace mariotte::paper_figures
