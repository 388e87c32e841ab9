#include "mariotte/model/chain/chain_layout.hpp"

namespace mariotte::model {

void make_layout(const DimensionlessChain& chain, ChainLayout& layout) {
  clear(layout);
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    layout.velocity.push_back(layout.size++);
    if (i == chain.law.size()) break;
    const bool wall = chain.inverse_mass[i] == 0 || chain.inverse_mass[i + 1] == 0;
    layout.gap.push_back(layout.size++);
    layout.work.push_back(contact::dissipates(chain.law[i]) ? layout.size++ : ChainLayout::absent);
    layout.impulse.push_back(wall || chain.is_faint[i] ? layout.size++ : ChainLayout::absent);
  }
  number_guards(chain.law, layout);
  add_drives(std::ssize(chain.drive), layout);
}

}  // namespace mariotte::model
