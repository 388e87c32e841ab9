#include "mariotte/scene/material_library.hpp"

namespace mariotte::scene {
namespace {

constexpr std::string_view aluminium_association =
    "Aluminum Association, typical values (as in MatWeb MA6061T6)";
constexpr std::string_view asm_316 = "ASM Material Data Sheet MQ316J, AISI 316, annealed bar";
constexpr std::string_view ball_maker =
    "data sheet of AISI 52100 chrome steel balls, through hardened to RC 60 to 67";
constexpr std::string_view make_it_from = "MakeItFrom.com, page of the material";

constexpr NamedMaterial materials[] = {
    {.name = "aluminium",
     .kind = "aluminium alloy 6061-T6",
     .young = {68.9e9, aluminium_association},
     .poisson = {0.33, "MatWeb MA6061T6, estimated from similar alloys"},
     .density = {2700, aluminium_association},
     .yield_strength = Sourced{276e6, aluminium_association}},
    {.name = "brass",
     .kind = "cartridge brass C26000, hard",
     .young = {110e9, make_it_from},
     .poisson = {0.31, make_it_from},
     .density = {8530, "Diversified Bronze, C26000: specific gravity 8.53"},
     .yield_strength = Sourced{434e6, "Diversified Bronze, C26000: 63 ksi, the hardest temper listed"}},
    {.name = "fused-silica",
     .kind = "fused silica, fused quartz",
     .young = {73e9, make_it_from},
     .poisson = {0.17, make_it_from},
     .density = {2203, "SciGlass database, mean (as in Wikipedia, List of physical properties of glass)"},
     .yield_strength = {}},
    {.name = "glass",
     .kind = "soda-lime float glass",
     .young = {70e9, make_it_from},
     .poisson = {0.23, make_it_from},
     .density = {2400, make_it_from},
     .yield_strength = {}},
    {.name = "polystyrene",
     .kind = "general purpose polystyrene",
     .young = {2.9e9, make_it_from},
     .poisson = {0.4, make_it_from},
     .density = {1050, "ASTM D792 value of GP-PS (DX, Polystyrene Specifications)"},
     .yield_strength =
         Sourced{83e6,
                 "Modern Plastics Encyclopedia 99: compressive strength, rupture or yield, 83 to 90 MPa; "
                 "in tension it breaks first"}},
    {.name = "stainless-steel",
     .kind = "austenitic stainless steel AISI 316, annealed",
     .young = {193e9, asm_316},
     .poisson = {0.28, "MakeItFrom.com, annealed AISI 316L"},
     .density = {8000, asm_316},
     .yield_strength = Sourced{240e6, asm_316}},
    {.name = "steel",
     .kind = "bearing steel AISI 52100 (100Cr6), hardened",
     .young = {203e9, ball_maker},
     .poisson = {0.3, "United Metal, SUJ2/52100: 0.27 to 0.30"},
     .density = {7830, ball_maker},
     .yield_strength = Sourced{2.03e9, ball_maker}},
    {.name = "tungsten-carbide",
     .kind = "cemented tungsten carbide",
     .young = {630e9, make_it_from},
     .poisson = {0.24, make_it_from},
     .density = {15000, make_it_from},
     .yield_strength = {}},
};

}  // namespace

std::span<const NamedMaterial> named_materials() {
  return materials;
}

}  // namespace mariotte::scene
