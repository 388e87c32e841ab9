// Events and samples of a run as CSV, 17 significant digits, units in the header. Contacts and balls count
// from 1.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"

namespace mariotte::report {

/// `time [s],open,close`: one row per event; the contacts that open and close at that instant, separated by
/// spaces.
std::string events_csv(const impact::ContactImpact& impact);

/// `time [s],v1 [m/s],…,gap1 [m],…,force1 [N],…`: one row per sample; a gap is negative in contact.
/// Velocities of balls in the plane or in space are `v1x [m/s],v1y [m/s],…`; those of dofs of any kind are in
/// "SI".
std::string trace_csv(const impact::ContactImpact& impact);

/// The lines that such a table is made of, for chosen balls and contacts.
std::string trace_header(const std::vector<Index>& balls, const std::vector<Index>& contacts,
                         const std::string& velocity_unit = "m/s", Index dimension = 1);
std::string trace_row(double time, const std::vector<double>& velocity, const std::vector<double>& gap,
                      const std::vector<double>& force);

/// `time [s],open,close,stick,slip,force_sign,capture`: tips count from 1; a force sign of −1 says that tip 1
/// is pulled from now on.
std::string events_csv(const impact::MicrobodyImpact& impact);

/// `time [s]`, position, velocity, spin and quaternion of the body, and of each tip its gap, normal force,
/// friction and slip.
std::string trace_csv(const impact::MicrobodyImpact& impact);

/// `time [s]` and one column per kind of event, with the contacts as in the list of results, from 1.
std::string events_csv(const impact::BodiesImpact& impact);

/// `time [s]`; position, angle or quaternion, velocity and spin of each body; gap, normal force, friction and
/// slip of each contact, with the contacts as in the list of results.
std::string trace_csv(const impact::BodiesImpact& impact);

}  // namespace mariotte::report
