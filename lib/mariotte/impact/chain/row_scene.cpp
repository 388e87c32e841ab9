#include "mariotte/impact/chain/row_scene.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/impact/chain/row_end.hpp"
#include "mariotte/impact/lane_scene.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

namespace mariotte::impact {
namespace {

constexpr double most_alike = 1e3;    ///< ratio of two masses
constexpr double farthest_gap = 1e6;  ///< over the natural length: flights beyond lose digits

bool is_hertz(const contact::Law& law) {
  const auto* power = contact::power_law(law);
  return power && power->exponent == 1.5 && power->damping == 0 && is_moderate(power->stiffness);
}

bool are_alike(const std::vector<double>& mass) {
  const auto [least, largest] = std::minmax_element(mass.begin(), mass.end());
  return is_moderate(*least) && is_moderate(*largest) && *largest <= most_alike * *least;
}

bool are_of_hertz(const model::Chain& chain) {
  return std::all_of(chain.law.begin(), chain.law.end(), is_hertz) && are_alike(chain.mass) &&
         std::all_of(chain.gap.begin(), chain.gap.end(), [](double gap) { return gap >= 0; }) &&
         chain.gravity == 0 && chain.drive.empty();
}

/// As of any chain [scaled_contacts.hpp]: the contact with the shortest natural time has the stiffness 1.
template <int most>
void scale(RowScene<most>& scene, NaturalRoot& natural_root) {
  int quickest = 0;
  const auto reduced_mass = [&](int j) { return scene.mass[j] / (1 + scene.mass[j] / scene.mass[j + 1]); };
  const auto slowness = [&](int j) { return reduced_mass(j) / scene.stiffness[j]; };
  for (int j = 1; j < scene.contacts(); ++j)
    if (slowness(j) < slowness(quickest)) quickest = j;
  auto& unit = scene.scale;
  scene.unit_stiffness = scene.stiffness[quickest];
  unit.mass = power_of_two_below(2 * reduced_mass(quickest));
  unit.velocity = power_of_two_below(scene.speed);
  unit.length = natural_root(unit.mass * unit.velocity * unit.velocity / scene.unit_stiffness, 1.5);
  unit.time = unit.length / unit.velocity;
}

/// What both kinds of rows have of contact j. True if its gap is not too wide.
template <int most, class Row>
bool fill(const RowScene<most>& scene, double accuracy, int j, Row& row) {
  const auto& unit = scene.scale;
  const double speed = scene.speed / unit.velocity, stiffness = scene.stiffness[j] / scene.unit_stiffness;
  row.own[j] = stiffness * (unit.mass / scene.mass[j] + unit.mass / scene.mass[j + 1]);
  row.weight[j] = flow::rough_root(row.own[j] / (speed * speed), 5);
  row.rate[j] = approach(scene, j);
  row.indentation[j] = -scene.gap[j] / unit.length;
  const double short_length = row.weight[j] * row.weight[j];
  row.same_instant = std::max(row.same_instant, accuracy / (speed * short_length));
  return -row.indentation[j] * short_length <= farthest_gap;
}

/// k/m of contact j and body i.
template <int most>
double push(const RowScene<most>& scene, int j, int i) {
  return scene.stiffness[j] / scene.unit_stiffness * (scene.scale.mass / scene.mass[i]);
}

}  // namespace

template <int most>
std::optional<RowScene<most>> row_scene(const model::Chain& chain, const hybrid::Options& options,
                                        NaturalRoot& natural_root) {
  const auto balls = std::ssize(chain.mass);
  if (balls < 3 || balls > most || !are_of_hertz(chain) || !asks_for_accuracy_alone(options))
    return std::nullopt;
  RowScene<most> scene{};
  scene.count = static_cast<int>(balls);
  std::copy_n(chain.mass.begin(), balls, scene.mass);
  std::copy_n(chain.velocity.begin(), balls, scene.velocity);
  for (int j = 0; j < scene.contacts(); ++j) {
    scene.stiffness[j] = contact::power_law(chain.law[j])->stiffness;
    scene.gap[j] = chain.gap[j];
  }
  scene.speed = model::speeds(chain).largest;
  if (!is_moderate(scene.speed)) return std::nullopt;
  scale(scene, natural_root);
  return scene;
}

template <int most>
void restore(const RowScene<most>& scene, model::Chain& chain) {
  chain.mass.assign(scene.mass, scene.mass + scene.balls());
  chain.velocity.assign(scene.velocity, scene.velocity + scene.balls());
  chain.gap.assign(scene.gap, scene.gap + scene.contacts());
  chain.law.resize(scene.contacts(), contact::Hertz(1));
  for (int j = 0; j < scene.contacts(); ++j) chain.law[j] = contact::Hertz(scene.stiffness[j]);
}

flow::Triplet dimensionless(const TripletScene& scene, double accuracy) {
  flow::Triplet t{};
  const double noise = model::noise_share(accuracy);
  t.noise_speed = noise * scene.speed / scene.scale.velocity;
  t.noise_root = 2 * flow::rough_root(noise, 2.5);
  for (int j = 0; j < 2; ++j) {
    if (!fill(scene, accuracy, j, t)) t.stage = flow::TripletStage::leaves;
    t.cross[j] = push(scene, 1 - j, 1);
  }
  if (t.stage != flow::TripletStage::leaves) begin(t);
  return t;
}

flow::ShortRow dimensionless(const ShortRowScene& scene, double accuracy) {
  flow::ShortRow row{.contacts = scene.contacts()};
  const double noise = model::noise_share(accuracy), noise_share_of_length = flow::rough_root(noise, 1.25);
  row.noise_speed = noise * scene.speed / scene.scale.velocity;
  for (int j = 0; j < row.contacts; ++j) {
    if (!fill(scene, accuracy, j, row)) row.stage = flow::RowStage::leaves;
    if (j > 0) row.from_left[j] = push(scene, j - 1, j);
    if (j + 1 < row.contacts) row.from_right[j] = push(scene, j + 1, j + 1);
    row.acts_above[j] = 0.5 * noise_share_of_length / (row.weight[j] * row.weight[j]);
  }
  if (row.stage != flow::RowStage::leaves) begin(row);
  return row;
}

bool describe(const TripletScene& scene, const flow::Triplet& row, double accuracy, BriefImpact& impact) {
  return row.stage == flow::TripletStage::over && tell(scene, row, accuracy, impact);
}
bool describe(const ShortRowScene& scene, const flow::ShortRow& row, double accuracy, BriefImpact& impact) {
  return row.stage == flow::RowStage::over && tell(scene, row, accuracy, impact);
}

template std::optional<TripletScene> row_scene(const model::Chain&, const hybrid::Options&, NaturalRoot&);
template std::optional<ShortRowScene> row_scene(const model::Chain&, const hybrid::Options&, NaturalRoot&);
template void restore(const TripletScene&, model::Chain&);
template void restore(const ShortRowScene&, model::Chain&);

}  // namespace mariotte::impact
