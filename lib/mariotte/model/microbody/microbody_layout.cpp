#include "mariotte/model/microbody/microbody_layout.hpp"

#include <algorithm>
#include <array>

namespace mariotte::model {

MicrobodyLayout microbody_layout(std::size_t tips, bool balance) {
  MicrobodyLayout layout{.place = {}, .size = 0, .tips = static_cast<Index>(tips)};
  const auto take = [&](Index& place, Index count) {
    place = layout.size;
    layout.size += count;
  };
  for (std::size_t i = 0; i < tips; ++i) take(layout.place.gap[i], 1);
  take(layout.place.position, 2);
  take(layout.place.velocity, 3);
  take(layout.place.attitude, 4);
  take(layout.place.momentum, 3);
  if (balance) take(layout.place.work, 3);
  return layout;
}

std::vector<double> initial_state(const DimensionlessMicrobody& body, const MicrobodyLayout& layout) {
  std::vector<double> x(layout.size, 0.0);
  std::copy(body.gap.begin(), body.gap.end(), x.begin() + layout.place.gap[0]);
  put(x, layout.place.velocity, body.velocity);
  put(x, layout.place.attitude, body.attitude);
  put(x, layout.place.momentum, body.momentum);
  return x;
}

std::vector<double> magnitudes(const DimensionlessMicrobody& body, const MicrobodyLayout& layout) {
  std::vector<double> size(layout.size, body.speed * body.time);
  const double least = std::min({body.body.inertia.e1, body.body.inertia.e2, body.body.inertia.e3});
  const double reach = norm(body.body.tips[0].centre) + body.body.tips[0].radius;
  const auto fill = [&](Index place, Index count, double value) {
    std::fill_n(size.begin() + place, count, value);
  };
  fill(layout.place.velocity, 3, body.speed);
  fill(layout.place.attitude, 4, std::min(1.0, body.speed * body.time / reach));
  fill(layout.place.momentum, 3, least * body.speed / reach);
  if (layout.place.work >= 0) fill(layout.place.work, 3, body.body.mass * body.speed * body.speed);
  return size;
}

std::string component_name(const MicrobodyLayout& layout, Index component) {
  const auto& p = layout.place;
  const std::array<std::pair<const char*, Index>, 6> parts = {{{"work", p.work},
                                                               {"angular momentum", p.momentum},
                                                               {"attitude", p.attitude},
                                                               {"velocity", p.velocity},
                                                               {"position", p.position},
                                                               {"gap", p.gap[0]}}};
  for (const auto& [name, place] : parts)
    if (place >= 0 && component >= place)
      return std::string(name) + " " + std::to_string(component - place + 1);
  return "component " + std::to_string(component + 1);
}

}  // namespace mariotte::model
