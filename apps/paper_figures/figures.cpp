#include "acary.hpp"
#include "cheng.hpp"
#include "figure.hpp"
#include "kharaz.hpp"
#include "law_curves.hpp"

namespace mariotte::paper_figures {

const std::vector<Figure>& figures() {
  static const auto all = [] {
    auto list = acary_forces();
    for (const auto& more : {acary_ratios(), acary_law(), cheng_spheres(), cheng_shapes(), cheng_histories(),
                             kharaz_oblique(), law_curves()})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

}  // namespace mariotte::paper_figures
