#include "mariotte/contact/named_laws.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "mariotte/contact/brach_dunn_law.hpp"
#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/contact/uncut.hpp"
#include "mariotte/contact/walton_braun.hpp"

namespace mariotte::contact {
namespace {

using Numbers = LawNumbers;

template <int kg, int m, int s>
constexpr Dimension fixed(double) {
  return {.kg = kg, .m = m, .s = s};
}

constexpr LawKey stiffness{"stiffness", &Numbers::stiffness, dimension::stiffness, "N/m^n"};
constexpr LawKey exponent{"exponent", &Numbers::exponent, fixed<0, 0, 0>, "", true};
constexpr LawKey damping{"damping", &Numbers::damping, dimension::damping, "N s/m^n"};
constexpr LawKey loading{"loading_stiffness", &Numbers::loading_stiffness, fixed<1, 0, -2>, "N/m"};
constexpr LawKey unloading{"unloading_stiffness", &Numbers::unloading_stiffness, fixed<1, 0, -2>, "N/m"};
constexpr LawKey modulus{"effective_modulus", &Numbers::effective_modulus, fixed<1, -1, -2>, "Pa"};
constexpr LawKey radius{"effective_radius", &Numbers::effective_radius, fixed<0, 1, 0>, "m"};
constexpr LawKey pressure{"yield_pressure", &Numbers::yield_pressure, fixed<1, -1, -2>, "Pa"};
constexpr LawKey adhesion{"work_of_adhesion", &Numbers::work_of_adhesion, fixed<1, 0, -2>, "J/m^2"};

constexpr LawKey damping_hertz{"damping_hertz", &Numbers::damping_hertz, fixed<0, -1, 1>, "s/m", true};
constexpr LawKey damping_adhesion{"damping_adhesion", &Numbers::damping_adhesion, fixed<0, -1, 1>, "s/m",
                                  true};

constexpr LawKey damped(Dimension (*unit)(double), std::string_view text, bool may_be_missing = false) {
  return {"damping", &Numbers::damping, unit, text, may_be_missing};
}
constexpr Dimension tsuji_damping(double) {
  return {.kg = 1, .m = -0.25, .s = -1};
}
constexpr Dimension dmt_damping(double) {
  return dimension::damping(1.5);
}

constexpr LawKey of_spring[] = {stiffness};
constexpr LawKey of_damped_spring[] = {stiffness, damping};
constexpr LawKey of_viscoelastic[] = {stiffness, exponent, damping};
constexpr LawKey of_hunt_crossley[] = {stiffness, exponent, damped(fixed<0, -1, 1>, "s/m")};
constexpr LawKey of_tsuji[] = {stiffness, damped(tsuji_damping, "N s/m^1.25")};
constexpr LawKey of_walton_braun[] = {loading, unloading};
constexpr LawKey of_thornton[] = {modulus, radius, pressure};
constexpr LawKey of_thornton_ning[] = {modulus, radius, pressure, adhesion};
constexpr LawKey of_jkr[] = {modulus, radius, adhesion, damped(fixed<1, -1, -1>, "N s/m^2", true)};
constexpr LawKey of_dmt[] = {modulus, radius, adhesion, damped(dmt_damping, "N s/m^1.5", true)};
constexpr LawKey of_brach_dunn[] = {modulus, radius, adhesion, damping_hertz, damping_adhesion};

Law power(const Numbers& n) {
  return PowerLaw{.stiffness = n.stiffness, .damping = n.damping, .exponent = n.exponent};
}
/// f + A df/dt of an elastic force k δⁿ has the damping n A k.
double retarded(double n) {
  return n;
}

constexpr NamedLaw laws[] = {
    {.name = "linear", .force = "k δ", .exponent = 1, .keys = of_spring, .make = power},
    {.name = "hertz", .force = "k δ^{3/2}", .exponent = 1.5, .keys = of_spring, .make = power},
    {.name = "viscoelastic",
     .force = "max(0, k δⁿ + c δⁿ⁻¹ δ̇)",
     .exponent = {},
     .keys = of_viscoelastic,
     .relaxation = retarded,
     .make = power},
    {.name = "kelvin-voigt",
     .force = "max(0, k δ + c δ̇)",
     .exponent = 1,
     .keys = of_damped_spring,
     .relaxation = retarded,
     .make = power},
    {.name = "kuwabara-kono",
     .force = "max(0, k δ^{3/2} + c √δ δ̇)",
     .exponent = 1.5,
     .keys = of_damped_spring,
     .relaxation = retarded,
     .make = power},
    {.name = "hunt-crossley",
     .force = "max(0, k δⁿ (1 + a δ̇))",
     .exponent = {},
     .keys = of_hunt_crossley,
     .make = [](const Numbers& n) -> Law {
       return std::make_shared<HuntCrossley>(n.stiffness, n.damping, n.exponent);
     }},
    {.name = "tsuji",
     .force = "max(0, k δ^{3/2} + c δ^{1/4} δ̇)",
     .exponent = 1.5,
     .keys = of_tsuji,
     .make = [](const Numbers& n) -> Law { return std::make_shared<Tsuji>(n.stiffness, n.damping); }},
    {.name = "walton-braun",
     .force = "k₁ δ, then k₂ (δ − δ_p)",
     .exponent = {},
     .keys = of_walton_braun,
     .make = [](const Numbers& n) { return state(WaltonBraun(n.loading_stiffness, n.unloading_stiffness)); }},
    {.name = "thornton",
     .force = "Hertz, cut off at p_y",
     .exponent = {},
     .keys = of_thornton,
     .make =
         [](const Numbers& n) {
           return state(Thornton(n.effective_modulus, n.effective_radius, n.yield_pressure));
         }},
    {.name = "thornton-ning",
     .force = "JKR, cut off at p_y",
     .exponent = {},
     .keys = of_thornton_ning,
     .make =
         [](const Numbers& n) {
           return state(
               ThorntonNing(n.effective_modulus, n.effective_radius, n.yield_pressure, n.work_of_adhesion));
         }},
    {.name = "jkr",
     .force = "4E* a³/(3R) − √(8πwE* a³) + η a δ̇",
     .exponent = {},
     .keys = of_jkr,
     .make =
         [](const Numbers& n) {
           return state(Jkr(n.effective_modulus, n.effective_radius, n.work_of_adhesion, n.damping));
         }},
    {.name = "dmt",
     .force = "4/3 E* √R δ^{3/2} − 2πwR + c √δ δ̇",
     .exponent = {},
     .keys = of_dmt,
     .make =
         [](const Numbers& n) {
           return state(Dmt(n.effective_modulus, n.effective_radius, n.work_of_adhesion, n.damping));
         }},
    {.name = "brach-dunn",
     .force = "4/3 E* √R δ^{3/2} (1 + C_H δ̇) − 2πf₀ √(Rδ) (1 − C_A δ̇)",
     .exponent = {},
     .keys = of_brach_dunn,
     .make =
         [](const Numbers& n) {
           return state(BrachDunnLaw(n.effective_modulus, n.effective_radius, n.work_of_adhesion,
                                     n.damping_hertz, n.damping_adhesion));
         }},
    {.name = "tabulated",
     .force = "monotone cubics through points",
     .exponent = {},
     .keys = {},
     .has_table = true,
     .make = [](const Numbers& n) -> Law { return std::make_shared<Tabulated>(n.points); }},
};

std::string list(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text += names[i];
  }
  return text;
}

}  // namespace

const std::span<const NamedLaw> named_laws(laws);

const LawKey* NamedLaw::find(std::string_view key) const {
  const auto place = std::find_if(keys.begin(), keys.end(), [&](const LawKey& k) { return k.key == key; });
  return place == keys.end() ? nullptr : &*place;
}

std::string names_of_laws() {
  std::vector<std::string_view> names;
  for (const auto& law : named_laws) names.push_back(law.name);
  return list(names);
}

std::string names_of_damped_laws() {
  std::vector<std::string_view> names;
  for (const auto& law : named_laws)
    if (law.damping()) names.push_back(law.name);
  return list(names);
}

Law uncut(Law law) {
  return std::make_shared<Uncut>(std::move(law));
}

const Law& cut(const Law& law) {
  const auto* uncut = dynamic_cast<const Uncut*>(branched(law));
  return uncut ? uncut->law() : law;
}

}  // namespace mariotte::contact
