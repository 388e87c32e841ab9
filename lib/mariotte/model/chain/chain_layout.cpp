#include "mariotte/model/chain/chain_layout.hpp"

#include <cmath>

namespace mariotte::model {

void make_layout(const DimensionlessChain& chain, ChainLayout& layout) {
  clear(layout);
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    layout.velocity.push_back(layout.size++);
    if (i == chain.law.size()) break;
    const bool wall = std::isinf(chain.mass[i]) || std::isinf(chain.mass[i + 1]);
    layout.gap.push_back(layout.size++);
    layout.work.push_back(contact::dissipates(chain.law[i]) ? layout.size++ : ChainLayout::absent);
    layout.impulse.push_back(wall ? layout.size++ : ChainLayout::absent);
  }
  number_guards(chain.law, layout);
  add_drives(std::ssize(chain.drive), layout);
}

}  // namespace mariotte::model
