# The public face: these headers are installed, may include each other and nothing else of the library, and
# make up mariotte/mariotte.hpp and mariotte/scene.hpp.
set(MARIOTTE_PUBLIC_HEADERS
  core/contact_direction.hpp
  core/cubic_curve.hpp
  core/damping.hpp
  core/dimension.hpp
  core/error.hpp
  core/fault.hpp
  core/overload.hpp
  core/quaternion.hpp
  core/scale.hpp
  core/signal_piece.hpp
  core/types.hpp
  core/vector3.hpp
  contact/brach_dunn.hpp
  contact/coulomb.hpp
  contact/custom_law.hpp
  contact/force.hpp
  contact/hertz.hpp
  contact/hunt_crossley.hpp
  contact/law.hpp
  contact/power_law.hpp
  flow/kind.hpp
  hybrid/ending.hpp
  hybrid/options.hpp
  model/bodies/bodies.hpp
  model/bodies/body_event.hpp
  model/chain/chain.hpp
  model/drives/drive.hpp
  model/drives/signal.hpp
  model/microbody/microbody.hpp
  model/microbody/rigid_body.hpp
  model/network/mass_matrix.hpp
  model/network/network.hpp
  impact/bodies/bodies_impact.hpp
  impact/bodies/first_impact.hpp
  impact/brief_impact.hpp
  impact/chain/chain_batch.hpp
  impact/chain/chain_impact.hpp
  impact/chain/chain_solver.hpp
  impact/course.hpp
  impact/flow_use.hpp
  impact/laws/configuration.hpp
  impact/laws/friction_laws.hpp
  impact/laws/frictional_contact.hpp
  impact/laws/icr_table.hpp
  impact/laws/law_outcome.hpp
  impact/laws/multiple_impact_law.hpp
  impact/laws/restitution.hpp
  impact/laws/rival_laws.hpp
  impact/microbody/capture_velocity.hpp
  impact/microbody/microbody_impact.hpp
  impact/microbody/microbody_batch.hpp
  impact/microbody/microbody_solver.hpp
  impact/network/network_impact.hpp
  impact/network/network_solver.hpp
  impact/sensitivity/parameter.hpp
  impact/sensitivity/sensitivity.hpp
  impact/sensitivity/slope_note.hpp
  impact/validity.hpp
  impact/watch/observers.hpp)

# Those of the component `scene`.
set(MARIOTTE_SCENE_HEADERS
  report/text.hpp
  scene/fault.hpp
  scene/figure.hpp
  scene/law.hpp
  scene/scene.hpp
  scene/simulate.hpp)

# mariotte_generate_headers(<folder>): mariotte/version.hpp, mariotte/mariotte.hpp and mariotte/scene.hpp.
function(mariotte_generate_headers folder)
  configure_file(mariotte/version.hpp.in ${folder}/mariotte/version.hpp @ONLY)
  mariotte_umbrella(${folder}/mariotte/mariotte.hpp mariotte::mariotte version.hpp ${MARIOTTE_PUBLIC_HEADERS})
  mariotte_umbrella(${folder}/mariotte/scene.hpp mariotte::scene ${MARIOTTE_SCENE_HEADERS})
endfunction()

function(mariotte_umbrella file component)
  set(includes ${ARGN})
  list(TRANSFORM includes REPLACE "(.+)" "#include \"mariotte/\\1\"")
  list(JOIN includes "\n" includes)
  configure_file(mariotte/umbrella.hpp.in ${file} @ONLY)
endfunction()
