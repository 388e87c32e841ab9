#include "mariotte/model/network/network_layout.hpp"

namespace mariotte::model {

void make_layout(const DimensionlessNetwork& network, ContactLayout& layout) {
  clear(layout);
  for (Index i = 0; i < network.dofs; ++i) layout.velocity.push_back(layout.size++);
  for (Index j = 0; j < network.contacts(); ++j) layout.gap.push_back(layout.size++);
  for (Index j = 0; j < network.contacts(); ++j) layout.impulse.push_back(layout.size++);
  for (const auto& law : network.law)
    layout.work.push_back(contact::dissipates(law) ? layout.size++ : ContactLayout::absent);
  number_guards(network.law, layout);
  add_drives(std::ssize(network.drive), layout);
}

}  // namespace mariotte::model
