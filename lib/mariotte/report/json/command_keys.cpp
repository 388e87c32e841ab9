#include "mariotte/report/json/command_keys.hpp"

namespace mariotte::report {
namespace {

using Key = CommandKey;

constexpr Key title{"title", "", "title of the scene"};

constexpr Key of_law[] = {
    {"status", "",
     "`admissible`, `tensile_impulse`, `penetrating_velocity`, `complex`, `no_impact` or `unfinished`"},
    title,
    {"model", "", "`law`"},
    {"reason", "", "why the outcome is not admissible; left out if it is"},
    {"final.velocity[]", "m/s",
     "velocities after the impact, in SI units of the scene where these differ; none of a complex outcome"},
    {"contacts[].impulse", "N s", "impulse of each contact; none of a complex outcome"},
    {"icr[]", "1", "impulse correlation ratios p_j/p_{j+1} of the law; null where p_{j+1} = 0"},
    {"impulse_direction[]", "1", "direction of all impulses, p_j/|p|"},
    {"energy.initial", "J", "kinetic energy before"},
    {"energy.final", "J", "kinetic energy after; null of a complex outcome"},
    {"energy.ratio", "1", "e = T⁺/T⁻ that the law was given"},
    {"energy.frame", "", "frame of e: `given` or `mass-centre`"},
    {"energy.ratio_lab", "1", "T⁺/T⁻ in the given frame; null where T⁻ = 0"},
    {"energy.ratio_centre", "1", "the same relative to the mass centre"},
    {"energy.least_ratio", "1", "least e for which there is an outcome"},
    {"simulated.velocity[]", "m/s", "velocities of the simulation that ratios and e come from, of a scene"},
    {"interpolation.velocity_error", "m/s", "bound on the error of the velocities, with `--table`"},
    {"restitution", "1", "of the other laws, with `--rivals`"},
    {"rivals[].name", "", "another law, with `--rivals`"},
    {"rivals[].status", "", "as that of the law"},
    {"rivals[].reason", "", "why its outcome is not admissible; left out if it is"},
    {"rivals[].velocity[]", "m/s", "its velocities after the impact"},
    {"rivals[].impulse[]", "N s", "its impulses, one per contact"},
    {"rivals[].ratio_lab", "1", "its T⁺/T⁻ in the given frame"},
    {"rivals[].ratio_centre", "1", "the same relative to the mass centre"},
};

constexpr Key of_friction_laws[] = {
    title,
    {"model", "", "`friction laws`"},
    {"between[]", "", "names of the two that touch first"},
    {"start", "s", "when they touch"},
    {"end", "s", "when they part"},
    {"friction", "1", "coefficient of friction"},
    {"response[][]", "1/kg", "velocity in the contact per impulse: along the normal, along the tangent"},
    {"before.gap_rate", "m/s", "rate of the gap when they touch, negative"},
    {"before.slip", "m/s", "velocity along the tangent when they touch"},
    {"before.energy", "J", "kinetic energy of all bodies when they touch"},
    {"laws[].name", "", "`simulation`, `newton`, `poisson`, `moreau` or `stronge`"},
    {"laws[].restitution", "1", "in the sense of the law; null of the simulation"},
    {"laws[].normal_impulse", "N s", "along the normal, on the second of the two"},
    {"laws[].tangential_impulse", "N s", "along the tangent, on the second of the two"},
    {"laws[].gap_rate", "m/s", "rate of the gap afterwards"},
    {"laws[].slip", "m/s", "velocity along the tangent afterwards"},
    {"laws[].loss", "J", "lost in the contact; negative where a law gains energy there"},
    {"laws[].energy", "J", "kinetic energy of all bodies afterwards"},
    {"laws[].energy_ratio", "1", "this energy over that before"},
    {"laws[].bodies[].velocity[]", "m/s", "of the mass centre afterwards, in the order of the scene"},
    {"laws[].bodies[].spin", "rad/s", "angular velocity afterwards"},
};

constexpr Key of_modes[] = {
    title,
    {"rest.force[]", "N", "force of each contact at rest"},
    {"rest.indentation[]", "m", "its indentation"},
    {"rest.stiffness[]", "N/m", "its stiffness there, ∂F/∂δ"},
    {"angular_frequency[]", "rad/s", "of each mode, the slowest first"},
    {"rigid_motions", "1", "modes without frequency, which are not listed"},
    {"shape[][]", "1",
     "by mode: displacements of all degrees of freedom, the largest is ±1; with `--shapes`"},
    {"band_edges.acoustic_top", "rad/s",
     "top of the band of an endless row of such balls; `band_edges` is left out of what is no such row"},
    {"band_edges.optical_bottom", "rad/s", "where a second band begins, of two balls in turn"},
    {"band_edges.optical_top", "rad/s", "where it ends"},
};

constexpr Key of_restitution[] = {
    title,
    {"law", "", "name of the law"},
    {"reduced_mass", "kg", "of the pair"},
    {"curve[].speed", "m/s", "speed of approach"},
    {"curve[].restitution", "1", "speed of separation over it"},
    {"curve[].closed_form", "1", "the same by a formula; null where none is known"},
};

constexpr Key of_capture[] = {
    title,
    {"capture_velocity", "m/s", "speed below which it stays, the middle of the two below"},
    {"captured", "m/s", "largest speed found at which it is captured"},
    {"separated", "m/s", "smallest speed found at which it separates"},
    {"runs", "1", "impacts simulated"},
};

constexpr Key of_fit[] = {
    title,
    {"data", "", "file of the measurements"},
    {"quantity", "", "what was measured: `restitution`, or the key of a result"},
    {"estimates[].key", "", "key of the scene"},
    {"estimates[].start", "SI", "its value in the scene, where the search starts"},
    {"estimates[].value", "SI", "its value by the measurements"},
    {"estimates[].standard_error", "SI", "of this value; null if the search has followed it down to zero"},
    {"estimates[].interval[]", "SI",
     "both ends of its confidence interval; 0 and null if they are beyond all numbers"},
    {"confidence", "1", "level of the intervals"},
    {"correlation[][]", "1", "of the logarithms of the values, by estimate and estimate"},
    {"rms", "SI", "root mean square of the residuals"},
    {"chi_square", "1", "sum of the squares of residual over deviation, which is 1 where the file has none"},
    {"degrees_of_freedom", "1",
     "measurements, but for those captured both as measured and by the fit, less estimates"},
    {"runs", "1", "impacts simulated"},
    {"runs_with_slopes", "1", "of them, those that carried exact slopes along"},
    {"warnings[]", "", "of values that the measurements hardly determine"},
    {"measurements[].line", "1", "its line in the file, from 1"},
    {"measurements[].settings.KEY", "SI", "what it sets for each key of the scene"},
    {"measurements[].measured", "SI", "the number that was measured"},
    {"measurements[].deviation", "SI", "its standard deviation; null if the file has none"},
    {"measurements[].predicted", "SI", "the same number by the fit"},
    {"measurements[].residual", "SI", "measured − predicted"},
    {"measurements[].captured", "", "whether the fit predicts a capture"},
};

constexpr Key of_uncertainty[] = {
    {"ending", "", "how the run ended, as above"},
    {"inputs[].key", "", "key of the scene that has a deviation"},
    {"inputs[].value", "SI", "its value"},
    {"inputs[].deviation", "SI", "its standard deviation"},
    {"outcomes[].name", "", "an outcome, as `velocity[0]`"},
    {"outcomes[].unit", "", "its unit"},
    {"outcomes[].value", "SI", "its value where all inputs have theirs; null if it is undefined"},
    {"outcomes[].deviation", "SI", "its standard deviation to first order; null where a slope is none"},
    {"outcomes[].share[]", "1", "share of each input in the square of that"},
    {"outcomes[].mean", "SI", "mean of the samples, with `--samples`"},
    {"outcomes[].sampled_deviation", "SI", "standard deviation of the samples, with `--samples`"},
    {"notes[]", "", "what is to be said of the slopes"},
    {"samples", "1", "runs with random inputs, with `--samples`"},
    {"seed", "1", "of these, with `--samples`"},
    {"others", "1",
     "samples that are left out, since they end in another way, have other contacts or make "
     "no scene; with `--samples`"},
};

constexpr CommandResult commands[] = {
    {"`mariotte law`", "Of balls, chains and networks. With `provenance`, as above.", of_law},
    {"`mariotte law` of bodies with friction", "Beside the first impact. With `provenance`, as above.",
     of_friction_laws},
    {"`mariotte modes`", "", of_modes},
    {"`mariotte restitution`", "", of_restitution},
    {"`mariotte capture`", "", of_capture},
    {"`mariotte fit`", "Also `fit.json` of `--out`. With `provenance`, as above.", of_fit},
    {"`mariotte uncertainty`", "", of_uncertainty},
};

}  // namespace

const std::span<const CommandResult> command_results(commands);

}  // namespace mariotte::report
